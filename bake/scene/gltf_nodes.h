// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "bake/scene/gltf_document.h"
#include "common/base/math.h"

namespace boxlight {

/// A mesh of the document where a node puts it.
struct MeshInstance {
  int node, mesh;
  glm::dmat4 toWorld;  ///< affine
  float texelScale;  ///< extras.boxlight_texel_scale of the node or its nearest ancestor that has one, else 1
};

/// The meshes of the default scene (of scene 0 if none is named, of all root nodes if there are no scenes) in
/// depth-first order. Errors: invalidInput if the nodes are no forest, a transform is not affine, or a texel
/// scale is no number in [.01, 100].
std::vector<MeshInstance> collectInstances(const GltfDocument& file);

}  // namespace boxlight
