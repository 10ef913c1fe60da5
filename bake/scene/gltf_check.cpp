// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_check.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>

#include "bake/scene/gltf_error.h"
#include "bake/scene/gltf_rules.h"

namespace boxlight {
namespace {

using Json = nlohmann::json;
using namespace gltf_rules;

class Checker {
 public:
  Checker(const std::filesystem::path& path, const Json& document) : path_(path), document_(document) {}

  void run() {
    for (const Rule& rule : gltf_rules::all()) {
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
      if (key != "extras" || it->is_object()) walk(it.value(), rest.substr(end));
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
    checkTransform(value);
  }
  // KHR_texture_transform.
  void checkTransform(const Json& textureInfo) {
    const auto extensions = textureInfo.find("extensions");
    if (extensions == textureInfo.end()) return;
    const size_t length = place_.size();
    place_ += ".extensions";
    check(*extensions, Object{});
    checkMember(*extensions, "KHR_texture_transform", Object{});
    if (const auto transform = extensions->find("KHR_texture_transform"); transform != extensions->end()) {
      place_ += ".KHR_texture_transform";
      checkMember(*transform, "offset", Numbers{2});
      checkMember(*transform, "rotation", Number{});
      checkMember(*transform, "scale", Numbers{2});
      checkMember(*transform, "texCoord", Count{0, kMaxInt});
    }
    place_.resize(length);
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
