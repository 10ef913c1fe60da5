// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_check.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bake/scene/gltf_error.h"

namespace boxlight {
namespace {

using Json = nlohmann::json;

// What a value must be.
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
struct TextureInfo {};
using Kind =
    std::variant<Index, Count, Number, Numbers, Boolean, Text, Object, Array, Code, Name, TextureInfo>;

// In a pattern, [] is every element of an array and * every member of an object.
struct Rule {
  std::string_view pattern;
  Kind kind;
  bool required = false;
};

constexpr bool kRequired = true;
constexpr uint64_t kMaxInt = std::numeric_limits<int>::max();  // where tinygltf keeps an int

const std::vector<Rule>& rules() {
  static const std::vector<Rule> table = {
      {"scene", Index{"scenes"}},
      {"scenes[].nodes[]", Index{"nodes"}},
      {"nodes[].children[]", Index{"nodes"}},
      {"nodes[].mesh", Index{"meshes"}},
      {"nodes[].matrix", Numbers{16}},
      {"nodes[].translation", Numbers{3}},
      {"nodes[].rotation", Numbers{4}},
      {"nodes[].scale", Numbers{3}},
      {"meshes[].primitives", Array{}, kRequired},
      {"meshes[].primitives[].attributes", Object{}, kRequired},
      {"meshes[].primitives[].attributes.*", Index{"accessors"}},
      {"meshes[].primitives[].indices", Index{"accessors"}},
      {"meshes[].primitives[].material", Index{"materials"}},
      {"meshes[].primitives[].mode", Code{{0, 1, 2, 3, 4, 5, 6}}},
      {"accessors[].bufferView", Index{"bufferViews"}},
      {"accessors[].byteOffset", Count{}},
      {"accessors[].count", Count{1}, kRequired},
      {"accessors[].componentType", Code{{5120, 5121, 5122, 5123, 5125, 5126}}, kRequired},
      {"accessors[].type", Name{{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}}, kRequired},
      {"accessors[].normalized", Boolean{}},
      {"accessors[].sparse.count", Count{1, kMaxInt}, kRequired},
      {"accessors[].sparse.indices", Object{}, kRequired},
      {"accessors[].sparse.indices.bufferView", Index{"bufferViews"}, kRequired},
      {"accessors[].sparse.indices.byteOffset", Count{0, kMaxInt}},
      {"accessors[].sparse.indices.componentType", Code{{5121, 5123, 5125}}, kRequired},
      {"accessors[].sparse.values", Object{}, kRequired},
      {"accessors[].sparse.values.bufferView", Index{"bufferViews"}, kRequired},
      {"accessors[].sparse.values.byteOffset", Count{0, kMaxInt}},
      {"bufferViews[].buffer", Index{"buffers"}, kRequired},
      {"bufferViews[].byteOffset", Count{}},
      {"bufferViews[].byteLength", Count{1}, kRequired},
      {"bufferViews[].byteStride", Count{0, 252}},
      {"buffers[].byteLength", Count{1}, kRequired},
      {"buffers[].uri", Text{}},
      {"images[].bufferView", Index{"bufferViews"}},
      {"images[].uri", Text{}},
      {"samplers[].wrapS", Code{{10497, 33071, 33648}}},
      {"samplers[].wrapT", Code{{10497, 33071, 33648}}},
      {"samplers[].magFilter", Code{{9728, 9729}}},
      {"samplers[].minFilter", Code{{9728, 9729, 9984, 9985, 9986, 9987}}},
      {"textures[].sampler", Index{"samplers"}},
      {"textures[].source", Index{"images"}},
      {"materials[].pbrMetallicRoughness.baseColorFactor", Numbers{4}},
      {"materials[].pbrMetallicRoughness.baseColorTexture", TextureInfo{}},
      {"materials[].pbrMetallicRoughness.metallicFactor", Number{}},
      {"materials[].pbrMetallicRoughness.roughnessFactor", Number{}},
      {"materials[].pbrMetallicRoughness.metallicRoughnessTexture", TextureInfo{}},
      {"materials[].normalTexture", TextureInfo{}},
      {"materials[].emissiveFactor", Numbers{3}},
      {"materials[].alphaMode", Name{{"OPAQUE", "MASK", "BLEND"}}},
      {"materials[].alphaCutoff", Number{}},
      {"materials[].doubleSided", Boolean{}},
      {"materials[].extensions.KHR_materials_specular.specularFactor", Number{}},
      {"materials[].extensions.KHR_materials_specular.specularTexture", TextureInfo{}},
      {"materials[].extensions.KHR_materials_specular.specularColorFactor", Numbers{3}},
      {"materials[].extensions.KHR_materials_specular.specularColorTexture", TextureInfo{}},
  };
  return table;
}

class Checker {
 public:
  Checker(const std::filesystem::path& path, const Json& document) : path_(path), document_(document) {}

  void run() {
    for (const Rule& rule : rules()) {
      rule_ = &rule;
      walk(document_, rule.pattern);
    }
    checkBufferViews();
  }

 private:
  template <class... Args>
  [[noreturn]] void invalid(fmt::format_string<Args...> format, Args&&... args) const {
    failAt(ExitCode::invalidInput, path_, place_, "{}; export the file again",
           fmt::format(format, std::forward<Args>(args)...));
  }

  // Follows one step of the pattern; place_ grows and shrinks along.
  void walk(const Json& value, std::string_view rest) {
    if (rest.empty()) return std::visit([&](const auto& kind) { check(value, kind); }, rule_->kind);
    const size_t length = place_.size();
    if (rest.starts_with("[]")) {
      if (!value.is_array()) invalid("must be an array");
      for (size_t i = 0; i < value.size(); ++i) {
        place_ += '[' + std::to_string(i) + ']';
        walk(value[i], rest.substr(2));
        place_.resize(length);
      }
      return;
    }
    if (rest.front() == '.') rest.remove_prefix(1);
    if (!value.is_object()) invalid("must be an object");
    const size_t end = std::min(rest.find_first_of(".["), rest.size());
    const std::string key(rest.substr(0, end));
    for (auto it = key == "*" ? value.begin() : value.find(key); it != value.end(); ++it) {
      if (!place_.empty()) place_ += '.';
      place_ += it.key();
      walk(it.value(), rest.substr(end));
      place_.resize(length);
      if (key != "*") return;
    }
    if (rule_->required && end == rest.size() && key != "*") invalid("'{}' is missing", key);
  }

  void check(const Json& value, const Index& kind) const {
    const auto array = document_.find(kind.array);
    const size_t size = array != document_.end() && array->is_array() ? array->size() : 0;
    if (!value.is_number_unsigned())
      invalid("must be an index, a whole number from 0, but is {}", value.dump());
    if (value.get<uint64_t>() >= size)
      invalid("index {} is out of range: {} has {}", value.dump(), kind.array, size);
  }
  void check(const Json& value, const Count& kind) const {
    if (!value.is_number_unsigned()) invalid("must be a whole number from 0, but is {}", value.dump());
    if (value.get<uint64_t>() < kind.atLeast)
      invalid("must be at least {}, but is {}", kind.atLeast, value.dump());
    if (value.get<uint64_t>() > kind.atMost) invalid("{} is out of range", value.dump());
  }
  void check(const Json& value, const Number&) const {
    if (!value.is_number()) invalid("must be a number");
  }
  void check(const Json& value, const Numbers& kind) const {
    const bool fits = value.is_array() && value.size() == kind.length &&
                      std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_number(); });
    if (!fits) invalid("must be an array of {} numbers", kind.length);
  }
  void check(const Json& value, const Boolean&) const {
    if (!value.is_boolean()) invalid("must be true or false");
  }
  void check(const Json& value, const Text&) const {
    if (!value.is_string()) invalid("must be a string");
  }
  void check(const Json& value, const Object&) const {
    if (!value.is_object()) invalid("must be an object");
  }
  void check(const Json& value, const Array&) const {
    if (!value.is_array()) invalid("must be an array");
  }
  void check(const Json& value, const Code& kind) const {
    const auto is = [&](int code) { return value.is_number_integer() && value == code; };
    if (std::none_of(kind.allowed.begin(), kind.allowed.end(), is))
      invalid("{} is not a value of glTF 2.0", value.dump());
  }
  void check(const Json& value, const Name& kind) const {
    const auto is = [&](std::string_view name) {
      return value.is_string() && value.get_ref<const std::string&>() == name;
    };
    if (std::none_of(kind.allowed.begin(), kind.allowed.end(), is))
      invalid("{} is not a value of glTF 2.0", value.dump());
  }
  void check(const Json& value, const TextureInfo&) {
    if (!value.is_object()) invalid("must be an object");
    if (!value.contains("index")) invalid("'index' is missing");
    checkMember(value, "index", Index{"textures"});
    checkMember(value, "texCoord", Count{0, kMaxInt});
    checkMember(value, "scale", Number{});
  }
  template <class MemberKind>
  void checkMember(const Json& value, const char* key, const MemberKind& kind) {
    const auto member = value.find(key);
    if (member == value.end()) return;
    const size_t length = place_.size();
    place_ += '.';
    place_ += key;
    check(*member, kind);
    place_.resize(length);
  }

  void checkBufferViews() {
    const auto views = document_.find("bufferViews");
    if (views == document_.end()) return;
    for (size_t i = 0; i < views->size(); ++i) {
      const Json& view = (*views)[i];
      place_ = "bufferViews[" + std::to_string(i) + "]";
      const uint64_t offset = view.value("byteOffset", uint64_t(0)), length = view["byteLength"];
      const uint64_t size = document_["buffers"][view["buffer"].get<size_t>()]["byteLength"];
      if (size < offset || size - offset < length) {
        invalid("bytes {} to {} pass the end of buffers[{}], which has {}", offset, offset + length,
                view["buffer"].get<size_t>(), size);
      }
    }
  }

  const std::filesystem::path& path_;
  const Json& document_;
  const Rule* rule_ = nullptr;
  std::string place_;
};

}  // namespace

void checkDocument(const std::filesystem::path& path, const Json& document) { Checker(path, document).run(); }

}  // namespace boxlight
