// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>

#include "bake/scene/gltf_texture.h"
#include "bake/scene/gltf_texture_transform.h"

namespace boxlight {

/// What every part of a material is read with: the file, and where textures go.
struct GltfMaterialContext {
  GltfMaterialContext(const GltfDocument& document, Scene& scene)
      : file(document), textures(document, scene), transforms(document.path, scene) {}

  const GltfDocument& file;
  GltfTextures textures;
  GltfTextureTransforms transforms;
};

/// One JSON object of a material, checked by checkDocument: the material itself, one of its extensions or its
/// extras. An absent object has no members, so that each reads as its default.
class GltfMembers {
 public:
  /// `place` names the object in messages.
  GltfMembers(GltfMaterialContext& context, const nlohmann::json* object, std::string place)
      : context_(context), object_(object), place_(std::move(place)) {}

  explicit operator bool() const { return object_ != nullptr; }
  const std::string& place() const { return place_; }
  bool has(const char* key) const { return find(key) != nullptr; }
  GltfMembers child(const char* key) const;
  GltfMembers extension(const char* name) const { return child("extensions").child(name); }

  const nlohmann::json* find(const char* key) const;
  /// A number, clamped to [low, high] with a warning.
  float number(const char* key, double otherwise, double low, double high) const;
  float fraction(const char* key, double otherwise) const { return number(key, otherwise, 0.0, 1.0); }
  /// As many numbers as the array is long, each clamped; false if the member is absent.
  template <size_t N>
  bool numbers(const char* key, float (&values)[N], double low, double high) const {
    return numbers(key, values, N, low, high);
  }
  /// A textureInfo. Errors: unsupported for texture coordinate sets above 1, and those of GltfTextures::find
  /// and GltfTextureTransforms::find.
  asset::TextureRef texture(const char* key, bool srgb) const;
  /// The scale of a normal texture, 1 if open.
  float normalScale(const char* key) const;

  template <class... Args>
  void warn(const char* key, fmt::format_string<Args...> format, Args&&... args) const {
    say(fmt::format("{}.{}", place_, key), fmt::format(format, std::forward<Args>(args)...));
  }
  /// Of the object as a whole.
  void warnHere(const char* message) const { say(place_, message); }

 private:
  bool numbers(const char* key, float* values, size_t count, double low, double high) const;
  float inRange(const char* key, double value, double low, double high) const;
  void say(const std::string& place, const std::string& message) const;

  GltfMaterialContext& context_;
  const nlohmann::json* object_;
  std::string place_;
};

inline constexpr bool kSrgb = true, kLinear = false;
inline constexpr double kNoLimit = 3.4028234663852886e38;  ///< the largest float

}  // namespace boxlight
