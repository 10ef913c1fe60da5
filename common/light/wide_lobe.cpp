// SPDX-License-Identifier: Apache-2.0
#include "common/light/wide_lobe.h"

#include <cmath>

#include "common/light/ggx.h"

namespace boxlight {
namespace {

constexpr double kOpen = 1 - 1e-5;
constexpr float kLeastCosine = 1e-4f;
constexpr double kCellRadius = 0.75;  ///< over its height
constexpr double kRowHeight = kPiDouble / kMomentSize.y;
constexpr uint32_t kMostHiddenLevel = 3;  ///< of cells that may be hidden in part

double strength(dvec3 c) { return glm::dot(c, dvec3(0.2126, 0.7152, 0.0722)); }

/// The lobe's density over the cosine, D F G2 / (4 n.l n.v), in directions of the light's map.
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

  /// Of the half vector to a direction: D.
  double distribution(dvec3 direction) const {
    return double(ggx::distribution(halfVector(local(direction)), lobe_.alpha));
  }

  /// F G2 / (4 n.l n.v).
  dvec3 shadowedFresnel(dvec3 direction) const {
    vec3 light = local(direction);
    const vec3 half = halfVector(light);
    light.z = std::max(light.z, 0.0f);
    Rgb fresnel = lobe_.f0 + (lobe_.f90 - lobe_.f0) * ggx::schlickWeight(glm::dot(view_, half));
    if (lobe_.filmed) fresnel = glm::clamp(fresnel, kLeastFilmed, 1.0f);
    return dvec3(fresnel) * double(ggx::visibility(light, view_, lobe_.alpha));
  }

  /// Does the lobe vary little enough in a cell of this height around a direction?
  bool resolves(dvec3 direction, double height) const {
    const vec3 half = halfVector(local(direction));
    const auto facing = std::max(double(glm::dot(view_, half)), kLeastFacing);
    const double reach = kCellRadius * height / (2 * facing);
    const dvec2 nearest = glm::max(glm::abs(dvec2(half) / double(half.z)) - reach, dvec2(0.0));
    const dvec2 slope = nearest / dvec2(lobe_.alpha);
    const auto alpha = double(std::min(lobe_.alpha.x, lobe_.alpha.y));
    return height <= kCellsToLobe * 2 * facing * alpha * std::sqrt(1 + glm::dot(slope, slope));
  }

 private:
  static constexpr double kLeastFacing = 0.02;
  vec3 local(dvec3 direction) const { return vec3(glm::normalize(direction) * frame_); }
  vec3 halfVector(vec3 light) const {
    return glm::normalize(view_ + vec3(light.x, light.y, std::max(light.z, kLeastCosine)));
  }

  const GgxLobe& lobe_;
  dmat3 frame_;  // columns: tangent, bitangent and normal, in the light map's directions
  vec3 view_;    // local
};

/// Sums over cells.
struct CellSums {
  const Density& density;
  dvec3 radiance{0.0}, direct{0.0}, all{0.0}, towards{0.0};

  void add(const LightCell& cell, double visible) {
    const dvec3 shadowed = density.shadowedFresnel(cell.one);
    const double cosine = std::max(glm::dot(density.normal(), cell.one), 0.0);
    const dvec3 energy = cosine * density.distribution(cell.one) * shadowed;
    all += energy, direct += visible * energy;
    towards += (1 - visible) * strength(energy) * glm::normalize(cell.one);
    addLight(cell.light, visible, shadowed);
  }

  void addBright(const dmat3& light, double visible) {
    const dvec3 direction = strongest(light);
    if (glm::dot(density.normal(), direction) > 0.0)
      addLight(light, visible, density.shadowedFresnel(direction));
  }

 private:
  static dvec3 strongest(const dmat3& light) { return light * dvec3(0.2126, 0.7152, 0.0722); }

  void addLight(const dmat3& light, double visible, dvec3 shadowed) {
    const dvec3 arriving = glm::max(density.normal() * light, dvec3(0.0)), towardsIt = strongest(light);
    if (strength(arriving) > 0.0 && glm::length(towardsIt) > 0.0)
      radiance += visible * density.distribution(towardsIt) * arriving * shadowed;
  }
};

/// Adds the cells of one tree.
void addTree(uint32_t root, const VisibleCells& cells, const LightMoments& light, CellSums& sums) {
  const TreeCell whole{root};
  const bool open = cells.part(whole) >= kOpen;
  for (TreeCell at = whole; !at.isEnd();) {
    const LightCell cell = light.tree().cell(at);
    const double height = kRowHeight * at.rows();
    const dvec3 direction = glm::normalize(cell.one);
    const bool below = glm::dot(sums.density.normal(), direction) < -kCellRadius * height;
    const bool small =
        at.level == 0 || ((open || at.level <= kMostHiddenLevel) && sums.density.resolves(direction, height));
    if (!below && !small) {
      at.enter();
      continue;
    }
    if (!below) sums.add(cell, open ? 1.0 : cells.part(at));
    at.pass();
  }
}

}  // namespace

VisibleCells::VisibleCells(const FilteredVisibility& visibility, double uOffset)
    : visibility_(visibility), uOffset_(uOffset), parts_(kTreeCells, -1.0f) {}

double VisibleCells::part(const TreeCell& cell) const {
  float& part = parts_[cell.place()];
  if (part < 0) part = float(visiblePart(rectangleOf(cell.texels(), uOffset_), visibility_));
  return double(part);
}

double VisibleCells::part(uvec2 latticeTexel) const {
  return visiblePart(rectangleOf({latticeTexel, uvec2(1)}, uOffset_), visibility_);
}

SeenLobe seeByCells(const GgxLobe& lobe, const VisibleCells& cells, const LightMoments& light,
                    double uOffset) {
  const Density density(lobe, uOffset);
  CellSums sums{density};
  for (uint32_t root = 0; root < kTreeRoots; ++root) addTree(root, cells, light, sums);
  for (const LightMoments::BrightTexel& bright : light.brightTexels())
    sums.addBright(bright.light, cells.part(bright.at));
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
  const float width = std::min(lobe.alpha.x, lobe.alpha.y) * glm::dot(lobe.normal, lobe.view);
  const double part = double(std::clamp((width - kWideFrom) / (kWideTo - kWideFrom), 0.0f, 1.0f));
  if (part <= 0) return seeByBoxes(lobe, visibility, light, uOffset);
  const SeenLobe byCells = seeByCells(lobe, cells, light.moments(), uOffset);
  if (part >= 1) return byCells;
  const SeenLobe byBoxes = seeByBoxes(lobe, visibility, light, uOffset);
  const auto mix = [part](auto a, auto b) { return a * (1 - part) + b * part; };
  return {mix(byBoxes.radiance, byCells.radiance), mix(byBoxes.hidden, byCells.hidden),
          mix(byBoxes.towards, byCells.towards)};
}

}  // namespace boxlight
