// SPDX-License-Identifier: Apache-2.0
#include <stb/stb_rect_pack.h>

#include <cassert>
#include <cmath>

#include "data/mesh.h"

namespace boxlight::data {
namespace {

constexpr int kSmallestSide = 2;  ///< texels; a thinner chart has no texel wholly inside it

struct Packing {
  double texelsPerMetre = 0;
  std::vector<stbrp_rect> rectangles;  ///< texels, with the gutter on the right and lower side
};

class Packer {
 public:
  Packer(const std::vector<Chart*>& charts, uint32_t resolution, uint32_t gutter)
      : charts_(charts), resolution_(int(resolution)), gutter_(int(gutter)), turned_(charts.size(), false) {}

  /// Turns one chart after the other by a quarter as long as that makes room for larger texel densities.
  Packing best() {
    Packing best = largest();
    for (bool better = true; better;) {
      better = false;
      for (size_t i = 0; i < charts_.size(); ++i) {
        turned_[i] = !turned_[i];
        Packing packing = largest();
        if (packing.texelsPerMetre > 1.0001 * best.texelsPerMetre) {
          best = std::move(packing);
          better = true;
        } else {
          turned_[i] = !turned_[i];
        }
      }
    }
    return best;
  }

  bool turned(size_t chart) const { return turned_[chart]; }

 private:
  int side(float metres, double texelsPerMetre) const {
    return std::max(kSmallestSide, int(std::lround(double(metres) * texelsPerMetre))) + gutter_;
  }

  /// Do the charts fit at this density? If so, they are in `rectangles`.
  bool place(double texelsPerMetre, std::vector<stbrp_rect>& rectangles) {
    rectangles.assign(charts_.size(), {});
    for (size_t i = 0; i < charts_.size(); ++i) {
      const vec2 size = charts_[i]->size;
      rectangles[i].w = side(turned_[i] ? size.y : size.x, texelsPerMetre);
      rectangles[i].h = side(turned_[i] ? size.x : size.y, texelsPerMetre);
    }
    std::vector<stbrp_node> nodes(resolution_);
    stbrp_context context;
    stbrp_init_target(&context, resolution_, resolution_, nodes.data(), int(nodes.size()));
    return stbrp_pack_rects(&context, rectangles.data(), int(rectangles.size())) != 0;
  }

  /// Bisection: fitting is not quite monotonic in the density, but what it ends with does fit.
  Packing largest() {
    Packing packing;
    std::vector<stbrp_rect> rectangles;
    double high = 1e30;
    for (const Chart* chart : charts_)
      high = std::min(high, resolution_ / double(std::min(chart->size.x, chart->size.y)));
    for (int step = 0; step < 30; ++step) {
      const double middle = 0.5 * (packing.texelsPerMetre + high);
      if (place(middle, rectangles))
        packing = {middle, rectangles};
      else
        high = middle;
    }
    return packing;
  }

  const std::vector<Chart*>& charts_;
  int resolution_, gutter_;
  std::vector<bool> turned_;
};

}  // namespace

void packCharts(const std::vector<Chart*>& charts, uint32_t resolution, uint32_t gutter) {
  Packer packer(charts, resolution, gutter);
  const Packing packing = packer.best();
  assert(packing.texelsPerMetre > 0);
  for (size_t i = 0; i < charts.size(); ++i) {
    const stbrp_rect& r = packing.rectangles[i];
    const vec2 origin = vec2(float(r.x), float(r.y)) + 0.5f * float(gutter);
    const vec2 extent(float(r.w - int(gutter)), float(r.h - int(gutter)));
    for (vec2& uv : charts[i]->atlas) {
      if (packer.turned(i)) uv = {uv.y, 1 - uv.x};
      uv = (origin + uv * extent) / float(resolution);
    }
  }
}

}  // namespace boxlight::data
