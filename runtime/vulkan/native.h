// SPDX-License-Identifier: Apache-2.0
#pragma once

// What stands behind the opaque types of this wing. Included by runtime/vulkan/*.cpp alone: vulkan_raii.hpp
// is slow to compile.
#define VULKAN_HPP_NO_SPACESHIP_OPERATOR
#include <vulkan/vulkan_raii.hpp>

#include <map>
#include <mutex>
#include <optional>

#include "common/base/error.h"
#include "common/base/math.h"
#include "runtime/vulkan/buffer.h"
#include "runtime/vulkan/device.h"
#include "runtime/vulkan/pipeline.h"
#include "runtime/vulkan/raster.h"
#include "runtime/vulkan/swapchain.h"

namespace boxlight::gpu {

/// Runs `action`; what Vulkan throws becomes an Error with the name of what was being done.
template <class Action>
auto translated(const char* what, Action&& action) {
  try {
    return action();
  } catch (const vk::Error& error) {
    fail(ExitCode::runtime, "Vulkan: {}: {}", what, error.what());
  }
}

class ValidationLog {
 public:
  void add(const char* message);
  void require() const;

 private:
  mutable std::mutex mutex_;
  uint32_t count_ = 0;
  std::string first_;
};

inline constexpr uint32_t kMaxPasses = 32;  // per submission

/// Of the one set of resources that every shader sees (Bindings).
struct ResourceLayout {
  explicit ResourceLayout(const vk::raii::Device& device);
  vk::raii::DescriptorSetLayout set = nullptr;
  vk::raii::PipelineLayout pipelines = nullptr;
};

struct Device::Native {
  std::shared_ptr<ValidationLog> validation = std::make_shared<ValidationLog>();
  vk::raii::Context context;
  vk::raii::Instance instance = nullptr;
  vk::raii::DebugUtilsMessengerEXT messenger = nullptr;
  vk::raii::SurfaceKHR surface = nullptr;  // of the window, if there is one
  vk::raii::PhysicalDevice physical = nullptr;
  DeviceInfo info;
  DeviceLimits limits;
  bool validated = false;
  uint32_t queueFamily = 0, presentFamily = 0, timestampBits = 0;
  double nanosecondsPerTick = 0;
  vk::raii::Device device = nullptr;
  vk::raii::Queue queue = nullptr, presentQueue = nullptr;
  vk::raii::CommandPool pool = nullptr;
  vk::raii::QueryPool queries = nullptr;
  std::optional<ResourceLayout> resources;
  /// All that were made, by number and values of their constants and by their code: drivers take up to
  /// seconds to compile one, and who switches back wants the picture at once.
  std::map<std::vector<uint32_t>, vk::raii::Pipeline> computePipelines;

  /// Memory of a kind that `allowed` permits, with `wanted` properties if there is any such, else with
  /// `needed`.
  vk::raii::DeviceMemory allocate(const vk::MemoryRequirements& requirements, vk::MemoryPropertyFlags wanted,
                                  vk::MemoryPropertyFlags needed) const;
};

/// Host-visible memory for copies.
struct Staging {
  Staging(const Device::Native& native, uint64_t size);
  vk::raii::Buffer buffer;
  vk::raii::DeviceMemory memory;
  void* data;
};

struct Buffer::Native {
  vk::raii::Buffer buffer = nullptr;
  vk::raii::DeviceMemory memory = nullptr;
};

struct Bindings::Native {
  vk::PipelineLayout layout;  // the device's
  vk::raii::DescriptorPool pool = nullptr;
  vk::raii::DescriptorSet set = nullptr;
  std::vector<vk::raii::BufferView> texels;
};

struct ComputePipeline::Native {
  vk::Pipeline pipeline;  // the device's
};

struct RasterTarget::Native {
  vk::raii::RenderPass pass = nullptr;
  vk::raii::Image color = nullptr, depth = nullptr;
  vk::raii::DeviceMemory colorMemory = nullptr, depthMemory = nullptr;
  vk::raii::ImageView colorView = nullptr, depthView = nullptr;
  vk::raii::Framebuffer framebuffer = nullptr;
};

struct RasterPipeline::Native {
  vk::raii::Pipeline pipeline = nullptr;
};

struct Swapchain::Native {
  struct Image {
    vk::raii::ImageView view = nullptr;
    vk::raii::Framebuffer framebuffer = nullptr;
    vk::raii::Semaphore drawn = nullptr;
  };
  void addImages(const vk::raii::Device& device);

  vk::SurfaceFormatKHR format;
  vk::Extent2D extent;
  vk::raii::RenderPass pass = nullptr;
  vk::raii::SwapchainKHR chain = nullptr;
  std::vector<Image> images;
  uint32_t current = 0;
  vk::raii::CommandPool pool = nullptr;
  vk::raii::CommandBuffer commands = nullptr;
  vk::raii::Semaphore acquired = nullptr;
  vk::raii::Fence done = nullptr;
};

struct SwapchainPass {
  const vk::raii::CommandBuffer& commands;
};

/// Specialisation constants 0, 1, ... of one shader stage and what the device says for itself.
class Specialization {
 public:
  Specialization(const Device& device, std::span<const uint32_t> values);
  const vk::SpecializationInfo* info() const { return &info_; }

 private:
  std::vector<uint32_t> values_;
  std::vector<vk::SpecializationMapEntry> entries_;
  vk::SpecializationInfo info_;
};

vk::raii::ShaderModule loadShader(const Device::Native& native, std::span<const uint32_t> code);

}  // namespace boxlight::gpu
