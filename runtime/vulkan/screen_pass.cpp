// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "runtime/vulkan/native.h"
#include "runtime/vulkan/swapchain.h"
#include "spirv/present_frag.h"
#include "spirv/present_vert.h"

namespace boxlight::gpu {

struct ScreenPass::Native {
  vk::raii::Pipeline pipeline = nullptr;
};

ScreenPass::ScreenPass(const Device& device, const Bindings& bindings, const Swapchain& swapchain)
    : bindings_(bindings), native_(std::make_unique<Native>()) {
  translated("window pipeline", [&] {
    const auto vertex = loadShader(device.native(), present_vert),
               fragment = loadShader(device.native(), present_frag);
    const std::array<uint32_t, 1> constants = {swapchain.encodesSrgb()};
    const Specialization specialization(device, constants);
    using Stage = vk::ShaderStageFlagBits;
    const std::array<vk::PipelineShaderStageCreateInfo, 2> stages = {
        vk::PipelineShaderStageCreateInfo({}, Stage::eVertex, *vertex, "main"),
        vk::PipelineShaderStageCreateInfo({}, Stage::eFragment, *fragment, "main", specialization.info())};
    const vk::PipelineVertexInputStateCreateInfo noInput;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.setLineWidth(1.0f);
    const vk::PipelineMultisampleStateCreateInfo multisample({}, vk::SampleCountFlagBits::e1);
    vk::PipelineColorBlendAttachmentState noBlend;
    using Channel = vk::ColorComponentFlagBits;
    noBlend.setColorWriteMask(Channel::eR | Channel::eG | Channel::eB | Channel::eA);
    const vk::PipelineColorBlendStateCreateInfo blend({}, false, {}, noBlend);
    const std::array dynamicStates = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamicStates);
    native_->pipeline = vk::raii::Pipeline(
        device.native().device, nullptr,
        vk::GraphicsPipelineCreateInfo({}, stages, &noInput, &assembly, nullptr, &viewport, &raster,
                                       &multisample, nullptr, &blend, &dynamic, bindings.native().layout,
                                       *swapchain.native().pass, 0));
  });
}

ScreenPass::~ScreenPass() = default;

void ScreenPass::draw(SwapchainPass& pass, std::span<const std::byte> push) const {
  const auto& native = bindings_.native();
  pass.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *native_->pipeline);
  pass.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, native.layout, 0, *native.set, {});
  pass.commands.pushConstants<std::byte>(native.layout, vk::ShaderStageFlagBits::eAll, 0, push);
  pass.commands.draw(3, 1, 0, 0);
}

}  // namespace boxlight::gpu
