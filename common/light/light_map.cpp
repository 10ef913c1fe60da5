// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_map.h"

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

/// `measure(from, to)` is the size of an interval along the axis in units of which there are source * target.
template <class Measure>
AxisCover coverAxis(uint32_t source, uint32_t target, const Measure& measure) {
  AxisCover cover;
  std::vector<double> sizes;
  for (uint32_t t = 0; t < target; ++t) {
    // In whole numbers, so that shared edges meet exactly: target texel t is [t, t + 1] * source of source *
    // target units.
    const uint64_t begin = uint64_t(t) * source, end = begin + source;
    const uint64_t first = begin / target;
    sizes.clear();
    double total = 0;
    for (uint64_t s = first; s * target < end; ++s) {
      const uint64_t from = std::max(begin, s * target), to = std::min(end, (s + 1) * target);
      sizes.push_back(measure(from, to));
      total += sizes.back();
    }
    const auto place = uint32_t(cover.share.size());
    cover.texels.push_back({uint32_t(first), place, place + uint32_t(sizes.size())});
    for (const double size : sizes) cover.share.push_back(float(size / total));
  }
  return cover;
}

Rgb meanOverColumns(const Image& environment, const AxisCover& columns, uint32_t x, uint32_t row) {
  const AxisCover::Texel& texel = columns.texels[x];
  Rgb mean(0.0f);
  for (uint32_t i = texel.begin; i < texel.end; ++i)
    mean += columns.share[i] * rgbAt(environment, texel.first + i - texel.begin, row);
  return mean;
}

}  // namespace

AxisCover coverColumns(uint32_t source, uint32_t target) {
  return coverAxis(source, target, [](uint64_t from, uint64_t to) { return double(to - from); });
}

AxisCover coverRows(uint32_t source, uint32_t target) {
  const double units = double(source) * double(target);
  return coverAxis(source, target, [units](uint64_t from, uint64_t to) {
    return rectangleSolidAngle(1.0, double(from) / units, double(to) / units);
  });
}

Image makeLightMap(const Image& environment, uvec2 size) {
  assert(environment.channels == 3 && size.x > 0 && size.y > 0);
  const AxisCover columns = coverColumns(environment.width, size.x),
                  rows = coverRows(environment.height, size.y);
  Image map = makeImage(size.x, size.y, 3);
  for (uint32_t y = 0; y < size.y; ++y) {
    const AxisCover::Texel& texel = rows.texels[y];
    for (uint32_t x = 0; x < size.x; ++x) {
      Rgb mean(0.0f);
      for (uint32_t i = texel.begin; i < texel.end; ++i)
        mean += rows.share[i] * meanOverColumns(environment, columns, x, texel.first + i - texel.begin);
      for (int c = 0; c < 3; ++c) map.at(x, y)[c] = mean[c];
    }
  }
  return map;
}

std::vector<double> texelSolidAngles(uint32_t width, uint32_t height) {
  std::vector<double> angles(height);
  for (uint32_t y = 0; y < height; ++y)
    angles[y] = rectangleSolidAngle(1.0 / width, double(y) / height, double(y + 1) / height);
  return angles;
}

dvec3 totalEnergy(const Image& environment) {
  const auto solidAngles = texelSolidAngles(environment.width, environment.height);
  dvec3 total(0.0);
  for (uint32_t y = 0; y < environment.height; ++y) {
    dvec3 row(0.0);
    for (uint32_t x = 0; x < environment.width; ++x) row += dvec3(rgbAt(environment, x, y));
    total += solidAngles[y] * row;
  }
  return total;
}

}  // namespace boxlight
