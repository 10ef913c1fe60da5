// SPDX-License-Identifier: Apache-2.0
#include "common/light/wide_lobe.h"

#include <cmath>

#include "common/light/ggx.h"

namespace boxlight {
namespace {

constexpr double kOpen = 1 - 1e-5;
constexpr double kFarBelow =
    -0.3;  ///< cosine of a block's middle from which on all of it is below the horizon
constexpr float kLeastCosine = 1e-4f;

double strength(dvec3 c) { return glm::dot(c, dvec3(0.2126, 0.7152, 0.0722)); }

/// The lobe's density over the cosine: D F G2 / (4 n.l n.v), of a direction of the light's map.
class Density {
 public:
  Density(const GgxLobe& lobe, double uOffset) : lobe_(lobe) {
    const double angle = -2.0 * kPiDouble * uOffset, c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](dvec3 d) { return dvec3(c * d.x + s * d.z, d.y, c * d.z - s * d.x); };
    frame_ = dmat3(turned(lobe.tangent), turned(lobe.bitangent), turned(lobe.normal));
    view_ = glm::normalize(vec3(glm::dot(lobe.view, lobe.tangent), glm::dot(lobe.view, lobe.bitangent),
                                glm::dot(lobe.view, lobe.normal)));
  }

  dvec3 normal() const { return frame_[2]; }
  dvec3 toWorld(dvec3 d) const {
    return glm::dmat3(lobe_.tangent, lobe_.bitangent, lobe_.normal) * (d * frame_);
  }

  dvec3 at(dvec3 direction) const {
    vec3 light(glm::normalize(direction) * frame_);
    light.z = std::max(light.z, kLeastCosine);
    const vec3 half = glm::normalize(view_ + light);
    Rgb fresnel = lobe_.f0 + (lobe_.f90 - lobe_.f0) * ggx::schlickWeight(glm::dot(view_, half));
    if (lobe_.filmed) fresnel = glm::clamp(fresnel, kLeastFilmed, 1.0f);
    return dvec3(fresnel) * double(ggx::distribution(half, lobe_.alpha)) *
           double(ggx::visibility(light, view_, lobe_.alpha));
  }

 private:
  const GgxLobe& lobe_;
  dmat3 frame_;  // columns: tangent, bitangent and normal, in the light map's directions
  vec3 view_;    // local
};

/// Sums over cells.
struct CellSums {
  const Density& density;
  dvec3 radiance{0.0}, direct{0.0}, all{0.0}, towards{0.0};

  void add(const LightCell& cell, double visible) {
    const dvec3 normal = density.normal();
    const double cosine = glm::dot(normal, cell.one);
    if (cosine > 0.0) {
      const dvec3 energy = cosine * density.at(cell.one);
      all += energy, direct += visible * energy;
      towards += (1 - visible) * strength(energy) * glm::normalize(cell.one);
    }
    addLight(cell.light, visible);
  }

  void addLight(const dmat3& light, double visible) {
    const dvec3 arriving = glm::max(density.normal() * light, dvec3(0.0));
    const dvec3 along = light * dvec3(0.2126, 0.7152, 0.0722);
    if (visible > 0.0 && strength(arriving) > 0.0 && glm::length(along) > 0.0)
      radiance += visible * arriving * density.at(along);
  }
};

/// In the world's directions.
Rectangle cellOf(uvec2 at, uvec2 count, double uOffset) {
  const dvec2 size = 1.0 / dvec2(count);
  const double u = at.x * size.x - uOffset;
  return {u - std::floor(u), at.y * size.y, size.x, size.y};
}

}  // namespace

VisibleCells::VisibleCells(const FilteredVisibility& visibility, double uOffset) {
  for (uint32_t i = 0; i < kHorizonCells.x * kHorizonCells.y; ++i)
    parts_.push_back(
        visiblePart(cellOf({i % kHorizonCells.x, i / kHorizonCells.x}, kHorizonCells, uOffset), visibility));
}

SeenLobe seeByCells(const GgxLobe& lobe, const FilteredVisibility& visibility, const VisibleCells& cells,
                    const LightMoments& light, double uOffset) {
  const Density density(lobe, uOffset);
  CellSums sums{density};
  constexpr uvec2 kBlocks = kHorizonCells / 2u;
  const bool merges = std::min(lobe.alpha.x, lobe.alpha.y) >= kMergedFrom;
  for (uint32_t i = 0; i < kBlocks.x * kBlocks.y; ++i) {
    const uvec2 at(i % kBlocks.x, i / kBlocks.x);
    const LightCell& block = light.block(at);
    if (glm::dot(density.normal(), glm::normalize(block.one)) < kFarBelow) continue;
    bool open = merges;
    for (uint32_t k = 0; k < 4; ++k) open = open && cells.part(2u * at + uvec2(k & 1, k >> 1)) >= kOpen;
    if (open) sums.add(block, 1.0);
    for (uint32_t k = 0; k < 4 && !open; ++k) {
      const uvec2 quarter = 2u * at + uvec2(k & 1, k >> 1);
      sums.add(light.cell(quarter), cells.part(quarter));
    }
  }
  for (const LightMoments::BrightTexel& bright : light.brightTexels())
    sums.addLight(bright.light, visiblePart(cellOf(bright.at, kMomentSize, uOffset), visibility));
  const dvec3 all = glm::max(sums.all, dvec3(1e-30));
  return {sums.radiance / all, std::max(1.0 - strength(sums.direct / all), 0.0),
          density.toWorld(sums.towards) / strength(all)};
}

SeenLobe seeByBoxes(const GgxLobe& lobe, const FilteredVisibility& visibility, const SummedArea& light,
                    double uOffset) {
  const ClippedLobe clipped = clipLobe(lobeBoxes(lobe), visibility);
  SeenLobe seen{.hidden = clipped.hidden, .towards = clipped.towards};
  for (const auto& [rectangle, energy] : clipped.pieces)
    seen.radiance += energy * light.integrate(rectangle, uOffset) / rectangle.solidAngle();
  return seen;
}

SeenLobe seeLobe(const GgxLobe& lobe, const FilteredVisibility& visibility, const VisibleCells& cells,
                 const SummedArea& light, double uOffset) {
  const float alpha = std::min(lobe.alpha.x, lobe.alpha.y);
  const double part = double(std::clamp((alpha - kWideFrom) / (kWideTo - kWideFrom), 0.0f, 1.0f));
  if (part <= 0) return seeByBoxes(lobe, visibility, light, uOffset);
  const SeenLobe byCells = seeByCells(lobe, visibility, cells, light.moments(), uOffset);
  if (part >= 1) return byCells;
  const SeenLobe byBoxes = seeByBoxes(lobe, visibility, light, uOffset);
  const auto mix = [part](auto a, auto b) { return a * (1 - part) + b * part; };
  return {mix(byBoxes.radiance, byCells.radiance), mix(byBoxes.hidden, byCells.hidden),
          mix(byBoxes.towards, byCells.towards)};
}

}  // namespace boxlight
