// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace boxlight::gltf_rules {

/// What a value must be.
struct Index {
  const char* array;  // points into this top-level array
};
struct Count {
  uint64_t atLeast = 0;
  uint64_t atMost = uint64_t(1) << 53;  // what JSON numbers hold exactly; sums of two never overflow
};
struct Number {};
struct Numbers {
  size_t length;
};
struct Boolean {};
struct Text {};
struct Object {};
struct Array {};
struct Code {
  std::vector<int> allowed;
};
struct Name {
  std::vector<std::string_view> allowed;
};
struct TextureInfo {};  // with KHR_texture_transform
using Kind =
    std::variant<Index, Count, Number, Numbers, Boolean, Text, Object, Array, Code, Name, TextureInfo>;

/// In a pattern, [] is every element of an array and * every member of an object. What `extras` holds is
/// looked at only where it is an object, since it may be anything.
struct Rule {
  std::string_view pattern;
  Kind kind;
  bool required = false;
};

inline constexpr uint64_t kMaxInt = std::numeric_limits<int>::max();  ///< where tinygltf keeps an int

/// The part of the glTF 2.0 schema, and of those of the supported extensions, that loadGltf relies on.
std::span<const Rule> all();

}  // namespace boxlight::gltf_rules
