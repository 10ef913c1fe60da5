// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bake/scene/gltf_document.h"
#include "bake/scene/mesh.h"

namespace boxlight {

/// meshes[i].primitives[j], as messages name it.
std::string primitivePlace(int mesh, size_t primitive);

/// One primitive of mode 4, 5 or 6 with a POSITION, in the space of its mesh; only vertices that a triangle
/// uses. Flat normals are computed where NORMAL is absent (TANGENT is then ignored), as the specification
/// demands. Errors: invalidInput or unsupported, naming the attribute.
Mesh readPrimitive(const GltfDocument& file, int mesh, size_t primitive);

}  // namespace boxlight
