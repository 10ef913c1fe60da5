// SPDX-License-Identifier: Apache-2.0
#include "common/light/lobe_clip.h"

#include <cmath>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

/// What is visible of a rectangle: the part, and the smallest rectangle around it.
struct Visible {
  double part = 0;
  Rectangle around;
};

/// The sum over the maps.
Visible filter(const Rectangle& rectangle, const FilteredVisibility& visibility) {
  Visible sum;
  for (size_t k = 0; k < visibility.map.size(); ++k) {
    if (!(visibility.weight[k] > 0.0f)) continue;
    const VisiblePart seen = scanVisible(rectangle, *visibility.map[k]);
    const double part = double(visibility.weight[k]) * seen.part;
    sum.part += part;
    sum.around.u0 += part * seen.around.u0, sum.around.du += part * seen.around.du;
    sum.around.v0 += part * seen.around.v0, sum.around.dv += part * seen.around.dv;
  }
  if (!(sum.part > 0)) return {};
  sum.around.u0 /= sum.part, sum.around.du /= sum.part;
  sum.around.v0 /= sum.part, sum.around.dv /= sum.part;
  return sum;
}

/// In cells of the maps, either way: smaller boxes gain nothing from quarters.
constexpr double kLeastQuartered = 8;

bool isLarge(const Rectangle& whole) {
  return whole.du * VisibilityMap::kColumns >= kLeastQuartered ||
         whole.dv * VisibilityMap::kRows >= kLeastQuartered;
}

dvec3 directionOf(const Box& box) { return meanDirection(box.u0, box.v0, box.du, box.dv); }

Rectangle quarter(const Rectangle& whole, int i) {
  const double du = 0.5 * whole.du, dv = 0.5 * whole.dv;
  return {whole.u0 + (i & 1) * du, whole.v0 + (i >> 1) * dv, du, dv};
}

}  // namespace

ClippedLobe clipLobe(std::span<const Box> lobe, const FilteredVisibility& visibility) {
  constexpr double kWhole = 1 - 1e-5;
  ClippedLobe result;
  double all = 0, direct = 0;
  const auto keep = [&](const Rectangle& rectangle, dvec3 energy) {
    if (!(maxComponent(Rgb(energy)) > 0.0f)) return;
    result.pieces.push_back({rectangle, energy});
    direct += double(luminance(Rgb(energy)));
  };
  const auto clip = [&](const Box& box, const Rectangle& whole, const Visible& seen) {
    if (seen.part >= kWhole || !isLarge(whole))
      return keep(seen.around, dvec3(box.energy) * std::min(seen.part, 1.0));
    for (int i = 0; i < 4; ++i) {
      const Rectangle part = quarter(whole, i);
      const Visible visible = filter(part, visibility);
      keep(visible.around, dvec3(box.energy) * (visible.part * part.solidAngle() / whole.solidAngle()));
    }
  };
  for (const Box& box : lobe) {
    const double before = direct, energy = double(luminance(box.energy));
    const Rectangle whole = rectangleOf(box);
    const Visible seen = filter(whole, visibility);
    clip(box, whole, seen);
    all += energy;
    if (seen.part < kWhole) result.towards += std::max(energy - (direct - before), 0.0) * directionOf(box);
  }
  result.hidden = std::max(all - direct, 0.0);
  return result;
}

double visiblePart(const Rectangle& rectangle, const FilteredVisibility& visibility) {
  return filter(rectangle, visibility).part;
}

vec3 ClippedLobe::hiddenDirection() const {
  const double length = glm::length(towards);
  return length > 0 ? vec3(towards / length) : vec3(0, 1, 0);
}

dvec3 splitRadiance(dvec3 direct, double hidden, dvec3 storedRadiance, double storedPart, double own) {
  constexpr double kLeastDirect = 1e-3;
  const dvec3 mean = direct / (own * std::max(1 - hidden, kLeastDirect));
  return direct + own * hidden * (storedRadiance + kUnseenHidden * mean) / (storedPart + kUnseenHidden);
}

}  // namespace boxlight
