// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/chart_pack.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "bake/scene/rectangle_pack.h"
#include "common/base/progress.h"

namespace boxlight {
namespace {

constexpr double kWorthwhile = 0.5;    // of the density without gutters: below, more charts share rectangles
constexpr double kGutterPrice = 0.85;  // of the density with the narrowest gutter that a wider one may leave
constexpr double kThin = 0.125;  // a side so much smaller than a texel shares, however long the other one is
constexpr double kHopeless = 1e-3;   // of the density of an atlas without waste: below, no search
constexpr double kPrecision = 0.01;  // of the density found
constexpr double kAir = 4;           // units between charts in one rectangle: what rounding may move them

struct Rectangle {
  dvec2 size;  // texels
  std::vector<uint32_t> charts;
  std::vector<dvec2> corners;  // of the charts
};

/// How charts may be laid out, apart from the density.
struct Terms {
  uint32_t atlasSize;
  uint32_t block;  // rectangles start at its multiples, and two blocks are between them
  double crumb;    // texels: charts no larger share rectangles; infinite: all share one
};

class Layout {
 public:
  Layout(std::span<const Chart> charts, std::span<const ChartKin> kin, const Terms& terms)
      : charts_(charts), kin_(kin), terms_(terms), order_(charts.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::stable_sort(order_.begin(), order_.end(), [kin](uint32_t a, uint32_t b) {
      return std::tie(kin[a].key, kin[a].place) < std::tie(kin[b].key, kin[b].place);
    });
  }

  /// At most this dense: the charts' own rectangles fill the atlas.
  double densest() const {
    double area = 0, longest = 0;
    for (const Chart& chart : charts_) {
      area += chart.size.x * chart.size.y;
      longest = std::max(longest, chart.size.x);
    }
    const double side = terms_.atlasSize;
    return area > 0 ? side / std::max(std::sqrt(area), longest) : side / std::max(longest, 1e-300);
  }

  bool fits(double density, Packing& packing) const {
    throwIfInterrupted("interrupted: no asset was written; run the same command again");
    std::vector<Rectangle> rectangles = cut(density);
    const auto block = int(terms_.block);
    const int side = int(terms_.atlasSize) / block + 2;  // what hangs over the edge is gutter
    std::vector<PackedRectangle> blocks;
    double area = 0;
    for (const Rectangle& rectangle : rectangles) {
      const dvec2 size = glm::ceil(rectangle.size / double(block));
      if (std::max(size.x, size.y) > double(side - 2)) return false;
      blocks.push_back({ivec2(glm::max(size, dvec2(1))) + 2, ivec2(0)});
      area += double(blocks.back().size.x) * blocks.back().size.y;
    }
    if (area > double(side) * side || !packRectangles(blocks, side)) return false;
    packing = {density, 2 * terms_.block, uint32_t(rectangles.size()), 0, terms_.crumb, {}};
    packing.origin.resize(charts_.size());
    for (size_t i = 0; i < rectangles.size(); ++i)
      for (size_t k = 0; k < rectangles[i].charts.size(); ++k) {
        packing.origin[rectangles[i].charts[k]] = dvec2(blocks[i].corner * block) + rectangles[i].corners[k];
        packing.shared += rectangles[i].charts.size() > 1;
      }
    return true;
  }

 private:
  double unit() const { return double(terms_.atlasSize) / kAtlasUnits; }

  /// With what a triangle that is too thin is widened to.
  dvec2 sizeOf(uint32_t chart, double density) const {
    return glm::max(charts_[chart].size * density, dvec2(kLeastExtent * unit()));
  }

  bool isCrumb(dvec2 size) const { return size.x <= terms_.crumb || size.y <= kThin * terms_.crumb; }

  std::vector<Rectangle> cut(double density) const {
    std::vector<Rectangle> rectangles;
    std::vector<uint32_t> run;  // of kin that will share a rectangle
    double area = 0;
    const auto close = [&] {
      if (!run.empty()) rectangles.push_back(shelve(run, area, density));
      run.clear();
      area = 0;
    };
    for (const uint32_t chart : order_) {
      const dvec2 size = sizeOf(chart, density);
      if (!isCrumb(size)) {
        rectangles.push_back({size, {chart}, {dvec2(0)}});
        continue;
      }
      const bool isKin = run.empty() || kin_[run.back()].key == kin_[chart].key || std::isinf(terms_.crumb);
      const double full = 4 * terms_.crumb * terms_.crumb;
      if (!isKin || area + size.x * size.y > full) close();
      run.push_back(chart);
      area += (size.x + kAir * unit()) * (size.y + kAir * unit());
    }
    close();
    return rectangles;
  }

  /// Shelves of falling height: rectangles that are far smaller than a texel need no better packing.
  Rectangle shelve(std::vector<uint32_t> run, double area, double density) const {
    Rectangle rectangle{dvec2(0), run, {}};
    std::vector<dvec2> sizes;
    double widest = 0;
    for (const uint32_t chart : run) {
      sizes.push_back(sizeOf(chart, density));
      widest = std::max(widest, sizes.back().x);
    }
    std::vector<size_t> order(run.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return sizes[a].y > sizes[b].y; });
    const double width = std::max(widest, std::sqrt(area));
    rectangle.corners.resize(run.size());
    dvec2 pen(0);
    double shelf = 0;
    for (const size_t i : order) {
      if (pen.x > 0 && pen.x + sizes[i].x > width) {
        pen = {0, pen.y + shelf};
        shelf = 0;
      }
      rectangle.corners[i] = pen;
      rectangle.size = glm::max(rectangle.size, pen + sizes[i]);
      shelf = std::max(shelf, sizes[i].y + kAir * unit());
      pen.x += sizes[i].x + kAir * unit();
    }
    return rectangle;
  }

  std::span<const Chart> charts_;
  std::span<const ChartKin> kin_;
  Terms terms_;
  std::vector<uint32_t> order_;
};

/// The densest that fits, by bisection; of density 0 if the gutters alone fill the atlas.
Packing pack(std::span<const Chart> charts, std::span<const ChartKin> kin, const Terms& terms) {
  const Layout layout(charts, kin, terms);
  Packing packing;
  double high = layout.densest(), low = high;
  const double hopeless = kHopeless * high;
  while (!layout.fits(low, packing)) {
    high = low;
    low *= 0.7;
    if (low < hopeless) return {};
  }
  Packing candidate;
  while (low < high * (1 - kPrecision)) {
    const double middle = std::sqrt(low * high);
    if (layout.fits(middle, candidate)) {
      low = middle;
      std::swap(packing, candidate);
    } else {
      high = middle;
    }
  }
  return packing;
}

}  // namespace

Packing packCharts(std::span<const Chart> charts, std::span<const ChartKin> kin, uint32_t atlasSize) {
  constexpr double kEvery = std::numeric_limits<double>::infinity();
  const Packing gutterless = pack(charts, kin, {atlasSize, 1, kEvery});
  double crumb = 1;
  Packing best;
  for (; crumb <= atlasSize; crumb *= 2) {
    best = pack(charts, kin, {atlasSize, 1, crumb});
    if (best.texelsPerMetre >= kWorthwhile * gutterless.texelsPerMetre) break;
  }
  if (crumb > atlasSize) return gutterless;
  for (const uint32_t block : {4u, 2u}) {
    if (atlasSize % block != 0) continue;
    Packing wide = pack(charts, kin, {atlasSize, block, crumb});
    if (wide.texelsPerMetre >= kGutterPrice * best.texelsPerMetre) return wide;
  }
  return best;
}

}  // namespace boxlight
