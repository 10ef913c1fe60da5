// SPDX-License-Identifier: Apache-2.0
#include "common/light/view_sphere.h"

#include <cassert>
#include <cmath>
#include <map>

namespace boxlight {
namespace {

constexpr float kGolden = std::numbers::phi_v<float>;

const std::array<vec3, 12> kIcosahedron = {{{-1, kGolden, 0},
                                            {1, kGolden, 0},
                                            {-1, -kGolden, 0},
                                            {1, -kGolden, 0},
                                            {0, -1, kGolden},
                                            {0, 1, kGolden},
                                            {0, -1, -kGolden},
                                            {0, 1, -kGolden},
                                            {kGolden, 0, -1},
                                            {kGolden, 0, 1},
                                            {-kGolden, 0, -1},
                                            {-kGolden, 0, 1}}};

// Counter-clockwise seen from outside.
constexpr std::array<std::array<uint32_t, 3>, 20> kFaces = {
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

/// A lattice point of a face as integer weights of the icosahedron's corners: equal on both sides of a shared
/// edge.
using LatticeKey = std::array<std::pair<uint32_t, uint32_t>, 3>;

LatticeKey latticeKey(const std::array<uint32_t, 3>& face, std::array<uint32_t, 3> weights) {
  LatticeKey key;
  for (int k = 0; k < 3; ++k) key[k] = weights[k] ? std::pair{face[k], weights[k]} : std::pair{~0u, 0u};
  std::sort(key.begin(), key.end());
  return key;
}

}  // namespace

ViewSphere::ViewSphere(uint32_t frequency) : frequency_(frequency) {
  assert(frequency >= 1);
  subdivide();
  connect();
}

void ViewSphere::subdivide() {
  std::map<LatticeKey, uint32_t> index;
  const uint32_t f = frequency_;
  for (const auto& face : kFaces) {
    // Corner (i, j): i steps towards the face's second corner, j towards its third.
    auto vertex = [&](uint32_t i, uint32_t j) {
      const std::array<uint32_t, 3> weights = {f - i - j, i, j};
      const auto [entry, isNew] = index.try_emplace(latticeKey(face, weights), viewCount());
      if (isNew) {
        vec3 sum(0.0f);
        for (const auto& [corner, weight] : entry->first)
          if (weight) sum += float(weight) * kIcosahedron[corner];
        directions_.push_back(glm::normalize(sum));
      }
      return entry->second;
    };
    for (uint32_t i = 0; i < f; ++i)
      for (uint32_t j = 0; i + j < f; ++j) {
        triangles_.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
        if (i + j + 1 < f) triangles_.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
  }
}

void ViewSphere::connect() {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> triangleOfEdge;  // directed
  adjacent_.resize(viewCount());
  for (uint32_t t = 0; t < triangles_.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = triangles_[t][(k + 1) % 3], b = triangles_[t][(k + 2) % 3];
      triangleOfEdge[{a, b}] = t;
      adjacent_[a].push_back(b);
    }
  for (auto& list : adjacent_) std::sort(list.begin(), list.end());
  neighbours_.resize(triangles_.size());
  for (uint32_t t = 0; t < triangles_.size(); ++t)
    for (int k = 0; k < 3; ++k)
      neighbours_[t][k] = triangleOfEdge.at({triangles_[t][(k + 2) % 3], triangles_[t][(k + 1) % 3]});
}

ViewBlend ViewSphere::locate(vec3 direction, uint32_t start) const {
  uint32_t t = start;
  // The bound is never reached on a unit direction; it ends the walk on one that is not.
  for (size_t step = 0; step <= triangles_.size(); ++step) {
    const uvec3 triangle = triangles_[t];
    const vec3 a = directions_[triangle.x], b = directions_[triangle.y], c = directions_[triangle.z];
    const vec3 weight(glm::dot(direction, glm::cross(b, c)), glm::dot(direction, glm::cross(c, a)),
                      glm::dot(direction, glm::cross(a, b)));
    const int lowest = weight.x <= weight.y ? (weight.x <= weight.z ? 0 : 2) : (weight.y <= weight.z ? 1 : 2);
    if (weight[lowest] >= -1e-6f || step == triangles_.size()) {
      const vec3 positive = glm::max(weight, vec3(0.0f));
      return {{triangle.x, triangle.y, triangle.z}, positive / (positive.x + positive.y + positive.z), t};
    }
    t = neighbours_[t][lowest];
  }
  return {};
}

vec3 raiseAboveHorizon(vec3 direction, vec3 normal, float cosine) {
  const float current = glm::dot(direction, normal);
  if (current >= cosine) return direction;
  vec3 along = direction - current * normal;
  const float length = glm::length(along);
  if (length > 1e-6f) {
    along /= length;
  } else {
    vec3 unused;
    orthonormalBasis(normal, along, unused);
  }
  return glm::normalize(cosine * normal + std::sqrt(1.0f - cosine * cosine) * along);
}

std::vector<bool> viewsOfHemisphere(const ViewSphere& sphere, vec3 normal) {
  std::vector<bool> needed(sphere.viewCount(), false);
  for (const uvec3& triangle : sphere.triangles()) {
    bool touches = false;
    for (int k = 0; k < 3; ++k) touches |= glm::dot(sphere.directions()[triangle[k]], normal) > 0.0f;
    for (int k = 0; touches && k < 3; ++k) needed[triangle[k]] = true;
  }
  return needed;
}

}  // namespace boxlight
