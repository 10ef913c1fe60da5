// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "bake/scene/material.h"

namespace boxlight {

/// The corners of a triangle and the weights of a point on it.
struct Corners {
  Corners(const Scene& scene, SurfacePoint point)
      : triangle(scene.triangles[point.triangle]),
        a(scene.vertices[triangle.vertex[0]]),
        b(scene.vertices[triangle.vertex[1]]),
        c(scene.vertices[triangle.vertex[2]]),
        weights(1.0f - point.barycentric.x - point.barycentric.y, point.barycentric.x, point.barycentric.y) {}

  float mix(float x, float y, float z) const { return weights.x * x + weights.y * y + weights.z * z; }
  /// Interpolates the first three floats of an attribute.
  vec3 mix3(const float* x, const float* y, const float* z) const {
    return {mix(x[0], y[0], z[0]), mix(x[1], y[1], z[1]), mix(x[2], y[2], z[2])};
  }
  vec2 uv(uint32_t set) const {
    return {mix(a.uv[set][0], b.uv[set][0], c.uv[set][0]), mix(a.uv[set][1], b.uv[set][1], c.uv[set][1])};
  }
  vec4 color() const {
    return vec4(mix3(a.color, b.color, c.color), mix(a.color[3], b.color[3], c.color[3]));
  }

  const asset::Triangle& triangle;
  const asset::Vertex &a, &b, &c;
  vec3 weights;
};

inline vec3 toVec3(const float* v) { return {v[0], v[1], v[2]}; }

/// Unit, or `fallback` where v vanishes.
inline vec3 unitOr(vec3 v, vec3 fallback) {
  const float length2 = glm::dot(v, v);
  return length2 > 1e-12f ? v / std::sqrt(length2) : fallback;
}

}  // namespace boxlight
