// SPDX-License-Identifier: Apache-2.0
#include "runtime/vulkan/pipeline.h"

#include "runtime/vulkan/native.h"
#include "shaders/shared.h"

namespace boxlight::gpu {
namespace {

constexpr uint32_t kPushBytes = 128;  // every device has as much

std::vector<vk::DescriptorSetLayoutBinding> makeSlots() {
  std::vector<vk::DescriptorSetLayoutBinding> slots;
  for (uint32_t binding = 0; binding < kBufferBindings; ++binding)
    slots.emplace_back(binding, vk::DescriptorType::eStorageBuffer, 1, vk::ShaderStageFlagBits::eAll);
  slots.emplace_back(kBindVisibility, vk::DescriptorType::eStorageImage, 1,
                     vk::ShaderStageFlagBits::eCompute);
  return slots;
}

void makeSet(const vk::raii::Device& device, Bindings::Native& native) {
  native.slots = makeSlots();
  native.setLayout =
      vk::raii::DescriptorSetLayout(device, vk::DescriptorSetLayoutCreateInfo({}, native.slots));
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eAll, 0, kPushBytes);
  native.layout = vk::raii::PipelineLayout(device, vk::PipelineLayoutCreateInfo({}, *native.setLayout, push));
  const std::array<vk::DescriptorPoolSize, 2> sizes = {
      vk::DescriptorPoolSize(vk::DescriptorType::eStorageBuffer, kBufferBindings),
      vk::DescriptorPoolSize(vk::DescriptorType::eStorageImage, 1)};
  native.pool =
      vk::raii::DescriptorPool(device, {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes});
  native.set = std::move(
      vk::raii::DescriptorSets(device, vk::DescriptorSetAllocateInfo(*native.pool, *native.setLayout))
          .front());
}

}  // namespace

Specialization::Specialization(std::span<const uint32_t> values) {
  for (uint32_t i = 0; i < values.size(); ++i)
    entries_.emplace_back(i, uint32_t(i * sizeof(uint32_t)), sizeof(uint32_t));
  info_ =
      vk::SpecializationInfo(uint32_t(entries_.size()), entries_.data(), values.size_bytes(), values.data());
}

vk::raii::ShaderModule loadShader(const Device::Native& native, std::span<const uint32_t> code) {
  return {native.device, vk::ShaderModuleCreateInfo({}, code.size_bytes(), code.data())};
}

Bindings::Bindings(const Device& device)
    : device_(device), native_(std::make_unique<Native>()), empty_(device, "empty buffer", 0) {
  if (device.limits().maxStorageBuffers < kBufferBindings)
    fail(ExitCode::runtime, "'{}' binds {} storage buffers at once; {} are needed", device.info().name,
         device.limits().maxStorageBuffers, kBufferBindings);
  translated("descriptors", [&] { makeSet(device.native().device, *native_); });
  for (uint32_t binding = 0; binding < kBufferBindings; ++binding) set(binding, empty_);
}

Bindings::~Bindings() = default;

void Bindings::set(uint32_t binding, const Buffer& buffer) {
  const vk::DescriptorBufferInfo info(*buffer.native().buffer, 0, VK_WHOLE_SIZE);
  const vk::WriteDescriptorSet write(*native_->set, binding, 0, vk::DescriptorType::eStorageBuffer, {}, info);
  device_.native().device.updateDescriptorSets(write, {});
}

void Bindings::setVisibilityImage(const RasterTarget& target) {
  const vk::DescriptorImageInfo info({}, *target.native().colorView, vk::ImageLayout::eGeneral);
  const vk::WriteDescriptorSet write(*native_->set, kBindVisibility, 0, vk::DescriptorType::eStorageImage,
                                     info);
  device_.native().device.updateDescriptorSets(write, {});
}

ComputePipeline::ComputePipeline(const Device& device, const Bindings& bindings,
                                 std::span<const uint32_t> code, std::span<const uint32_t> constants)
    : bindings_(&bindings), native_(std::make_unique<Native>()) {
  translated("compute pipeline", [&] {
    const auto shader = loadShader(device.native(), code);
    const Specialization specialization(constants);
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main",
                                                  specialization.info());
    native_->pipeline = vk::raii::Pipeline(
        device.native().device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *bindings.native().layout));
  });
}

ComputePipeline::~ComputePipeline() = default;
ComputePipeline::ComputePipeline(ComputePipeline&&) noexcept = default;

}  // namespace boxlight::gpu
