// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/base/math.h"

// How albedo tables over perceptual roughness and n.v are laid out: kSize nodes along each axis, even in the
// square roots, where grazing angles and smooth surfaces need them; node i is (i / (kSize - 1))^2 and both
// ends of [0,1] are nodes.

namespace boxlight::albedo_nodes {

inline constexpr uint32_t kSize = 64;

/// The node below a roughness or cosine and the fraction to the next.
struct Node {
  uint32_t index;
  float fraction;
  explicit Node(float parameter) {
    const float position = std::sqrt(std::clamp(parameter, 0.0f, 1.0f)) * float(kSize - 1);
    index = std::min(uint32_t(position), kSize - 2);
    fraction = position - float(index);
  }
};

/// The parameter at a node: nodes are even in its square root.
inline float parameterAt(uint32_t node) {
  const float root = float(node) / float(kSize - 1);
  return root * root;
}

/// A view direction of that cosine to the normal.
inline vec3 directionAt(float nDotV) {
  return {std::sqrt(std::max(0.0f, 1.0f - nDotV * nDotV)), 0.0f, nDotV};
}

/// Nodes are [nDotV][roughness]; arguments are clamped to [0,1].
template <class T>
T bilinear(const std::vector<T>& nodes, float roughness, float nDotV) {
  const Node x(roughness), y(nDotV);
  const T* row = &nodes[y.index * kSize + x.index];
  return glm::mix(glm::mix(row[0], row[1], x.fraction), glm::mix(row[kSize], row[kSize + 1], x.fraction),
                  y.fraction);
}

}  // namespace boxlight::albedo_nodes
