// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/texel_records.h"

#include <tbb/parallel_for.h>

#include "bake/transport/bsdf.h"
#include "common/light/ggx.h"

namespace boxlight {
namespace {

constexpr int kStrata = 4;  ///< per axis, of the points that the means of a record are taken over

void store(float (&target)[3], vec3 value) {
  for (int c = 0; c < 3; ++c) target[c] = value[c];
}

constexpr uint32_t kReachStream = 0xFFFF0000u;  ///< apart from every stream of a kernel

/// Means over points of a texel, and which lobes its materials have anywhere on it.
struct TexelMeans {
  TexelMeans(const Scene& scene, std::span<const FootprintPiece> footprint);
  vec3 direction(bool back) const;

  vec3 position{0.0f}, normal{0.0f}, geometric{0.0f};
  Rgb f0{0.0f};
  float roughness = 0, metallic = 0, sharpestAlpha = 1;
  uint32_t material = 0, glossyLobes = 0, unmirrored = 0;
  bool diffuse = false, transmits = false, mirrors = false, round = true, coated = false, doubleSided = false,
       volume = false;
};

TexelMeans::TexelMeans(const Scene& scene, std::span<const FootprintPiece> footprint) {
  constexpr float kShare = 1.0f / float(kStrata * kStrata);
  for (int i = 0; i < kStrata * kStrata; ++i) {
    const vec2 sample = (vec2(i % kStrata, i / kStrata) + 0.5f) / float(kStrata);
    const SurfacePoint point = sampleFootprint(footprint, sample);
    const SurfaceFrame frame = surfaceFrame(scene, point);
    const MaterialSample m = sampleMaterial(scene, point);
    const Bsdf bsdf(m, {0, 0, 1});
    position += kShare * frame.position;
    normal += shadingNormal(frame, m);
    geometric += frame.geometricNormal;
    f0 += kShare * bsdf.f0();
    roughness += kShare * m.roughness;
    metallic += kShare * m.metallic;
    material = scene.triangles[point.triangle].material;
    glossyLobes = std::max(glossyLobes, bsdf.viewDependentCount());
    unmirrored = std::max(unmirrored, bsdf.unmirroredCount());
    mirrors |= bsdf.has(kMirrored);
    coated |= bsdf.has(kCoat);
    sharpestAlpha = std::min(sharpestAlpha, bsdf.sharpestAlpha());
    round &= bsdf.alpha().x == bsdf.alpha().y;
    diffuse |= bsdf.has(kDiffuse);
    transmits |= bsdf.has(kDiffuseTransmit);
  }
  for (const FootprintPiece& piece : footprint) {
    const uint32_t flags = scene.materials[scene.triangles[piece.triangle].material].flags;
    doubleSided |= (flags & asset::kDoubleSided) != 0;
    volume |= (flags & asset::kVolume) != 0;
  }
}

/// Normals that cancel (a texel that folds over) leave no direction: any of its surface's will do.
vec3 TexelMeans::direction(bool back) const {
  vec3 mean = normal;
  if (glm::length(mean) < 1e-3f) mean = glm::length(geometric) > 1e-3f ? geometric : vec3(0, 1, 0);
  return (back ? -1.0f : 1.0f) * glm::normalize(mean);
}

RecordPlan planSide(const TexelMap& map, uint32_t level, uint32_t index, const TexelMeans& means, bool back) {
  const Texel& texel = map.level(level).texels[index];
  RecordPlan plan{.texel = index};
  asset::TexelRecord& record = plan.record;
  const vec3 normal = means.direction(back);
  vec3 tangent, bitangent;
  orthonormalBasis(normal, tangent, bitangent);
  store(record.position, means.position);
  store(record.normal, normal);
  store(record.tangent, tangent);
  store(record.f0, means.f0);
  record.material = means.material;
  record.roughness = means.roughness;
  record.metallic = means.metallic;
  record.flags = back ? asset::kBackSide : 0u;
  record.atlasX = texel.x;
  record.atlasY = texel.y;
  record.emissionSlot = asset::kNone;
  record.level = level;
  return plan;
}

bool fillsCells(const RecordPlan& plan, const TexelMeans& means) {
  return plan.glossyLobes == 1 && plan.unmirrored == 0 && means.round && !means.coated &&
         ggx::alphaOf(means.roughness) <= kMaxCellAlpha;
}

/// Of a split record's views: asset::viewSphereOf.
uint32_t viewSphereFor(const RecordPlan& plan, const TexelMeans& means) {
  uint32_t sphere = 0;
  for (uint32_t s = 0; s < kViewsByRoughness.size(); ++s)
    if (plan.unmirrored == 0 && means.sharpestAlpha >= kViewsByRoughness[s].leastAlpha) sphere = s + 1;
  return sphere;
}

/// The records of one texel: one or two.
std::vector<RecordPlan> planTexel(const Intersector& world, const TexelMap& map, uint32_t level,
                                  uint32_t index, asset::Scheme scheme, bool coarseViews) {
  const TexelMap& own = map.level(level);
  const TexelMeans means(world.scene(), own.footprint(own.texels[index]));
  std::vector<RecordPlan> plans = {planSide(map, level, index, means, false)};
  RecordPlan back = planSide(map, level, index, means, true);
  const bool backSeen =
      means.doubleSided &&
      PathTracer(world, {}).isReached(back.origin(world, map), {0, streamTexel(level, index), kReachStream});
  if (backSeen || means.transmits) plans.push_back(back);
  for (size_t side = 0; side < plans.size(); ++side) {
    const bool seen = side == 0 || backSeen, otherSeen = side == 1 || backSeen;
    plans[side].lambert = (seen && means.diffuse) || (otherSeen && means.transmits);
    plans[side].glossy = seen && means.glossyLobes > 0;
    plans[side].glossyLobes = means.glossyLobes;
    plans[side].unmirrored = means.unmirrored;
    const bool inside = side == 1 && means.volume;
    if (scheme == asset::Scheme::sketch || !plans[side].glossy || !means.mirrors || inside) continue;
    plans[side].record.flags |= asset::kSplitLobe;
    if (scheme == asset::Scheme::cells && fillsCells(plans[side], means))
      plans[side].record.flags |= asset::kDirectionCells;
    else if (coarseViews)
      plans[side].record.flags |= viewSphereFor(plans[side], means) << asset::kViewSphereShift;
  }
  return plans;
}

}  // namespace

PathOrigin RecordPlan::origin(const Intersector& world, const TexelMap& map) const {
  const TexelMap& own = map.level(record.level);
  const auto footprint = own.footprint(own.texels[texel]);
  const bool back = (record.flags & asset::kBackSide) != 0;
  return {footprint,
          back,
          {record.normal[0], record.normal[1], record.normal[2]},
          mediaAround(world, footprint, back)};
}

std::vector<RecordPlan> planRecords(const Intersector& world, const TexelMap& map, asset::Scheme scheme,
                                    bool coarseViews) {
  std::vector<RecordPlan> plans;
  for (uint32_t level = 0; level <= map.coarser.size(); ++level) {
    std::vector<std::vector<RecordPlan>> texels(map.level(level).texels.size());
    tbb::parallel_for(size_t(0), texels.size(), [&](size_t i) {
      texels[i] = planTexel(world, map, level, uint32_t(i), scheme, coarseViews);
    });
    for (const auto& sides : texels) plans.insert(plans.end(), sides.begin(), sides.end());
  }
  return plans;
}

std::vector<asset::AtlasTexel> indirection(const TexelMap& map, uint32_t level,
                                           const std::vector<RecordPlan>& records) {
  const TexelMap& own = map.level(level);
  std::vector<asset::AtlasTexel> sides(own.texels.size());
  for (uint32_t r = 0; r < records.size(); ++r) {
    if (records[r].record.level != level) continue;
    asset::AtlasTexel& texel = sides[records[r].texel];
    (records[r].record.flags & asset::kBackSide ? texel.back : texel.front) = r;
  }
  std::vector<asset::AtlasTexel> atlas(own.nearest.size());
  for (size_t i = 0; i < atlas.size(); ++i)
    if (own.nearest[i] != asset::kNone) atlas[i] = sides[own.nearest[i]];
  return atlas;
}

}  // namespace boxlight
