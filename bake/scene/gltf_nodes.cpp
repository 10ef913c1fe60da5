// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_nodes.h"

#include <glm/gtc/quaternion.hpp>
#include <string>

#include "bake/scene/gltf_error.h"
#include "bake/scene/scene.h"

namespace boxlight {
namespace {

std::string placeOf(int node) { return fmt::format("nodes[{}]", node); }

glm::dmat4 readMatrix(const GltfDocument& file, int node, const std::vector<double>& values) {
  glm::dmat4 matrix;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) matrix[column][row] = values[size_t(column) * 4 + size_t(row)];
  }
  if (matrix[0][3] != 0 || matrix[1][3] != 0 || matrix[2][3] != 0 || matrix[3][3] != 1) {
    failAt(ExitCode::invalidInput, file.path, placeOf(node) + ".matrix",
           "the bottom row must be 0 0 0 1; export the file again");
  }
  return matrix;
}

glm::dmat4 readTransform(const GltfDocument& file, int index) {
  const tinygltf::Node& node = file.model.nodes[size_t(index)];
  if (!node.matrix.empty()) {
    const nlohmann::json& json = file.json["nodes"][size_t(index)];
    if (json.contains("translation") || json.contains("rotation") || json.contains("scale")) {
      failAt(ExitCode::invalidInput, file.path, placeOf(index),
             "has a matrix and translation, rotation or scale; export the file again");
    }
    return readMatrix(file, index, node.matrix);
  }
  glm::dmat4 matrix(1.0);
  if (const auto& r = node.rotation; !r.empty()) {
    const glm::dquat rotation(r[3], r[0], r[1], r[2]);
    if (!(glm::length(rotation) > 0)) {
      failAt(ExitCode::invalidInput, file.path, placeOf(index) + ".rotation",
             "is no unit quaternion; export the file again");
    }
    matrix = glm::mat4_cast(glm::normalize(rotation));
  }
  if (const auto& s = node.scale; !s.empty()) {
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= s[size_t(axis)];
  }
  if (const auto& t = node.translation; !t.empty()) matrix[3] = {t[0], t[1], t[2], 1.0};
  return matrix;
}

/// The node's own texel scale, else its parent's.
float readTexelScale(const GltfDocument& file, int index, float parent) {
  constexpr const char* kKey = "boxlight_texel_scale";
  const nlohmann::json& node = file.json["nodes"][size_t(index)];
  const auto extras = node.find("extras");
  if (extras == node.end() || !extras->is_object() || !extras->contains(kKey)) return parent;
  const nlohmann::json& value = (*extras)[kKey];
  if (!value.is_number() ||
      !(value.get<double>() >= kLeastTexelScale && value.get<double>() <= kMostTexelScale)) {
    failAt(ExitCode::invalidInput, file.path, fmt::format("{}.extras.{}", placeOf(index), kKey),
           "must be a number from {} to {}; 1 leaves the texel density as it is", kLeastTexelScale,
           kMostTexelScale);
  }
  return value.get<float>();
}

std::vector<int> rootNodes(const GltfDocument& file) {
  const tinygltf::Model& model = file.model;
  if (!model.scenes.empty()) return model.scenes[size_t(std::max(model.defaultScene, 0))].nodes;
  std::vector<bool> isChild(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) isChild[size_t(child)] = true;
  }
  std::vector<int> roots;
  for (size_t i = 0; i < model.nodes.size(); ++i) {
    if (!isChild[i]) roots.push_back(int(i));
  }
  if (roots.empty() && !model.nodes.empty()) {
    failAt(ExitCode::invalidInput, file.path, "nodes",
           "every node is a child: the tree has a cycle; export the file again");
  }
  return roots;
}

}  // namespace

std::vector<MeshInstance> collectInstances(const GltfDocument& file) {
  struct Visit {
    int node;
    glm::dmat4 parent;
    float texelScale;
  };
  const std::vector<int> roots = rootNodes(file);
  std::vector<Visit> stack;  // not recursion: a hostile tree is as deep as it has nodes
  for (auto root = roots.rbegin(); root != roots.rend(); ++root)
    stack.push_back({*root, glm::dmat4(1.0), 1.0f});

  std::vector<bool> visited(file.model.nodes.size(), false);
  std::vector<MeshInstance> instances;
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    if (visited[size_t(visit.node)]) {
      failAt(ExitCode::invalidInput, file.path, placeOf(visit.node),
             "reached twice: the nodes have a cycle or one has two parents; export the file again");
    }
    visited[size_t(visit.node)] = true;
    const tinygltf::Node& node = file.model.nodes[size_t(visit.node)];
    const glm::dmat4 toWorld = visit.parent * readTransform(file, visit.node);
    const float texelScale = readTexelScale(file, visit.node, visit.texelScale);
    if (node.mesh >= 0) instances.push_back({visit.node, node.mesh, toWorld, texelScale});
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      stack.push_back({*child, toWorld, texelScale});
  }
  return instances;
}

}  // namespace boxlight
