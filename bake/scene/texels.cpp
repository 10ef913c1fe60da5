// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/texels.h"

#include <array>
#include <cmath>

namespace boxlight {
namespace {

/// A corner of a clipped triangle: where it is in the atlas, in texels from the triangle's first corner, and
/// on the triangle.
struct Corner {
  dvec2 atlas, barycentric;
};

using Polygon = std::vector<Corner>;

/// Sutherland-Hodgman against one side of a texel: keeps sign * (atlas[axis] - bound) >= 0.
void clip(const Polygon& polygon, Polygon& clipped, int axis, double bound, double sign) {
  clipped.clear();
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a.atlas[axis] - bound), db = sign * (b.atlas[axis] - bound);
    if (da >= 0) clipped.push_back(a);
    if ((da >= 0) != (db >= 0)) {
      const double t = da / (da - db);
      clipped.push_back({glm::mix(a.atlas, b.atlas, t), glm::mix(a.barycentric, b.barycentric, t)});
    }
  }
}

double cross2(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

constexpr double kSliver = 1e-5;

/// Area in texels of a convex polygon.
double atlasArea(std::span<const Corner> polygon) {
  double doubled = 0;
  for (size_t i = 2; i < polygon.size(); ++i)
    doubled += std::abs(cross2(polygon[i - 1].atlas - polygon[0].atlas, polygon[i].atlas - polygon[0].atlas));
  return 0.5 * doubled;
}

/// Of the whole texels that the polygon reaches along an axis, first and last, in an atlas of `size`.
std::pair<uint32_t, uint32_t> reach(std::span<const Corner> polygon, int axis, double origin, uint32_t size) {
  double low = polygon[0].atlas[axis], high = low;
  for (const Corner& corner : polygon) {
    low = std::min(low, corner.atlas[axis]);
    high = std::max(high, corner.atlas[axis]);
  }
  const auto texel = [size](double at) { return uint32_t(std::clamp(at, 0.0, size - 1.0)); };
  return {texel(origin + low), texel(origin + high)};
}

struct Piece {
  uint32_t texel;
  FootprintPiece part;  // area not yet a running sum
};

class Cutter {
 public:
  Cutter(const Scene& scene, uint32_t width, uint32_t height) : scene_(scene), size_(width, height) {}

  void cut(uint32_t triangle) {
    dvec2 uv[3];
    dvec3 p[3];
    for (int k = 0; k < 3; ++k) {
      const asset::Vertex& vertex = scene_.vertices[scene_.triangles[triangle].vertex[k]];
      uv[k] = dvec2(vertex.atlasUv[0], vertex.atlasUv[1]) * dvec2(size_);
      p[k] = {vertex.position[0], vertex.position[1], vertex.position[2]};
    }
    triangle_ = triangle;
    worldArea_ = 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    origin_ = uv[0];
    whole_.clear();
    for (int k = 0; k < 3; ++k) whole_.push_back({uv[k] - origin_, dvec2(k == 1, k == 2)});
    const double area = atlasArea(whole_);
    if (area > 0) {
      // What rounding leaves of a triangle that only touches a texel's side is no surface of the texel.
      cutRows(kSliver * std::min(1.0, area));
    } else {
      keepWhole((uv[0] + uv[1] + uv[2]) / 3.0);
    }
  }

  std::vector<Piece> pieces;

 private:
  void cutRows(double sliver) {
    const auto [first, last] = reach(whole_, 1, origin_.y, size_.y);
    for (uint32_t y = first; y <= last; ++y) {
      clip(whole_, scratch_, 1, y - origin_.y, 1);
      clip(scratch_, row_, 1, y + 1 - origin_.y, -1);
      if (row_.size() < 3) continue;
      const auto [left, right] = reach(row_, 0, origin_.x, size_.x);
      for (uint32_t x = left; x <= right; ++x) {
        clip(row_, scratch_, 0, x - origin_.x, 1);
        clip(scratch_, texel_, 0, x + 1 - origin_.x, -1);
        if (atlasArea(texel_) > sliver) keep(texel_, x, y);
      }
    }
  }

  /// A triangle without area in the atlas is surface none the less, of the texel it lies in.
  void keepWhole(dvec2 centre) {
    const auto at = uvec2(glm::clamp(centre, dvec2(0.0), dvec2(size_) - 1.0));
    keep(whole_, at.x, at.y);
  }

  void keep(const Polygon& polygon, uint32_t x, uint32_t y) {
    for (size_t i = 2; i < polygon.size(); ++i) {
      const dvec2 a = polygon[0].barycentric, b = polygon[i - 1].barycentric, c = polygon[i].barycentric;
      // Barycentric coordinates are affine: areas on the triangle are its area times twice theirs.
      const auto area = float(worldArea_ * std::abs(cross2(b - a, c - a)));
      if (area > 0) pieces.push_back({y * size_.x + x, {triangle_, {vec2(a), vec2(b), vec2(c)}, area}});
    }
  }

  const Scene& scene_;
  uvec2 size_;
  uint32_t triangle_ = 0;
  double worldArea_ = 0;
  dvec2 origin_{0.0};
  Polygon whole_, row_, texel_, scratch_;
};

/// Texels in blocks of 8x8, row by row.
uint32_t blockOrder(uint32_t x, uint32_t y, uint32_t width) {
  const uint32_t blocks = (width + 7) / 8;
  return ((y / 8) * blocks + x / 8) * 64 + (y % 8) * 8 + x % 8;
}

void gather(TexelMap& map, std::vector<Piece>& pieces) {
  auto order = [&](const Piece& p) {
    return blockOrder(p.texel % map.width, p.texel / map.width, map.width);
  };
  std::stable_sort(pieces.begin(), pieces.end(),
                   [&](const Piece& a, const Piece& b) { return order(a) < order(b); });
  for (const Piece& piece : pieces) {
    const uint32_t x = piece.texel % map.width, y = piece.texel / map.width;
    if (map.texels.empty() || map.texels.back().x != x || map.texels.back().y != y)
      map.texels.push_back({x, y, uint32_t(map.pieces.size()), 0});
    Texel& texel = map.texels.back();
    map.pieces.push_back(piece.part);
    if (texel.pieceCount++) map.pieces.back().area += map.pieces[map.pieces.size() - 2].area;
  }
}

/// Has the texel any point that its mask does not cut away? Looked for on a grid of points.
bool hasSurface(const Scene& scene, std::span<const FootprintPiece> footprint) {
  constexpr int kGrid = 16;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const SurfacePoint point = sampleFootprint(footprint, (vec2(i % kGrid, i / kGrid) + 0.5f) / float(kGrid));
    const asset::Material& material = scene.materials[scene.triangles[point.triangle].material];
    if (!(material.flags & asset::kAlphaMask) || sampleAlpha(scene, point) >= material.alphaCutoff)
      return true;
  }
  return false;
}

void dilate(TexelMap& map) {
  map.nearest.assign(size_t(map.width) * map.height, asset::kNone);
  std::vector<int> distance(map.nearest.size(), kGutterTexels * kGutterTexels + 1);
  for (uint32_t i = 0; i < map.texels.size(); ++i) {
    const ivec2 centre(map.texels[i].x, map.texels[i].y);
    const ivec2 low = glm::max(centre - kGutterTexels, ivec2(0));
    const ivec2 high = glm::min(centre + kGutterTexels, ivec2(map.width - 1, map.height - 1));
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const int squared = (x - centre.x) * (x - centre.x) + (y - centre.y) * (y - centre.y);
        const size_t at = size_t(y) * map.width + x;
        if (squared >= distance[at]) continue;
        distance[at] = squared;
        map.nearest[at] = i;
      }
  }
}

}  // namespace

TexelMap makeTexels(const Scene& scene, uint32_t width, uint32_t height) {
  Cutter cutter(scene, width, height);
  for (uint32_t t = 0; t < scene.triangles.size(); ++t) cutter.cut(t);
  TexelMap map;
  map.width = width;
  map.height = height;
  gather(map, cutter.pieces);
  // A texel that a mask cuts away whole is gutter: its neighbours' light belongs there, not darkness.
  std::erase_if(map.texels, [&](const Texel& texel) { return !hasSurface(scene, map.footprint(texel)); });
  dilate(map);
  return map;
}

SurfacePoint sampleFootprint(std::span<const FootprintPiece> footprint, vec2 sample) {
  const float target = sample.x * footprint.back().area;
  const auto piece = std::upper_bound(footprint.begin(), footprint.end() - 1, target,
                                      [](float area, const FootprintPiece& p) { return area < p.area; });
  const float before = piece == footprint.begin() ? 0.0f : std::prev(piece)->area;
  // What is left of the first number is uniform again inside the piece.
  const float u = std::clamp((target - before) / std::max(piece->area - before, 1e-30f), 0.0f, 1.0f);
  const float root = std::sqrt(u);
  const vec2 barycentric = (1 - root) * piece->corner[0] + root * (1 - sample.y) * piece->corner[1] +
                           root * sample.y * piece->corner[2];
  return {piece->triangle, barycentric};
}

}  // namespace boxlight
