// SPDX-License-Identifier: Apache-2.0
#include "runtime/vulkan/buffer.h"

#include <cassert>
#include <cstring>

#include "runtime/vulkan/native.h"

namespace boxlight::gpu {
namespace {

constexpr uint64_t kSmallest = 16;                     // Vulkan has no empty buffers
constexpr uint64_t kStagingSize = uint64_t(32) << 20;  // copies larger than this go in pieces

constexpr double mebibytes(uint64_t bytes) { return double(bytes) / double(1 << 20); }

/// Runs one transfer and waits; what it wrote is there for all that follows.
template <class Record>
void transfer(const Device::Native& native, Record&& record) {
  const vk::CommandBufferAllocateInfo allocation(*native.pool, vk::CommandBufferLevel::ePrimary, 1);
  const vk::raii::CommandBuffer commands =
      std::move(vk::raii::CommandBuffers(native.device, allocation).front());
  commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
  record(commands);
  const vk::MemoryBarrier visible(vk::AccessFlagBits::eTransferWrite,
                                  vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite);
  commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransfer,
                           vk::PipelineStageFlagBits::eAllCommands | vk::PipelineStageFlagBits::eHost, {},
                           visible, {}, {});
  commands.end();
  const vk::CommandBuffer submitted = *commands;
  native.queue.submit(vk::SubmitInfo({}, {}, submitted));
  native.queue.waitIdle();
}

void copyOnDevice(const Device& device, vk::Buffer from, vk::Buffer to, vk::BufferCopy region) {
  transfer(device.native(), [&](const auto& commands) { commands.copyBuffer(from, to, region); });
}

/// No number, as float or half float: what nobody wrote shows wherever it is used.
constexpr uint32_t kUnwritten = ~0u;

}  // namespace

Staging::Staging(const Device::Native& native, uint64_t size)
    : buffer(native.device,
             vk::BufferCreateInfo(
                 {}, size, vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst)),
      memory(native.allocate(
          buffer.getMemoryRequirements(),
          vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent |
              vk::MemoryPropertyFlagBits::eHostCached,
          vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent)) {
  buffer.bindMemory(*memory, 0);
  data = memory.mapMemory(0, size);
}

Buffer::Buffer(const Device& device, const char* name, uint64_t size)
    : size_(std::max(size, kSmallest)), native_(std::make_unique<Native>()) {
  const uint64_t limit = device.limits().maxStorageBufferRange;
  if (size_ > limit)
    fail(ExitCode::runtime, "{}: {:.0f} MiB needed, but a storage buffer of '{}' holds {:.0f} MiB at most",
         name, mebibytes(size_), device.info().name, mebibytes(limit));
  const auto& native = device.native();
  translated(name, [&] {
    using Use = vk::BufferUsageFlagBits;
    native_->buffer =
        vk::raii::Buffer(native.device, vk::BufferCreateInfo({}, size_,
                                                             Use::eStorageBuffer | Use::eUniformTexelBuffer |
                                                                 Use::eIndirectBuffer | Use::eTransferSrc |
                                                                 Use::eTransferDst));
    native_->memory = native.allocate(native_->buffer.getMemoryRequirements(),
                                      vk::MemoryPropertyFlagBits::eDeviceLocal, {});
    native_->buffer.bindMemory(*native_->memory, 0);
    if (native.validated)
      transfer(native, [&](const auto& commands) {
        commands.fillBuffer(*native_->buffer, 0, VK_WHOLE_SIZE, kUnwritten);
      });
  });
}

Buffer::~Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;

void upload(Device& device, const Buffer& buffer, std::span<const std::byte> bytes, uint64_t offset) {
  assert(offset + bytes.size() <= buffer.size());
  if (bytes.empty()) return;
  translated("copy to the device", [&] {
    const Staging staging(device.native(), std::min<uint64_t>(bytes.size(), kStagingSize));
    for (uint64_t done = 0; done < bytes.size(); done += kStagingSize) {
      const uint64_t size = std::min<uint64_t>(bytes.size() - done, kStagingSize);
      std::memcpy(staging.data, bytes.data() + done, size);
      copyOnDevice(device, *staging.buffer, *buffer.native().buffer, {0, offset + done, size});
    }
  });
}

void download(Device& device, const Buffer& buffer, std::span<std::byte> bytes, uint64_t offset) {
  assert(offset + bytes.size() <= buffer.size());
  if (bytes.empty()) return;
  translated("copy from the device", [&] {
    const Staging staging(device.native(), std::min<uint64_t>(bytes.size(), kStagingSize));
    for (uint64_t done = 0; done < bytes.size(); done += kStagingSize) {
      const uint64_t size = std::min<uint64_t>(bytes.size() - done, kStagingSize);
      copyOnDevice(device, *buffer.native().buffer, *staging.buffer, {offset + done, 0, size});
      std::memcpy(bytes.data() + done, staging.data, size);
    }
  });
}

void grow(Device& device, Buffer& buffer, const char* name, uint64_t size) {
  assert(size >= buffer.size());
  Buffer larger(device, name, size);
  translated("copy on the device", [&] {
    copyOnDevice(device, *buffer.native().buffer, *larger.native().buffer, {0, 0, buffer.size()});
  });
  buffer = std::move(larger);
}

}  // namespace boxlight::gpu
