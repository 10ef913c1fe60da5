// SPDX-License-Identifier: Apache-2.0
#include "tests/support/meshes.h"

#include <cmath>
#include <random>

#include "tests/support/scenes.h"

namespace boxlight::test {
namespace {

dvec3 faceVectorOf(const Scene& scene, const asset::Triangle& triangle) {
  dvec3 p[3];
  for (int k = 0; k < 3; ++k) {
    const float* q = scene.vertices[triangle.vertex[k]].position;
    p[k] = {q[0], q[1], q[2]};
  }
  return glm::cross(p[1] - p[0], p[2] - p[0]);
}

uint32_t addVertex(Scene& scene, vec3 position, vec3 normal) {
  asset::Vertex vertex{};
  for (int c = 0; c < 3; ++c) vertex.position[c] = position[c], vertex.normal[c] = normal[c];
  for (float& c : vertex.color) c = 1;
  scene.vertices.push_back(vertex);
  return uint32_t(scene.vertices.size() - 1);
}

}  // namespace

void addMesh(Scene& scene, const std::vector<vec3>& positions, const std::vector<uvec3>& triangles,
             const std::vector<vec3>& normals, uint32_t material) {
  scene.hasTexcoord[0] = scene.hasTexcoord[1] = false;
  const auto first = uint32_t(scene.vertices.size());
  for (size_t v = 0; v < normals.size(); ++v) addVertex(scene, positions[v], normals[v]);
  for (const uvec3& t : triangles) {
    const dvec3 face = glm::cross(dvec3(positions[t.y]) - dvec3(positions[t.x]),
                                  dvec3(positions[t.z]) - dvec3(positions[t.x]));
    if (!(glm::length(face) > 0)) continue;
    asset::Triangle triangle{{}, material};
    for (int k = 0; k < 3; ++k)
      triangle.vertex[k] =
          normals.empty() ? addVertex(scene, positions[t[k]], vec3(glm::normalize(face))) : first + t[k];
    scene.triangles.push_back(triangle);
  }
  finish(scene);
}

void addBox(Scene& scene, vec3 low, vec3 high) {
  const vec3 d = high - low, x(d.x, 0, 0), y(0, d.y, 0), z(0, 0, d.z);
  const auto quad = [&scene](vec3 corner, vec3 u, vec3 v) {
    addMesh(scene, {corner, corner + u, corner + u + v, corner + v}, {{0, 1, 2}, {0, 2, 3}});
  };
  quad(low, y, x);
  quad(low + z, x, y);
  quad(low, x, z);
  quad(low + y, z, x);
  quad(low, z, y);
  quad(low + x, y, z);
}

void addSurface(Scene& scene, uvec2 cells, const std::function<vec3(vec2)>& position) {
  std::vector<vec3> positions, normals;
  std::vector<uvec3> triangles;
  const auto at = [&](uint32_t i, uint32_t j) { return j * (cells.x + 1) + i; };
  const float e = 1e-3f;
  for (uint32_t j = 0; j <= cells.y; ++j)
    for (uint32_t i = 0; i <= cells.x; ++i) {
      const vec2 uv = vec2(i, j) / vec2(cells);
      positions.push_back(position(uv));
      const vec3 du = position(uv + vec2(e, 0)) - position(uv - vec2(e, 0));
      const vec3 dv = position(uv + vec2(0, e)) - position(uv - vec2(0, e));
      normals.push_back(glm::normalize(glm::cross(du, dv)));
    }
  for (uint32_t j = 0; j < cells.y; ++j)
    for (uint32_t i = 0; i < cells.x; ++i) {
      triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  addMesh(scene, positions, triangles, normals);
}

void addTorus(Scene& scene, vec3 centre, float radius, float tube, uint32_t segments) {
  // Angles in whole steps, so that the seam closes bit for bit.
  const auto turn = [segments](float u) {
    const float steps = u * float(segments);
    return 2 * kPi * (steps >= float(segments) ? steps - float(segments) : steps) / float(segments);
  };
  addSurface(scene, uvec2(segments, segments), [=](vec2 uv) {
    const float a = turn(uv.x), b = turn(uv.y), r = radius + tube * std::cos(b);
    return centre + vec3(r * std::cos(a), tube * std::sin(b), -r * std::sin(a));
  });
}

void addMoebiusStrip(Scene& scene, uint32_t segments) {
  addSurface(scene, {segments, 4}, [](vec2 uv) {
    const bool closed = uv.x == 1.0f;  // the end is the start upside down, bit for bit
    const float a = closed ? 0.0f : 2 * kPi * uv.x, w = 0.4f * (closed ? 0.5f - uv.y : uv.y - 0.5f);
    const float r = 1 + w * std::cos(a / 2);
    return vec3(r * std::cos(a), w * std::sin(a / 2), -r * std::sin(a));
  });
}

void addSpiral(Scene& scene, uint32_t turns, uint32_t segmentsPerTurn) {
  addSurface(scene, {turns * segmentsPerTurn, 2}, [turns](vec2 uv) {
    const float a = 2 * kPi * uv.x * float(turns), r = 2 - uv.y;
    return vec3(r * std::cos(a), 0.5f * uv.x * float(turns), -r * std::sin(a));
  });
}

void addFan(Scene& scene, uint32_t sheets) {
  std::vector<vec3> positions = {{0, 0, 0}, {0, 1, 0}};
  std::vector<uvec3> triangles;
  for (uint32_t s = 0; s < sheets; ++s) {
    const float a = 2 * kPi * float(s) / float(sheets);
    const auto outer = uint32_t(positions.size());
    positions.emplace_back(std::cos(a), 0, std::sin(a));
    positions.emplace_back(std::cos(a), 1, std::sin(a));
    triangles.emplace_back(0, outer, outer + 1);
    triangles.emplace_back(0, outer + 1, 1);
  }
  addMesh(scene, positions, triangles);
}

void addLeaves(Scene& scene, uint32_t count, float side) {
  std::mt19937 random(7);
  const auto uniform = [&random] { return float(random() >> 8) * 0x1p-24f; };
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;
  for (uint32_t i = 0; i < count; ++i) {
    const vec3 centre(uniform(), uniform(), uniform());
    const float z = 2 * uniform() - 1, phi = 2 * kPi * uniform(), r = std::sqrt(1 - z * z);
    vec3 u, v;
    orthonormalBasis(vec3(r * std::cos(phi), r * std::sin(phi), z), u, v);
    const uint32_t first = 4 * i;
    positions.insert(positions.end(),
                     {centre, centre + side * u, centre + side * (u + v), centre + side * v});
    triangles.emplace_back(first, first + 1, first + 2);
    triangles.emplace_back(first, first + 2, first + 3);
  }
  addMesh(scene, positions, triangles);
}

void place(Scene& scene, float scale, vec3 offset) {
  for (asset::Vertex& vertex : scene.vertices)
    for (int c = 0; c < 3; ++c) vertex.position[c] = scale * vertex.position[c] + offset[c];
  std::erase_if(scene.triangles,
                [&scene](const asset::Triangle& t) { return !(glm::length(faceVectorOf(scene, t)) > 0); });
  finish(scene);
}

}  // namespace boxlight::test
