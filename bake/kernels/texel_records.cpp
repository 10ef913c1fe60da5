// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/texel_records.h"

#include "bake/transport/bsdf.h"

namespace boxlight {
namespace {

constexpr int kStrata = 4;  ///< per axis, of the points that the means of a record are taken over

void store(float (&target)[3], vec3 value) {
  for (int c = 0; c < 3; ++c) target[c] = value[c];
}

RecordPlan planRecord(const Scene& scene, const TexelMap& map, uint32_t index, bool back) {
  const Texel& texel = map.texels[index];
  RecordPlan plan{{}, index, false, false};
  vec3 position(0.0f), normal(0.0f), geometric(0.0f);
  Rgb f0(0.0f);
  float roughness = 0, metallic = 0;
  for (int i = 0; i < kStrata * kStrata; ++i) {
    const vec2 sample = (vec2(i % kStrata, i / kStrata) + 0.5f) / float(kStrata);
    const SurfacePoint point = sampleFootprint(map.footprint(texel), sample);
    const SurfaceFrame frame = surfaceFrame(scene, point);
    const MaterialSample material = sampleMaterial(scene, point);
    const Bsdf bsdf(material);
    const float share = 1.0f / float(kStrata * kStrata);
    position += share * frame.position;
    normal += shadingNormal(frame, material);
    geometric += frame.geometricNormal;
    f0 += share * bsdf.f0();
    roughness += share * material.roughness;
    metallic += share * material.metallic;
    plan.lambert |= bsdf.hasDiffuse();
    plan.glossy |= bsdf.hasGlossy();
    plan.record.material = scene.triangles[point.triangle].material;
  }
  // Normals that cancel (a texel that folds over) leave no direction: any of its surface's will do.
  if (glm::length(normal) < 1e-3f) normal = glm::length(geometric) > 1e-3f ? geometric : vec3(0, 1, 0);
  normal = (back ? -1.0f : 1.0f) * glm::normalize(normal);
  vec3 tangent, bitangent;
  orthonormalBasis(normal, tangent, bitangent);
  store(plan.record.position, position);
  store(plan.record.normal, normal);
  store(plan.record.tangent, tangent);
  store(plan.record.f0, f0);
  plan.record.roughness = roughness;
  plan.record.metallic = metallic;
  plan.record.flags = back ? asset::kBackSide : 0u;
  plan.record.atlasX = texel.x;
  plan.record.atlasY = texel.y;
  plan.record.emissionSlot = asset::kNone;
  return plan;
}

bool isDoubleSided(const Scene& scene, const TexelMap& map, const Texel& texel) {
  for (const FootprintPiece& piece : map.footprint(texel))
    if (scene.materials[scene.triangles[piece.triangle].material].flags & asset::kDoubleSided) return true;
  return false;
}

}  // namespace

PathOrigin RecordPlan::origin(const TexelMap& map) const {
  return {map.footprint(map.texels[texel]),
          (record.flags & asset::kBackSide) != 0,
          {record.normal[0], record.normal[1], record.normal[2]}};
}

std::vector<RecordPlan> planRecords(const Scene& scene, const TexelMap& map) {
  std::vector<RecordPlan> plans;
  for (uint32_t i = 0; i < map.texels.size(); ++i) {
    plans.push_back(planRecord(scene, map, i, false));
    if (isDoubleSided(scene, map, map.texels[i])) plans.push_back(planRecord(scene, map, i, true));
  }
  return plans;
}

std::vector<asset::AtlasTexel> indirection(const TexelMap& map, const std::vector<RecordPlan>& records) {
  std::vector<asset::AtlasTexel> sides(map.texels.size());
  for (uint32_t r = 0; r < records.size(); ++r) {
    asset::AtlasTexel& texel = sides[records[r].texel];
    (records[r].record.flags & asset::kBackSide ? texel.back : texel.front) = r;
  }
  std::vector<asset::AtlasTexel> atlas(map.nearest.size());
  for (size_t i = 0; i < atlas.size(); ++i)
    if (map.nearest[i] != asset::kNone) atlas[i] = sides[map.nearest[i]];
  return atlas;
}

}  // namespace boxlight
