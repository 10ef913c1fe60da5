// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/base/math.h"

namespace boxlight {

/// Where a direction lies between the views: the three corners of its view triangle and barycentric weights
/// that sum to 1.
struct ViewBlend {
  std::array<uint32_t, 3> view{};
  vec3 weight{0.0f};
  uint32_t triangle = 0;
};

/// The view directions: vertices of a geodesic icosahedron. Frequency f has 10 f^2 + 2 vertices and 20 f^2
/// triangles; f = 3 gives the 92 of the sketch, with edges of 20 to 24 degrees. The order of vertices and
/// triangles is part of the asset format (docs/format.md, "View sphere").
class ViewSphere {
 public:
  explicit ViewSphere(uint32_t frequency);

  uint32_t frequency() const { return frequency_; }
  uint32_t viewCount() const { return uint32_t(directions_.size()); }
  const std::vector<vec3>& directions() const { return directions_; }
  const std::vector<uvec3>& triangles() const { return triangles_; }
  /// neighbour(t)[k] is the triangle across the edge opposite to corner k of triangle t.
  const std::vector<uvec3>& neighbours() const { return neighbours_; }
  /// Views joined to view v by an edge, in ascending order.
  const std::vector<uint32_t>& adjacent(uint32_t view) const { return adjacent_[view]; }

  /// Walks from `start` across the edges that the direction lies behind; a few steps. The weights are those
  /// of the intersection of the direction with the plane of the triangle.
  ViewBlend locate(vec3 direction, uint32_t start = 0) const;

 private:
  void subdivide();
  void connect();

  uint32_t frequency_;
  std::vector<vec3> directions_;
  std::vector<uvec3> triangles_, neighbours_;
  std::vector<std::vector<uint32_t>> adjacent_;
};

/// Views below it are baked at, and directions seen at run time are raised to, this cosine above a texel's
/// horizon.
inline constexpr float kHorizonCosine = 0.05f;

/// `direction` turned towards the unit normal until their cosine is at least `cosine`; unchanged if it
/// already is.
vec3 raiseAboveHorizon(vec3 direction, vec3 normal, float cosine = kHorizonCosine);

/// For each view: is it a vertex of a view triangle that touches the open upper hemisphere of `normal`?
/// (About 63 of 92.)
std::vector<bool> viewsOfHemisphere(const ViewSphere& sphere, vec3 normal);

}  // namespace boxlight
