// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bake/scene/gltf_document.h"
#include "common/base/math.h"

namespace boxlight {

/// One accessor, range-checked by the constructor; its elements can then be read in any order. Sparse
/// substitution, strides and normalisation are applied on the way. The document must outlive it.
class AccessorReader {
 public:
  /// `place` names the use of the accessor in messages: meshes[0].primitives[1].attributes.POSITION.
  /// Errors: invalidInput if it passes its bufferView or is malformed, unsupported past 2^32 - 1 elements.
  AccessorReader(const GltfDocument& file, int accessor, std::string place);

  uint32_t count() const { return count_; }
  int components() const { return components_; }        ///< 1 to 4
  int componentType() const { return componentType_; }  ///< glTF's code, 5120 to 5126
  bool normalized() const { return normalized_; }

  /// Element i as floats; missing components are 0. Error: invalidInput if one is not finite or beyond
  /// +-1e30.
  vec4 floats(uint32_t i) const;
  /// Element i of an accessor of unsigned integers.
  uint32_t integer(uint32_t i) const;

  const std::string& place() const { return place_; }

 private:
  template <class... Args>
  [[noreturn]] void invalid(fmt::format_string<Args...> format, Args&&... args) const;
  const std::byte* viewBytes(int bufferView, uint64_t offset, uint64_t count, uint64_t stride,
                             uint64_t size) const;
  void readSparse(const tinygltf::Accessor& accessor);
  const std::byte* element(uint32_t i) const;

  const GltfDocument& file_;
  std::string place_;
  uint32_t count_ = 0;
  int components_ = 0, componentType_ = 0;
  bool normalized_ = false;
  uint64_t elementSize_ = 0, stride_ = 0;
  const std::byte* data_ = nullptr;  // null: zeros
  std::vector<uint32_t> sparseIndices_;
  const std::byte* sparseValues_ = nullptr;
};

}  // namespace boxlight
