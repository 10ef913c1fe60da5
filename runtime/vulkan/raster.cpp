// SPDX-License-Identifier: Apache-2.0
#include "runtime/vulkan/raster.h"

#include <array>

#include "runtime/vulkan/commands.h"
#include "runtime/vulkan/native.h"

namespace boxlight::gpu {
namespace {

/// Colour attachments on every device; the first is also a storage image on every device.
constexpr vk::Format colorFormat(RasterFormat format) {
  return format.pairs ? vk::Format::eR32G32Uint : vk::Format::eR32Uint;
}
constexpr auto kDepthFormat = vk::Format::eD32Sfloat;

vk::raii::RenderPass makePass(const vk::raii::Device& device, RasterFormat format) {
  using Layout = vk::ImageLayout;
  const auto keepDepth =
      format.copiedDepth ? vk::AttachmentStoreOp::eStore : vk::AttachmentStoreOp::eDontCare;
  const auto depthLayout =
      format.copiedDepth ? Layout::eTransferSrcOptimal : Layout::eDepthStencilAttachmentOptimal;
  const auto wordLayout = format.pairs ? Layout::eTransferSrcOptimal : Layout::eGeneral;
  const std::array<vk::AttachmentDescription, 2> attachments = {
      vk::AttachmentDescription({}, colorFormat(format), vk::SampleCountFlagBits::e1,
                                vk::AttachmentLoadOp::eClear, vk::AttachmentStoreOp::eStore,
                                vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                Layout::eUndefined, wordLayout),
      vk::AttachmentDescription({}, kDepthFormat, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eClear,
                                keepDepth, vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                Layout::eUndefined, depthLayout)};
  const vk::AttachmentReference color(0, Layout::eGeneral), depth(1, Layout::eDepthStencilAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, color, {}, &depth);
  // The layout changes wait for whatever used the images before, and what comes after waits for the pass.
  constexpr auto kAll = vk::PipelineStageFlagBits::eAllCommands,
                 kHere = vk::PipelineStageFlagBits::eAllGraphics;
  constexpr auto kWrites = vk::AccessFlagBits::eMemoryWrite;
  constexpr auto kUses = vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite;
  const std::array<vk::SubpassDependency, 2> dependencies = {
      vk::SubpassDependency(VK_SUBPASS_EXTERNAL, 0, kAll, kHere, kWrites, kUses),
      vk::SubpassDependency(0, VK_SUBPASS_EXTERNAL, kHere, kAll, kWrites, kUses)};
  return {device, vk::RenderPassCreateInfo({}, attachments, subpass, dependencies)};
}

void makeImage(const Device::Native& native, uvec2 size, vk::Format format, vk::ImageUsageFlags usage,
               vk::ImageAspectFlags aspect, vk::raii::Image& image, vk::raii::DeviceMemory& memory,
               vk::raii::ImageView& view) {
  image = vk::raii::Image(native.device,
                          vk::ImageCreateInfo({}, vk::ImageType::e2D, format, {size.x, size.y, 1}, 1, 1,
                                              vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, usage));
  memory = native.allocate(image.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eDeviceLocal, {});
  image.bindMemory(*memory, 0);
  view = vk::raii::ImageView(native.device, vk::ImageViewCreateInfo({}, *image, vk::ImageViewType::e2D,
                                                                    format, {}, {aspect, 0, 1, 0, 1}));
}

}  // namespace

RasterTarget::RasterTarget(Device& device, uvec2 size, RasterFormat format)
    : size_(size), format_(format), native_(std::make_unique<Native>()) {
  translated("visibility image", [&] {
    const auto& native = device.native();
    using Use = vk::ImageUsageFlagBits;
    const auto features = native.physical.getFormatProperties(kDepthFormat).optimalTilingFeatures;
    if (!(features & vk::FormatFeatureFlagBits::eDepthStencilAttachment))
      fail(ExitCode::runtime, "'{}' has no 32-bit floating-point depth buffer", native.info.name);
    const vk::ImageUsageFlags copied = format.copiedDepth ? Use::eTransferSrc : vk::ImageUsageFlags{};
    const vk::ImageUsageFlags read = format.pairs ? Use::eTransferSrc : Use::eStorage;
    native_->pass = makePass(native.device, format);
    makeImage(native, size, colorFormat(format), Use::eColorAttachment | read,
              vk::ImageAspectFlagBits::eColor, native_->color, native_->colorMemory, native_->colorView);
    makeImage(native, size, kDepthFormat, Use::eDepthStencilAttachment | copied,
              vk::ImageAspectFlagBits::eDepth, native_->depth, native_->depthMemory, native_->depthView);
    const std::array views = {*native_->colorView, *native_->depthView};
    native_->framebuffer = vk::raii::Framebuffer(
        native.device, vk::FramebufferCreateInfo({}, *native_->pass, views, size.x, size.y, 1));
  });
}

RasterTarget::~RasterTarget() = default;
RasterTarget::RasterTarget(RasterTarget&&) noexcept = default;
RasterTarget& RasterTarget::operator=(RasterTarget&&) noexcept = default;

RasterPipeline::RasterPipeline(const Device& device, const Bindings& bindings, const RasterTarget& target,
                               std::span<const uint32_t> vertexCode, std::span<const uint32_t> fragmentCode,
                               std::span<const uint32_t> constants, DepthTest depthTest)
    : bindings_(&bindings), native_(std::make_unique<Native>()) {
  translated("visibility pipeline", [&] {
    const auto vertex = loadShader(device.native(), vertexCode),
               fragment = loadShader(device.native(), fragmentCode);
    const Specialization specialization(device, constants);
    using Stage = vk::ShaderStageFlagBits;
    const std::array<vk::PipelineShaderStageCreateInfo, 2> stages = {
        vk::PipelineShaderStageCreateInfo({}, Stage::eVertex, *vertex, "main", specialization.info()),
        vk::PipelineShaderStageCreateInfo({}, Stage::eFragment, *fragment, "main", specialization.info())};
    const vk::PipelineVertexInputStateCreateInfo noInput;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.setLineWidth(1.0f);
    const vk::PipelineMultisampleStateCreateInfo multisample({}, vk::SampleCountFlagBits::e1);
    const vk::PipelineDepthStencilStateCreateInfo depth(
        {}, true, true,
        depthTest == DepthTest::keepsLast ? vk::CompareOp::eGreaterOrEqual : vk::CompareOp::eGreater);
    vk::PipelineColorBlendAttachmentState noBlend;
    noBlend.setColorWriteMask(vk::ColorComponentFlagBits::eR | vk::ColorComponentFlagBits::eG);
    const vk::PipelineColorBlendStateCreateInfo blend({}, false, {}, noBlend);
    const std::array dynamicStates = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamicStates);
    native_->pipeline =
        vk::raii::Pipeline(device.native().device, nullptr,
                           vk::GraphicsPipelineCreateInfo(
                               {}, stages, &noInput, &assembly, nullptr, &viewport, &raster, &multisample,
                               &depth, &blend, &dynamic, bindings.native().layout, *target.native().pass, 0));
  });
}

RasterPipeline::~RasterPipeline() = default;
RasterPipeline::RasterPipeline(RasterPipeline&&) noexcept = default;
RasterPipeline& RasterPipeline::operator=(RasterPipeline&&) noexcept = default;

}  // namespace boxlight::gpu
