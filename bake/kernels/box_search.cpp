// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/box_search.h"

#include <cmath>
#include <limits>

namespace boxlight {
namespace {

/// (3e-4)^2 of all energy: what the rounding of a summed-area table can feign.
constexpr float kRounding = 1e-7f;

/// |max(integral, 0)|^2 over the channels, minus the noise in the last lane.
inline float significance(Lanes integral) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Lanes positive = maxLanes(integral, splat(0.0f));
  return sumLanes(positive * minLanes(positive, Lanes{kInfinity, kInfinity, kInfinity, -1.0f})) - kRounding;
}

int nextSize(int size, int limit) { return size == limit ? limit + 1 : std::min(2 * size, limit); }

constexpr float kWorthwhile = 1.0001f;  // a sweep that gains less than this factor is the last

}  // namespace

SolidAnglePower::SolidAnglePower(float exponent) {
  for (int i = 0; i <= kRasterColumns; ++i)
    width_[i] = float(std::pow(4.0 * kPiDouble * std::max(i, 1) / kRasterColumns, -double(exponent)));
  for (int i = 0; i <= 2 * kRasterRows; ++i) {
    const int nearest = std::min(i, 2 * kRasterRows - i);
    sine_[i] =
        float(std::pow(std::sin(kPiDouble * std::max(nearest, 1) / (2 * kRasterRows)), -double(exponent)));
  }
}

BoxSearch::BoxSearch(const DepositGrid& grid, float exponent, int seeds)
    : grid_(grid), power_(exponent), seedCount_(size_t(seeds)) {}

void BoxSearch::columnProfile(const GridSat& residual, int y0, int y1) {
  const int columns = grid_.columns();
  const Lanes *top = residual.row(y0), *bottom = residual.row(y1);
  profile_.resize(size_t(2 * columns) + 1);
  for (int x = 0; x <= columns; ++x) profile_[x] = bottom[x] - top[x];
  for (int x = 1; x <= columns; ++x) profile_[columns + x] = profile_[columns] + profile_[x];
}

void BoxSearch::rowProfile(const GridSat& residual, int x0, int x1) {
  profile_.resize(size_t(grid_.rows()) + 1);
  const int columns = grid_.columns();
  for (int y = 0; y <= grid_.rows(); ++y) {
    const Lanes* sums = residual.row(y);
    profile_[y] = x1 <= columns ? sums[x1] - sums[x0] : sums[columns] - sums[x0] + sums[x1 - columns];
  }
}

void BoxSearch::offerSeed(float gain, const GridBox& box) {
  if (seeds_.size() < seedCount_)
    seeds_.emplace_back();
  else if (gain <= seeds_.back().gain)
    return;
  size_t place = seeds_.size() - 1;
  for (; place > 0 && seeds_[place - 1].gain < gain; --place) seeds_[place] = seeds_[place - 1];
  seeds_[place] = {gain, box};
}

void BoxSearch::collectSeeds(const GridSat& residual) {
  seeds_.clear();
  const int columns = grid_.columns(), rows = grid_.rows();
  for (int height = std::min(2, rows); height <= rows; height = nextSize(height, rows))
    for (int y = 0; y + height <= rows; y += height) {
      const Lanes *top = residual.row(y), *bottom = residual.row(y + height);
      const float zone = power_.ofZone(grid_.rowLine(y), grid_.rowLine(y + height));
      for (int width = std::min(2, columns); width <= columns; width = nextSize(width, columns))
        for (int x = 0, x1 = width; x1 <= columns; x = x1, x1 += width) {
          const Lanes integral = (bottom[x1] - bottom[x]) - (top[x1] - top[x]);
          const float area = zone * power_.ofWidth(grid_.columnLine(x1) - grid_.columnLine(x));
          if (const float gain = significance(integral) * area; gain > 0.0f)
            offerSeed(gain, {x, x1, y, y + height});
        }
    }
}

float BoxSearch::find(const GridSat& residual, GridBox& best) {
  collectSeeds(residual);
  float bestGain = 0.0f;
  for (const Seed& seed : seeds_) {
    GridBox box = seed.box;
    const float gain = descend(residual, box, 6);
    if (gain <= bestGain) continue;
    bestGain = gain;
    best = box;
  }
  return bestGain;
}

float BoxSearch::descend(const GridSat& residual, GridBox& box, int sweeps) {
  float gain = -1e30f;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    moveColumns(residual, box);
    const float moved = moveRows(residual, box);
    if (moved <= gain * kWorthwhile) break;
    gain = moved;
  }
  return gain;
}

float BoxSearch::moveColumns(const GridSat& residual, GridBox& box) {
  const int columns = grid_.columns();
  columnProfile(residual, box.y0, box.y1);
  const auto gain = [&](int x0, int x1) {
    return significance(profile_[x1] - profile_[x0]) *
           power_.ofWidth(grid_.columnLine(x1) - grid_.columnLine(x0));
  };
  float best = gain(box.x0, box.x1);
  for (int x1 = box.x0 + 1, x0 = box.x0; x1 <= x0 + columns; ++x1)
    if (const float g = gain(x0, x1); g > best) best = g, box.x1 = x1;
  // Turn the box so that its left edge can move back over the seam.
  const int turn = box.x1 <= columns ? columns : 0;
  const int x1 = box.x1 + turn;
  int bestX0 = box.x0 + turn;
  for (int x0 = x1 - columns; x0 < x1; ++x0)
    if (const float g = gain(x0, x1); g > best) best = g, bestX0 = x0;
  const int back = bestX0 >= columns ? columns : 0;
  box.x0 = bestX0 - back;
  box.x1 = x1 - back;
  return best;
}

float BoxSearch::moveRows(const GridSat& residual, GridBox& box) {
  rowProfile(residual, box.x0, box.x1);
  const auto gain = [&](int y0, int y1) {
    return significance(profile_[y1] - profile_[y0]) * power_.ofZone(grid_.rowLine(y0), grid_.rowLine(y1));
  };
  float best = gain(box.y0, box.y1);
  for (int y1 = box.y0 + 1; y1 <= grid_.rows(); ++y1)
    if (const float g = gain(box.y0, y1); g > best) best = g, box.y1 = y1;
  for (int y0 = 0; y0 < box.y1; ++y0)
    if (const float g = gain(y0, box.y1); g > best) best = g, box.y0 = y0;
  return best * power_.ofWidth(grid_.columnLine(box.x1) - grid_.columnLine(box.x0));
}

}  // namespace boxlight
