// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/vulkan/device.h"

namespace boxlight::gpu {

/// A storage buffer in the device's own memory.
class Buffer {
 public:
  /// `size` bytes, at least 16. Error(ExitCode::runtime) naming `name` if that is more than a storage buffer
  /// may hold.
  Buffer(const Device& device, const char* name, uint64_t size);
  ~Buffer();
  Buffer(Buffer&&) noexcept;
  Buffer& operator=(Buffer&&) noexcept;

  uint64_t size() const { return size_; }
  struct Native;
  Native& native() const { return *native_; }

 private:
  uint64_t size_;
  std::unique_ptr<Native> native_;
};

/// Copies bytes to or from the device and waits. The range must lie inside the buffer.
void upload(Device& device, const Buffer& buffer, std::span<const std::byte> bytes, uint64_t offset = 0);
void download(Device& device, const Buffer& buffer, std::span<std::byte> bytes, uint64_t offset = 0);
/// Makes `buffer` one of `size` bytes, at least as many as it has, that starts with what it held.
void grow(Device& device, Buffer& buffer, const char* name, uint64_t size);

/// A buffer that holds `values`; 16 bytes of nothing if there are none.
template <class T>
Buffer makeBuffer(Device& device, const char* name, const std::vector<T>& values) {
  Buffer buffer(device, name, values.size() * sizeof(T));
  upload(device, buffer, std::as_bytes(std::span(values)));
  return buffer;
}

template <class T>
std::vector<T> readBuffer(Device& device, const Buffer& buffer, size_t count, uint64_t offset = 0) {
  std::vector<T> values(count);
  download(device, buffer, std::as_writable_bytes(std::span(values)), offset);
  return values;
}

}  // namespace boxlight::gpu
