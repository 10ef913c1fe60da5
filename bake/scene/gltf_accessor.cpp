// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/gltf_accessor.h"

#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "bake/scene/gltf_error.h"

namespace boxlight {
namespace {

// Sums and interpolations of what is allowed stay finite.
constexpr float kMaxValue = 1e30f;
constexpr std::byte kZeros[16] = {};
// An accessor without a bufferView costs nothing in the file, so nothing else bounds what it asks for.
constexpr uint64_t kMaxZeroElements = uint64_t(1) << 24;

template <class T>
T load(const std::byte* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

uint32_t loadInteger(int componentType, const std::byte* bytes) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load<uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<uint16_t>(bytes);
    default:
      assert(componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
      return load<uint32_t>(bytes);
  }
}

// glTF maps normalised integers to [0,1] or [-1,1]; the lowest signed one is -1 like its neighbour.
float loadFloat(int componentType, bool normalized, const std::byte* bytes) {
  const auto scaled = [normalized](auto integer) {
    const float value = float(integer);
    return normalized ? std::max(value / float(std::numeric_limits<decltype(integer)>::max()), -1.0f) : value;
  };
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return scaled(load<int8_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return scaled(load<uint8_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return scaled(load<int16_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return scaled(load<uint16_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return scaled(load<uint32_t>(bytes));
    default:
      assert(componentType == TINYGLTF_COMPONENT_TYPE_FLOAT);
      return load<float>(bytes);
  }
}

}  // namespace

template <class... Args>
void AccessorReader::invalid(fmt::format_string<Args...> format, Args&&... args) const {
  failAt(ExitCode::invalidInput, file_.path, place_, "{}; export the file again",
         fmt::format(format, std::forward<Args>(args)...));
}

AccessorReader::AccessorReader(const GltfDocument& file, int index, std::string place)
    : file_(file), place_(std::move(place)) {
  const tinygltf::Accessor& accessor = file.model.accessors[size_t(index)];
  if (accessor.count >= std::numeric_limits<uint32_t>::max()) {
    failAt(ExitCode::unsupported, file.path, place_, "{} elements; split the mesh", accessor.count);
  }
  components_ = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
  if (components_ > 4) invalid("a matrix accessor cannot be an attribute");
  componentType_ = accessor.componentType;
  normalized_ = accessor.normalized;
  count_ = uint32_t(accessor.count);
  elementSize_ =
      uint64_t(components_) * uint64_t(tinygltf::GetComponentSizeInBytes(uint32_t(componentType_)));
  stride_ = elementSize_;
  if (accessor.bufferView >= 0) {
    const uint64_t stride = file.model.bufferViews[size_t(accessor.bufferView)].byteStride;
    if (stride != 0) stride_ = stride;
    if (stride_ < elementSize_)
      invalid("byteStride {} is less than the element's {} bytes", stride_, elementSize_);
    data_ = viewBytes(accessor.bufferView, accessor.byteOffset, count_, stride_, elementSize_);
  } else if (count_ > kMaxZeroElements) {
    invalid("{} elements without a bufferView", count_);
  }
  if (accessor.sparse.isSparse) readSparse(accessor);
}

// Checks count elements of `size` bytes, `stride` apart, from `offset` on.
const std::byte* AccessorReader::viewBytes(int bufferView, uint64_t offset, uint64_t count, uint64_t stride,
                                           uint64_t size) const {
  const tinygltf::BufferView& view = file_.model.bufferViews[size_t(bufferView)];
  // count < 2^32 and stride <= 252: the product cannot overflow.
  const uint64_t length = count == 0 ? 0 : (count - 1) * stride + size;
  if (view.byteLength < offset || view.byteLength - offset < length) {
    invalid("{} elements from byte {} need {} bytes, bufferViews[{}] has {}", count, offset, length,
            bufferView, view.byteLength);
  }
  const std::vector<unsigned char>& buffer = file_.model.buffers[size_t(view.buffer)].data;
  return reinterpret_cast<const std::byte*>(buffer.data()) + view.byteOffset + offset;
}

void AccessorReader::readSparse(const tinygltf::Accessor& accessor) {
  const auto& sparse = accessor.sparse;
  const uint64_t count = uint64_t(sparse.count);
  if (count > count_) invalid("sparse.count {} passes the accessor's {}", count, count_);
  const uint64_t size = uint64_t(tinygltf::GetComponentSizeInBytes(uint32_t(sparse.indices.componentType)));
  const std::byte* indices =
      viewBytes(sparse.indices.bufferView, uint64_t(sparse.indices.byteOffset), count, size, size);
  sparseValues_ = viewBytes(sparse.values.bufferView, uint64_t(sparse.values.byteOffset), count, elementSize_,
                            elementSize_);
  sparseIndices_.reserve(count);
  for (uint64_t i = 0; i < count; ++i) {
    const uint32_t index = loadInteger(sparse.indices.componentType, indices + i * size);
    if (index >= count_)
      invalid("sparse index {} is out of range: the accessor has {} elements", index, count_);
    if (i > 0 && index <= sparseIndices_.back())
      invalid("sparse indices must increase, but {} follows {}", index, sparseIndices_.back());
    sparseIndices_.push_back(index);
  }
}

const std::byte* AccessorReader::element(uint32_t i) const {
  assert(i < count_);
  if (!sparseIndices_.empty()) {
    const auto it = std::lower_bound(sparseIndices_.begin(), sparseIndices_.end(), i);
    if (it != sparseIndices_.end() && *it == i) {
      return sparseValues_ + uint64_t(it - sparseIndices_.begin()) * elementSize_;
    }
  }
  return data_ ? data_ + uint64_t(i) * stride_ : kZeros;
}

vec4 AccessorReader::floats(uint32_t i) const {
  const std::byte* bytes = element(i);
  const uint64_t size = elementSize_ / uint64_t(components_);
  vec4 value(0.0f);
  for (int c = 0; c < components_; ++c) {
    value[c] = loadFloat(componentType_, normalized_, bytes + uint64_t(c) * size);
    if (!(std::abs(value[c]) <= kMaxValue)) invalid("element {} is not finite, or beyond 1e30", i);
  }
  return value;
}

uint32_t AccessorReader::integer(uint32_t i) const { return loadInteger(componentType_, element(i)); }

}  // namespace boxlight
