// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "bake/scene/scene.h"

namespace boxlight {

/// Reads the default scene of a .gltf or .glb file (glTF 2.0): every triangle of its node tree in world
/// space, in the order of the tree, with the materials and textures that they use. What is left out (points,
/// lines, skinning, animation, extensions that are not supported, triangles without area) is said in the log.
/// The same file gives the same scene. Errors, as "file: place in the document: reason; remedy": io if the
/// file cannot be read; invalidInput if it is damaged, breaks the specification or shows no triangle;
/// unsupported for extensionsRequired that are not supported, for compressed data and for other kinds of
/// content that cannot be honoured.
Scene loadGltf(const std::filesystem::path& path);

}  // namespace boxlight
