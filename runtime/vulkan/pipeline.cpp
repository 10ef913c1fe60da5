// SPDX-License-Identifier: Apache-2.0
#include "runtime/vulkan/pipeline.h"

#include "runtime/vulkan/native.h"
#include "shaders/shared.h"

namespace boxlight::gpu {
namespace {

constexpr uint32_t kPushBytes = 128;  // every device has as much

/// A storage buffer that is a texel buffer as well.
struct TexelTwin {
  uint32_t storage, texels;  // bindings
  vk::Format format;
  uint64_t texelBytes;
};

constexpr std::array<TexelTwin, 4> kTexelTwins = {
    {{kBindTables, kBindTableTexels, vk::Format::eR32Sfloat, 4},
     {kBindSummedArea, kBindLightTexels, vk::Format::eR32G32B32A32Uint, 16},
     {kBindVisibilityMaps, kBindMapTexels, vk::Format::eR32Uint, 4},
     {kBindMoments, kBindMomentTexels, vk::Format::eR32G32B32A32Uint, 16}}};

std::vector<vk::DescriptorSetLayoutBinding> makeSlots() {
  std::vector<vk::DescriptorSetLayoutBinding> slots;
  for (uint32_t binding = 0; binding < kBufferBindings; ++binding)
    slots.emplace_back(binding, vk::DescriptorType::eStorageBuffer, 1, vk::ShaderStageFlagBits::eAll);
  slots.emplace_back(kBindVisibility, vk::DescriptorType::eStorageImage, 1,
                     vk::ShaderStageFlagBits::eCompute);
  for (const TexelTwin& twin : kTexelTwins)
    slots.emplace_back(twin.texels, vk::DescriptorType::eUniformTexelBuffer, 1,
                       vk::ShaderStageFlagBits::eAll);
  return slots;
}

void makeSet(Device::Native& device, Bindings::Native& native) {
  if (!device.resources) device.resources.emplace(device.device);
  native.layout = *device.resources->pipelines;
  const std::array<vk::DescriptorPoolSize, 3> sizes = {
      vk::DescriptorPoolSize(vk::DescriptorType::eStorageBuffer, kBufferBindings),
      vk::DescriptorPoolSize(vk::DescriptorType::eStorageImage, 1),
      vk::DescriptorPoolSize(vk::DescriptorType::eUniformTexelBuffer, uint32_t(kTexelTwins.size()))};
  native.pool = vk::raii::DescriptorPool(device.device,
                                         {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes});
  const vk::DescriptorSetAllocateInfo allocation(*native.pool, *device.resources->set);
  native.set = std::move(vk::raii::DescriptorSets(device.device, allocation).front());
}

vk::raii::Pipeline makePipeline(const Device& device, vk::PipelineLayout layout,
                                std::span<const uint32_t> code, std::span<const uint32_t> constants) {
  const auto shader = loadShader(device.native(), code);
  const Specialization specialization(device, constants);
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main",
                                                specialization.info());
  return {device.native().device, nullptr, vk::ComputePipelineCreateInfo({}, stage, layout)};
}

}  // namespace

Specialization::Specialization(const Device& device, std::span<const uint32_t> values)
    : values_(values.begin(), values.end()) {
  const auto add = [&](uint32_t id, size_t i) {
    entries_.emplace_back(id, uint32_t(i * sizeof(uint32_t)), sizeof(uint32_t));
  };
  for (uint32_t i = 0; i < values.size(); ++i) add(i, i);
  values_.push_back(device.limits().texelBuffers);
  add(kConstantTexelBuffers, values.size());
  info_ = vk::SpecializationInfo(uint32_t(entries_.size()), entries_.data(),
                                 values_.size() * sizeof(uint32_t), values_.data());
}

vk::raii::ShaderModule loadShader(const Device::Native& native, std::span<const uint32_t> code) {
  return {native.device, vk::ShaderModuleCreateInfo({}, code.size_bytes(), code.data())};
}

ResourceLayout::ResourceLayout(const vk::raii::Device& device) {
  const auto slots = makeSlots();
  set = vk::raii::DescriptorSetLayout(device, vk::DescriptorSetLayoutCreateInfo({}, slots));
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eAll, 0, kPushBytes);
  pipelines = vk::raii::PipelineLayout(device, vk::PipelineLayoutCreateInfo({}, *set, push));
}

Bindings::Bindings(const Device& device)
    : device_(device), native_(std::make_unique<Native>()), empty_(device, "empty buffer", 0) {
  if (device.limits().maxStorageBuffers < kBufferBindings)
    fail(ExitCode::runtime, "'{}' binds {} storage buffers at once; {} are needed", device.info().name,
         device.limits().maxStorageBuffers, kBufferBindings);
  translated("descriptors", [&] { makeSet(device.native(), *native_); });
  for (size_t twin = 0; twin < kTexelTwins.size(); ++twin) native_->texels.emplace_back(nullptr);
  for (uint32_t binding = 0; binding < kBufferBindings; ++binding) set(binding, empty_);
  for (size_t twin = 0; twin < kTexelTwins.size(); ++twin) setTexels(twin, empty_);
}

Bindings::~Bindings() = default;

void Bindings::set(uint32_t binding, const Buffer& buffer) {
  const vk::DescriptorBufferInfo info(*buffer.native().buffer, 0, VK_WHOLE_SIZE);
  const vk::WriteDescriptorSet write(*native_->set, binding, 0, vk::DescriptorType::eStorageBuffer, {}, info);
  device_.native().device.updateDescriptorSets(write, {});
  if (!device_.limits().texelBuffers) return;
  for (size_t twin = 0; twin < kTexelTwins.size(); ++twin)
    if (kTexelTwins[twin].storage == binding) setTexels(twin, buffer);
}

void Bindings::setTexels(size_t twin, const Buffer& buffer) {
  const auto& native = device_.native();
  const auto& [storage, binding, format, texelBytes] = kTexelTwins[twin];
  if (buffer.size() / texelBytes > device_.limits().maxTexels)
    fail(ExitCode::runtime, "buffer {} needs {} texels, but a texel buffer of '{}' holds {} at most", storage,
         buffer.size() / texelBytes, device_.info().name, device_.limits().maxTexels);
  const vk::BufferViewCreateInfo info({}, *buffer.native().buffer, format, 0, VK_WHOLE_SIZE);
  translated("texel buffer", [&] { native_->texels[twin] = vk::raii::BufferView(native.device, info); });
  const vk::BufferView view = *native_->texels[twin];
  const vk::WriteDescriptorSet write(*native_->set, binding, 0, vk::DescriptorType::eUniformTexelBuffer, {},
                                     {}, view);
  native.device.updateDescriptorSets(write, {});
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
    auto& known = device.native().computePipelines;
    std::vector<uint32_t> key{uint32_t(constants.size())};
    key.insert(key.end(), constants.begin(), constants.end());
    key.insert(key.end(), code.begin(), code.end());
    auto place = known.find(key);
    if (place == known.end())
      place = known.emplace(std::move(key), makePipeline(device, bindings.native().layout, code, constants))
                  .first;
    native_->pipeline = *place->second;
  });
}

ComputePipeline::~ComputePipeline() = default;
ComputePipeline::ComputePipeline(ComputePipeline&&) noexcept = default;
ComputePipeline& ComputePipeline::operator=(ComputePipeline&&) noexcept = default;

}  // namespace boxlight::gpu
