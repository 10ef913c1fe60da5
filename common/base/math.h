// SPDX-License-Identifier: Apache-2.0
#pragma once

// The vector types of the whole project. Space is glTF's: right-handed, +Y up, metres.
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <numbers>

namespace boxlight {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;
using glm::ivec2;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

using Rgb = glm::vec3;  ///< linear Rec.709

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr double kPiDouble = std::numbers::pi;

inline float maxComponent(Rgb c) { return std::max(c.x, std::max(c.y, c.z)); }
inline float luminance(Rgb c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

/// Orthonormal tangents of the unit vector n, without a branch at the poles.
/// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
inline void orthonormalBasis(vec3 n, vec3& tangent, vec3& bitangent) {
  const float sign = n.z >= 0.0f ? 1.0f : -1.0f;
  const float a = -1.0f / (sign + n.z);
  const float b = n.x * n.y * a;
  tangent = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
  bitangent = {b, sign + n.y * n.y * a, -n.y};
}

}  // namespace boxlight
