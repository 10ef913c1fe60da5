// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>

#include "common/asset/asset_checks.h"
#include "common/asset/number_checks.h"

namespace boxlight::asset {
namespace {

using enum FindingCode;

void checkVertex(const Asset& asset, const ChunkSet& present, uint32_t index, const Reporter& report) {
  const Vertex& v = asset.vertices[index];
  const auto bad = [&](FindingCode code, const char* what) {
    report(code, chunk::kVertices, fmt::format("vertex {}", index), "{}", what);
  };
  if (!allFinite(std::bit_cast<std::array<float, sizeof(Vertex) / sizeof(float)>>(v)))
    return bad(notFinite, "NaN or infinite");
  if (!isUnit(v.normal)) bad(vertexFrame, "the normal is not unit");
  if (!isUnit(std::span(v.tangent).first<3>())) bad(vertexFrame, "the tangent is not unit");
  if (v.tangent[3] != 1.0f && v.tangent[3] != -1.0f) bad(vertexFrame, "the bitangent's sign is not +1 or -1");
  if (!isFraction(v.atlasUv[0]) || !isFraction(v.atlasUv[1])) bad(vertexAtlasUv, "atlasUv outside [0,1]");
  if (!present.has({chunk::kInfo})) return;
  const Info& info = asset.info;
  for (int axis = 0; axis < 3; ++axis)
    if (v.position[axis] < info.boundsMin[axis] || v.position[axis] > info.boundsMax[axis])
      return bad(bounds, "outside the bounds in INFO");
}

void checkMaterial(const Asset& asset, const ChunkSet& present, size_t index, const Reporter& report) {
  const Material& m = asset.materials[index];
  const auto bad = [&](FindingCode code, const char* what) {
    report(code, chunk::kMaterials, fmt::format("material {}", index), "{}", what);
  };
  const std::array single = {m.metallic, m.roughness, m.normalScale, m.alphaCutoff, m.specular};
  if (!allFinite(m.baseColor) || !allFinite(single) || !allFinite(m.specularColor))
    bad(notFinite, "NaN or infinite");
  const std::array fractions = {m.baseColor[0], m.baseColor[1], m.baseColor[2], m.baseColor[3],
                                m.metallic,     m.roughness,    m.specular};
  if (!std::all_of(fractions.begin(), fractions.end(), isFraction))
    bad(materialValue, "baseColor, metallic, roughness or specular outside [0,1]");
  const std::array positive = {m.alphaCutoff, m.specularColor[0], m.specularColor[1], m.specularColor[2]};
  if ((m.flags & kAlphaMask) && (m.flags & kAlphaBlend))
    bad(materialValue, "both alpha mask and alpha blend");
  if (std::any_of(positive.begin(), positive.end(), [](float value) { return value < 0.0f; }))
    bad(materialValue, "alphaCutoff or specularColor below 0");
  if ((m.flags & ~uint32_t(kKnownFlags)) != 0 || m.reserved != 0)
    bad(reserved, "unknown flags or reserved field");
  checkReferences(asset, present, m, fmt::format("material {}", index), report);
}

}  // namespace

void checkMesh(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  for (uint32_t i = 0; i < asset.vertices.size(); ++i) checkVertex(asset, present, i, report);
  for (size_t i = 0; i < asset.triangles.size(); ++i) {
    const Triangle& triangle = asset.triangles[i];
    for (const uint32_t vertex : triangle.vertex)
      if (present.has({chunk::kVertices}) && vertex >= asset.vertices.size())
        report(triangleVertex, chunk::kTriangles, fmt::format("triangle {}", i), "vertex {} of {}", vertex,
               asset.vertices.size());
    if (present.has({chunk::kMaterials}) && triangle.material >= asset.materials.size())
      report(triangleMaterial, chunk::kTriangles, fmt::format("triangle {}", i), "material {} of {}",
             triangle.material, asset.materials.size());
  }
}

void checkMaterials(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  for (size_t i = 0; i < asset.materials.size(); ++i) checkMaterial(asset, present, i, report);
}

void checkTextures(const Asset& asset, const ChunkSet& present, const Reporter& report) {
  for (size_t i = 0; i < asset.textures.size(); ++i) {
    const Texture& t = asset.textures[i];
    const std::string place = fmt::format("texture {}", i);
    if (t.width < 1 || t.width > kMaxTextureSize || t.height < 1 || t.height > kMaxTextureSize) {
      report(limits, chunk::kTextures, place, "{}x{}, allowed are 1 to {}", t.width, t.height,
             kMaxTextureSize);
      continue;
    }
    const uint64_t texels = uint64_t(t.width) * t.height, available = asset.texels.size();
    if (present.has({chunk::kTexels}) && (t.firstTexel > available || available - t.firstTexel < texels))
      report(textureLayout, chunk::kTextures, place, "{} texels from {}, TEXD has {}", texels, t.firstTexel,
             available);
    if (uint32_t(t.wrapS) > uint32_t(Wrap::mirroredRepeat) ||
        uint32_t(t.wrapT) > uint32_t(Wrap::mirroredRepeat) || t.srgb > 1 || t.magNearest > 1 ||
        t.minFilter > 2)
      report(textureLayout, chunk::kTextures, place, "wrap {} {}, srgb {}, magNearest {}, minFilter {}",
             uint32_t(t.wrapS), uint32_t(t.wrapT), t.srgb, t.magNearest, t.minFilter);
  }
}

}  // namespace boxlight::asset
