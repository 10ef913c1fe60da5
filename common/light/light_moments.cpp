// SPDX-License-Identifier: Apache-2.0
#include "common/light/light_moments.h"

#include <algorithm>
#include <cmath>

#include "common/light/bright_texels.h"
#include "common/light/light_domain.h"
#include "common/light/light_map.h"
#include "common/light/summed_area.h"

namespace boxlight {
namespace {

constexpr uint32_t kColumns = kMomentSize.x, kRows = kMomentSize.y;

/// About +Y, by an angle that phi grows by.
dmat3 turned(const dmat3& moment, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  dmat3 result = moment;
  for (int k = 0; k < 3; ++k) {
    result[k].x = c * moment[k].x - s * moment[k].z;
    result[k].z = s * moment[k].x + c * moment[k].z;
  }
  return result;
}

dvec3 direction(double u, double v) {
  const double phi = 2.0 * kPiDouble * (u - 0.5), theta = kPiDouble * v;
  return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

/// n.w of each channel, where it is positive, as moments.
dmat3 above(const dmat3& moment, dvec3 normal) {
  dmat3 result = moment;
  for (int k = 0; k < 3; ++k)
    if (!(glm::dot(normal, moment[k]) > 0.0)) result[k] = dvec3(0.0);
  return result;
}

}  // namespace

LightMoments::LightMoments(const Image& lightMap)
    : sums_(size_t(kColumns + 1) * (kRows + 1), dmat3(0.0)),
      nodes_(size_t(kHorizonNodes.x) * kHorizonNodes.y, dmat3(0.0)) {
  addTexels(lightMap);
  separateBrightTexels(lightMap);
  tree_ = LightTree([this](uint32_t x, uint32_t y) {
    return isBright({x, y}) ? dmat3(0.0) : strip(x, y, y + 1);
  });
  makeNodes();
}

bool LightMoments::isBright(uvec2 at) const {
  return std::any_of(bright_.begin(), bright_.end(),
                     [at](const BrightTexel& bright) { return bright.at == at; });
}

void LightMoments::addTexels(const Image& lightMap) {
  const MomentCover cover = makeMomentCover({lightMap.width, lightMap.height});
  for (uint32_t y = 0; y < kRows; ++y) {
    dmat3 row(0.0);
    for (uint32_t x = 0; x < kColumns; ++x) {
      const auto &column = cover.columns[x], &line = cover.rows[y];
      for (uint32_t j = line.begin; j < line.end; ++j)
        for (uint32_t i = column.begin; i < column.end; ++i) {
          const dvec3 radiance(rgbAt(lightMap, column.first + i - column.begin, line.first + j - line.begin));
          const dvec3 w(cover.columnWeights[i]);
          const dvec2 ring(cover.rowWeights[j]);
          row += glm::outerProduct(dvec3(ring.x * w.x, ring.y * w.z, ring.x * w.y), radiance);
        }
      sums_[size_t(y + 1) * (kColumns + 1) + x + 1] = sum(x + 1, y) + row;
    }
  }
}

void LightMoments::separateBrightTexels(const Image& lightMap) {
  const std::vector<double> solidAngles = texelSolidAngles(lightMap.width, lightMap.height);
  dvec3 total(0.0);
  for (uint32_t y = 0; y < lightMap.height; ++y)
    for (uint32_t x = 0; x < lightMap.width; ++x) total += solidAngles[y] * dvec3(rgbAt(lightMap, x, y));
  const double most = std::max({total.x, total.y, total.z});
  if (!(most > 0.0)) return;
  std::vector<double> strengths;
  for (uint32_t i = 0; i < kColumns * kRows; ++i) {
    const dmat3 moment = strip(i % kColumns, i / kColumns, i / kColumns + 1) / most;
    strengths.push_back(std::sqrt(glm::dot(moment[0], moment[0]) + glm::dot(moment[1], moment[1]) +
                                  glm::dot(moment[2], moment[2])));
  }
  for (const uint32_t i : findBrightTexels(strengths)) {
    const uvec2 at(i % kColumns, i / kColumns);
    bright_.push_back({at, strip(at.x, at.y, at.y + 1)});
  }
}

/// Of kHorizonCells.
std::vector<LightCell> LightMoments::horizonCells() const {
  constexpr uvec2 kSize = kMomentSize / kHorizonCells;
  std::vector<LightCell> cells;
  for (uint32_t i = 0; i < kHorizonCells.x * kHorizonCells.y; ++i) {
    const uvec2 at = uvec2(i % kHorizonCells.x, i / kHorizonCells.x) * kSize, to = at + kSize;
    cells.push_back(
        {sum(to.x, to.y) - sum(at.x, to.y) - (sum(to.x, at.y) - sum(at.x, at.y)), momentOfOne({at, kSize})});
  }
  for (const BrightTexel& bright : bright_) {
    const uvec2 at = bright.at / kSize;
    cells[at.y * kHorizonCells.x + at.x].light -= bright.light;
  }
  return cells;
}

/// What cells on the horizon lose or have too much is made up for by their mean radiance.
void LightMoments::makeNodes() {
  const std::vector<LightCell> cells = horizonCells();
  for (uint32_t i = 0; i < nodes_.size(); ++i) {
    const dvec3 normal = direction(double(i % kHorizonNodes.x) / kHorizonNodes.x,
                                   double(i / kHorizonNodes.x) / (kHorizonNodes.y - 1));
    dvec3 missing = kPiDouble * normal, radiance(0.0);  // the first of a light of 1
    double weights = 0;
    for (const auto& [moment, one] : cells) {
      nodes_[i] += above(moment, normal);
      const double cosine = glm::dot(normal, one), square = glm::dot(one, one);
      if (cosine > 0.0) missing -= one;
      const double weight = std::max(1.0 - cosine * cosine / (kHorizonBand * kHorizonBand * square), 0.0);
      radiance += weight / std::sqrt(square) * (one * moment);
      weights += weight * std::sqrt(square);
    }
    nodes_[i] += glm::outerProduct(missing, radiance / weights);
  }
}

dmat3 LightMoments::strip(uint32_t x, uint32_t y0, uint32_t y1) const {
  x %= kColumns;
  return sum(x + 1, y1) - sum(x, y1) - (sum(x + 1, y0) - sum(x, y0));
}

dmat3 LightMoments::integrate(const Rectangle& rectangle, double uOffset) const {
  const auto y0 = uint32_t(std::lround(rectangle.v0 * kRows)),
             y1 = uint32_t(std::lround((rectangle.v0 + rectangle.dv) * kRows));
  const double start = (rectangle.u0 + uOffset - std::floor(rectangle.u0 + uOffset)) * kColumns,
               end = start + rectangle.du * kColumns;
  dmat3 result(0.0);
  for (auto x = uint32_t(start); x < end; ++x) {
    const double from = std::max(start, double(x)), to = std::min(end, x + 1.0);
    const double shift = 0.5 * (from + to) - (x + 0.5);  // of the piece, from the middle of its texel
    result += (to - from) * turned(strip(x, y0, y1), shift * 2.0 * kPiDouble / kColumns);
  }
  return turned(result, -2.0 * kPiDouble * uOffset);
}

/// With S_i the moments at the nodes n_i around the normal and b_i their bilinear shares, E = sum b_i (n +
/// n_i).S_i / sum b_i (1 + n.n_i): of the mean of two interpolations, one of n.S_i, one of n_i.S_i, whose
/// errors of second order are opposite.
LightMoments::Hemisphere LightMoments::hemisphere(dvec3 normal, double uOffset) const {
  const double u = 0.5 + std::atan2(normal.z, normal.x) / (2.0 * kPiDouble) + uOffset;
  const double v = std::atan2(std::hypot(normal.x, normal.z), normal.y) / kPiDouble;
  const dvec3 n = direction(u, v);
  const double x = (u - std::floor(u)) * kHorizonNodes.x, y = v * (kHorizonNodes.y - 1);
  const uint32_t x0 = uint32_t(x) % kHorizonNodes.x, y0 = std::min(uint32_t(y), kHorizonNodes.y - 2);
  const double fx = x - std::floor(x), fy = y - y0;
  dmat3 moment(0.0);
  dvec3 sum(0.0);
  double weight = 0;
  for (uint32_t k = 0; k < 4; ++k) {
    const uint32_t i = (x0 + k % 2) % kHorizonNodes.x, j = y0 + k / 2;
    const double share = (k % 2 ? fx : 1 - fx) * (k / 2 ? fy : 1 - fy);
    const dmat3& node = nodes_[size_t(j) * kHorizonNodes.x + i];
    const dvec3 at = direction(double(i) / kHorizonNodes.x, double(j) / (kHorizonNodes.y - 1));
    moment += share * node;
    sum += share * ((n + at) * node);
    weight += share * (1.0 + glm::dot(n, at));
  }
  sum /= weight;
  for (const BrightTexel& bright : bright_) {
    const dmat3 seen = above(bright.light, n);
    sum += n * seen;
    moment += seen;
  }
  return {sum, turned(moment, -2.0 * kPiDouble * uOffset)};
}

}  // namespace boxlight
