// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bake/scene/gltf_members.h"

namespace boxlight {

/// What the Khronos extensions of a glTF material, and its emission, add to its core: a record that adds
/// nothing where all of them are absent or have no effect (a factor of 0, an index of refraction of 1.5).
/// Sets kUnlit and kVolume in material.flags. Values out of range are clamped with a warning, as are
/// extensions next to KHR_materials_unlit ignored with one. Errors: those of GltfMembers::texture.
asset::MaterialExtension readMaterialExtensions(const GltfMembers& source, asset::Material& material);

}  // namespace boxlight
