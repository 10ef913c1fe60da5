// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_map.h"

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

/// What one target texel covers along one axis: source texels first, first + 1, ... and the part of the
/// target in each.
struct Cover {
  uint32_t first = 0;
  std::vector<double> share;  // sums to 1
};

/// `measure(a, b)` is the size of [a, b] of [0,1] along the axis.
template <class Measure>
std::vector<Cover> coverAxis(uint32_t source, uint32_t target, const Measure& measure) {
  std::vector<Cover> covers(target);
  for (uint32_t t = 0; t < target; ++t) {
    // In whole numbers, so that shared edges meet exactly: target texel t is [t, t + 1] * source of source *
    // target units.
    const uint64_t begin = uint64_t(t) * source, end = begin + source;
    const double units = double(source) * double(target);
    covers[t].first = uint32_t(begin / target);
    double total = 0;
    for (uint64_t s = covers[t].first; s * target < end; ++s) {
      const uint64_t from = std::max(begin, s * target), to = std::min(end, (s + 1) * target);
      covers[t].share.push_back(measure(double(from) / units, double(to) / units));
      total += covers[t].share.back();
    }
    for (double& share : covers[t].share) share /= total;
  }
  return covers;
}

/// The source rows under one target row, averaged.
std::vector<dvec3> averageRows(const Image& environment, const Cover& rows) {
  std::vector<dvec3> average(environment.width, dvec3(0.0));
  for (size_t i = 0; i < rows.share.size(); ++i)
    for (uint32_t x = 0; x < environment.width; ++x)
      average[x] += rows.share[i] * dvec3(rgbAt(environment, x, rows.first + uint32_t(i)));
  return average;
}

}  // namespace

Image makeLightMap(const Image& environment, uvec2 size) {
  assert(environment.channels == 3 && size.x > 0 && size.y > 0);
  const auto columns = coverAxis(environment.width, size.x, [](double a, double b) { return b - a; });
  const auto rows = coverAxis(environment.height, size.y,
                              [](double a, double b) { return rectangleSolidAngle(1.0, a, b); });
  Image map = makeImage(size.x, size.y, 3);
  for (uint32_t y = 0; y < size.y; ++y) {
    const std::vector<dvec3> row = averageRows(environment, rows[y]);
    for (uint32_t x = 0; x < size.x; ++x) {
      dvec3 mean(0.0);
      for (size_t i = 0; i < columns[x].share.size(); ++i)
        mean += columns[x].share[i] * row[columns[x].first + i];
      for (int c = 0; c < 3; ++c) map.at(x, y)[c] = float(mean[c]);
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

}  // namespace boxlight
