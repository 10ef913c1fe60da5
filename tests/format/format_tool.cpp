// SPDX-License-Identifier: Apache-2.0
// What the C++ side of the format's agreement test needs:
//   format_tool sample OUT.ptb [split|cells|cosine|coarse]
//     write a small asset with a value of its own in every field
//   format_tool dump ASSET.ptb [EVERY]
//     print all values as JSON, one table a line; of texels, maps and pages, every EVERYth
#include <cstdlib>
#include <iterator>
#include <string_view>

#include "common/asset/asset_reader.h"
#include "common/asset/finding.h"
#include "common/light/view_sphere.h"
#include "tests/format/sample_asset.h"

namespace boxlight::asset {
namespace {

/// A JSON array of numbers. A float prints as the double it is, so that no digit is lost.
class Row {
 public:
  template <class... Fields>
  explicit Row(const Fields&... fields) {
    text_ += '[';
    (add(fields), ...);
    text_.back() = ']';
  }
  const std::string& text() const { return text_; }

 private:
  void add(float value) { fmt::format_to(std::back_inserter(text_), "{},", double(value)); }
  template <std::integral T>
  void add(T value) {
    fmt::format_to(std::back_inserter(text_), "{},", value);
  }
  template <class E>
  requires std::is_enum_v<E>
  void add(E value) { add(uint32_t(value)); }
  template <class T, size_t N>
  void add(const T (&values)[N]) {
    for (const T& value : values) add(value);
  }
  void add(const VisibilityMap& map) {
    for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
      for (const uint32_t word : map.row(y)) add(word);
  }
  void add(const TextureRef& reference) {
    add(reference.texture);
    add(reference.texcoord);
    add(reference.transform);
  }
  void add(vec3 v) {
    for (int axis = 0; axis < 3; ++axis) add(v[axis]);
  }
  void add(uvec3 v) {
    for (int corner = 0; corner < 3; ++corner) add(v[corner]);
  }

  std::string text_;
};

template <class T, class F>
void printTable(std::string_view name, const std::vector<T>& table, F&& toRow) {
  fmt::print("{{\"name\":\"{}\",\"rows\":[", name);
  for (size_t i = 0; i < table.size(); ++i) fmt::print("{}{}", i ? "," : "", toRow(table[i]).text());
  fmt::print("]}}\n");
}

Row toRow(const ChunkEntry& e) { return Row(e.type, e.codec, e.offset, e.storedSize, e.rawSize, e.hash); }
Row toRow(const Info& i) {
  return Row(i.atlasWidth, i.atlasHeight, i.viewFrequency, i.viewCount, i.vertexCount, i.triangleCount,
             i.materialCount, i.textureCount, i.recordCount, i.tileCount, i.boundsMin, i.boundsMax);
}
Row toRow(const Vertex& v) {
  return Row(v.position, v.normal, v.tangent, v.atlasUv, v.uv[0], v.uv[1], v.color);
}
Row toRow(const Triangle& t) { return Row(t.vertex, t.material); }
Row toRow(const Material& m) {
  return Row(m.baseColor, m.metallic, m.roughness, m.normalScale, m.alphaCutoff, m.specular, m.specularColor,
             m.flags, m.baseColorTexture, m.metallicRoughnessTexture, m.normalTexture, m.specularTexture,
             m.specularColorTexture);
}
Row toRow(const MaterialExtension& x) {
  return Row(x.ior, x.anisotropy, x.anisotropyRotation, x.clearcoat, x.clearcoatRoughness,
             x.clearcoatNormalScale, x.sheenColor, x.sheenRoughness, x.transmission, x.diffuseTransmission,
             x.diffuseTransmissionColor, x.iridescence, x.iridescenceIor, x.iridescenceThickness, x.emissive,
             x.absorption, x.scattering, x.scatterAnisotropy, x.anisotropyTexture, x.clearcoatTexture,
             x.clearcoatRoughnessTexture, x.clearcoatNormalTexture, x.sheenColorTexture,
             x.sheenRoughnessTexture, x.transmissionTexture, x.diffuseTransmissionTexture,
             x.diffuseTransmissionColorTexture, x.iridescenceTexture, x.iridescenceThicknessTexture,
             x.emissiveTexture);
}
Row toRow(const TextureTransform& t) { return Row(t.rows[0], t.rows[1]); }
Row toRow(const Texture& t) {
  return Row(t.width, t.height, t.firstTexel, t.wrapS, t.wrapT, t.srgb, t.magNearest, t.minFilter);
}
Row toRow(const AtlasTexel& t) { return Row(t.front, t.back); }
Row toRow(const TexelRecord& r) {
  return Row(r.position, r.flags, r.normal, r.material, r.tangent, r.roughness, r.f0, r.metallic, r.atlasX,
             r.atlasY, r.emissionSlot, r.level);
}
Row toRow(const Tile& t) { return Row(t.firstRecord, t.recordCount, t.glossyBoxes, t.diffuseBoxes); }
Row toRow(const VisibilityMap& map) { return Row(map); }
Row toRow(const GeodesicSphere& sphere) { return Row(sphere.frequency, sphere.count); }
Row toRow(const PackedBox& packed) {
  if (isEmission(packed)) return Row(packed.kind, unpackEmission(packed));
  if (isHiddenPart(packed)) return Row(packed.kind, unpackHiddenPart(packed));
  const Box box = unpackBox(packed);
  if (isCosineBox(packed)) return Row(packed.kind, box.u0, box.v0, box.du, box.dv, box.energy.x);
  return Row(packed.kind, box.u0, box.v0, box.du, box.dv, box.energy);
}

template <class T>
void printTable(std::string_view name, const std::vector<T>& table) {
  printTable(name, table, [](const T& entry) { return toRow(entry); });
}

template <class T>
std::vector<T> everyNth(const std::vector<T>& table, uint64_t every) {
  std::vector<T> some;
  for (size_t i = 0; i < table.size(); i += every) some.push_back(table[i]);
  return some;
}

void printTexels(const std::vector<uint32_t>& texels) {
  printTable("TEXD", texels, [](uint32_t t) { return Row(t & 255, t >> 8 & 255, t >> 16 & 255, t >> 24); });
}

void printSphere(const std::string& name, uint32_t frequency) {
  const ViewSphere sphere(frequency);
  printTable(name + "s", sphere.directions(), [](vec3 direction) { return Row(direction); });
  printTable(name + "Triangles", sphere.triangles(), [](uvec3 triangle) { return Row(triangle); });
}

void printPages(const AssetReader& reader, uint64_t every) {
  const Asset& asset = reader.asset();
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile) {
      if ((uint64_t(stream) * asset.tiles.size() + tile) % every != 0) continue;
      printTable(fmt::format("page {} {}", stream, tile), reader.page(stream, tile));
    }
}

void dump(const char* path, uint64_t every) {
  const AssetReader reader(path);
  const Asset& asset = reader.asset();
  const FileHeader& h = reader.header();
  fmt::print("{{\"name\":\"PROV\",\"rows\":{}}}\n", asset.provenance.dump());
  printTable("header", std::vector{h}, [](const FileHeader& f) {
    return Row(f.majorVersion, f.minorVersion, f.scheme, f.chunkCount, f.fileSize, f.headHash);
  });
  printTable("chunks", reader.chunks());
  printTable("INFO", std::vector{asset.info});
  printTable("VERT", asset.vertices);
  printTable("TRIS", asset.triangles);
  printTable("MATL", asset.materials);
  printTable("MATX", asset.materialExtensions);
  printTable("TXFM", asset.textureTransforms);
  printTable("TEXI", asset.textures);
  printTexels(everyNth(asset.texels, every));
  printTable("ATLS", asset.atlas);
  printTable("levl", asset.atlasLevels);
  printTable("RECS", asset.records);
  printTable("TILE", asset.tiles);
  printTable("VISI", everyNth(asset.visibilityMaps, every));
  printTable("CELL", asset.cellSphere);
  printTable("VIEW", asset.coarseViews);
  printTable("MASK", asset.streamMasks, [](uint64_t mask) { return Row(mask); });
  printSphere("view", asset.info.viewFrequency);
  for (const GeodesicSphere& sphere : asset.cellSphere) printSphere("cell", sphere.frequency);
  for (const GeodesicSphere& sphere : asset.coarseViews)
    printSphere(fmt::format("{} view", sphere.count), sphere.frequency);
  printPages(reader, every);
}

}  // namespace
}  // namespace boxlight::asset

int main(int argc, char** argv) try {
  const std::string_view command = argc >= 3 ? argv[1] : "";
  const std::string_view option = argc >= 4 ? argv[3] : "";
  const auto isOneOf = [&](auto... names) { return ((option == names) || ...); };
  if (command == "sample" && (argc == 3 || isOneOf("split", "cells", "cosine", "coarse"))) {
    boxlight::asset::makeSample({.viewFrequency = 3,
                                 .records = 150,
                                 .recordsPerTile = 64,
                                 .split = isOneOf("split", "cells", "coarse"),
                                 .cells = option == "cells",
                                 .cosine = option == "cosine",
                                 .coarse = option == "coarse"})
        .write(argv[2]);
  } else if (command == "dump") {
    boxlight::asset::dump(argv[2], argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  } else {
    fmt::print(stderr,
               "usage: format_tool sample OUT.ptb [split|cells|cosine|coarse] | dump ASSET.ptb [EVERY]\n");
    return 1;
  }
  return 0;
} catch (const boxlight::Error& error) {
  fmt::print(stderr, "format_tool: {}\n", error.what());
  return int(error.code());
}
