// SPDX-License-Identifier: Apache-2.0
#include "runtime/vulkan/swapchain.h"

#include <array>

#include "runtime/vulkan/native.h"

namespace boxlight::gpu {
namespace {

constexpr uint64_t kPatience = 2'000'000'000;  // nanoseconds for an image that the system still shows

/// Of 8 bits a channel. Without sRGB encoding first: the picture and Dear ImGui encode by themselves.
vk::SurfaceFormatKHR chooseFormat(const std::vector<vk::SurfaceFormatKHR>& formats) {
  for (const auto wanted :
       {vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm, vk::Format::eA8B8G8R8UnormPack32,
        vk::Format::eB8G8R8A8Srgb, vk::Format::eR8G8B8A8Srgb, vk::Format::eA8B8G8R8SrgbPack32})
    for (const auto& format : formats)
      if (format.format == wanted && format.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear) return format;
  fail(ExitCode::runtime, "the window's surface has none of the usual 8-bit sRGB formats; use --headless");
}

bool isSrgb(vk::Format format) {
  return format == vk::Format::eB8G8R8A8Srgb || format == vk::Format::eR8G8B8A8Srgb ||
         format == vk::Format::eA8B8G8R8SrgbPack32;
}

vk::CompositeAlphaFlagBitsKHR chooseAlpha(vk::CompositeAlphaFlagsKHR supported) {
  using Alpha = vk::CompositeAlphaFlagBitsKHR;
  for (const auto wanted : {Alpha::eOpaque, Alpha::eInherit, Alpha::ePreMultiplied, Alpha::ePostMultiplied})
    if (supported & wanted) return wanted;
  return Alpha::eOpaque;
}

/// The window's size where the surface leaves it open, else the surface's own.
vk::Extent2D chooseExtent(const vk::SurfaceCapabilitiesKHR& surface, uvec2 framebuffer) {
  constexpr uint32_t kOpen = ~0u;
  if (surface.currentExtent.width != kOpen) return surface.currentExtent;
  return {std::clamp(framebuffer.x, surface.minImageExtent.width, surface.maxImageExtent.width),
          std::clamp(framebuffer.y, surface.minImageExtent.height, surface.maxImageExtent.height)};
}

vk::raii::RenderPass makePass(const vk::raii::Device& device, vk::Format format) {
  const vk::AttachmentDescription color({}, format, vk::SampleCountFlagBits::e1,
                                        vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eStore,
                                        vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                        vk::ImageLayout::eUndefined, vk::ImageLayout::ePresentSrcKHR);
  const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, reference);
  // The layout changes once the image was acquired, which the submission waits for at this stage.
  constexpr auto kOutput = vk::PipelineStageFlagBits::eColorAttachmentOutput;
  const vk::SubpassDependency acquired(VK_SUBPASS_EXTERNAL, 0, kOutput, kOutput, {},
                                       vk::AccessFlagBits::eColorAttachmentWrite);
  return {device, vk::RenderPassCreateInfo({}, color, subpass, acquired)};
}

SurfaceState stateOf(vk::Result result) {
  return result == vk::Result::eSuboptimalKHR ? SurfaceState::suboptimal : SurfaceState::ready;
}

template <class Action>
SurfaceState surfaceState(const char* what, Action&& action) {
  return translated(what, [&] {
    try {
      return stateOf(action());
    } catch (const vk::OutOfDateKHRError&) {
      return SurfaceState::outOfDate;
    }
  });
}

}  // namespace

Swapchain::Swapchain(Device& device) : device_(device), native_(std::make_unique<Native>()) {
  translated("window", [&] {
    const auto& native = device.native();
    native_->format = chooseFormat(native.physical.getSurfaceFormatsKHR(*native.surface));
    native_->pass = makePass(native.device, native_->format.format);
    native_->pool = vk::raii::CommandPool(
        native.device, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, native.queueFamily});
    const vk::CommandBufferAllocateInfo one(*native_->pool, vk::CommandBufferLevel::ePrimary, 1);
    native_->commands = std::move(vk::raii::CommandBuffers(native.device, one).front());
    native_->acquired = vk::raii::Semaphore(native.device, vk::SemaphoreCreateInfo());
    native_->done = vk::raii::Fence(native.device, vk::FenceCreateInfo());
  });
}

Swapchain::~Swapchain() {
  try {
    device_.native().device.waitIdle();
  } catch (const vk::Error&) {  // a lost device waits for nothing
  }
}

uvec2 Swapchain::extent() const { return {native_->extent.width, native_->extent.height}; }
bool Swapchain::encodesSrgb() const { return isSrgb(native_->format.format); }

void Swapchain::Native::addImages(const vk::raii::Device& device) {
  images.clear();
  for (const VkImage handle : chain.getImages()) {
    const vk::Image image(handle);
    Image& entry = images.emplace_back();
    entry.view = vk::raii::ImageView(
        device, vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, format.format, {},
                                        {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
    const vk::ImageView view = *entry.view;
    entry.framebuffer = vk::raii::Framebuffer(
        device, vk::FramebufferCreateInfo({}, *pass, view, extent.width, extent.height, 1));
    entry.drawn = vk::raii::Semaphore(device, vk::SemaphoreCreateInfo());
  }
}

void Swapchain::recreate(uvec2 framebufferSize) {
  translated("window", [&] {
    const auto& native = device_.native();
    native.device.waitIdle();
    const auto surface = native.physical.getSurfaceCapabilitiesKHR(*native.surface);
    native_->extent = chooseExtent(surface, framebufferSize);
    if (native_->extent.width == 0 || native_->extent.height == 0) return;
    const uint32_t most = surface.maxImageCount > 0 ? surface.maxImageCount : ~0u;
    vk::SwapchainCreateInfoKHR info({}, *native.surface, std::min(surface.minImageCount + 1, most),
                                    native_->format.format, native_->format.colorSpace, native_->extent, 1,
                                    vk::ImageUsageFlagBits::eColorAttachment);
    const std::array families = {native.queueFamily, native.presentFamily};
    if (native.queueFamily != native.presentFamily)
      info.setImageSharingMode(vk::SharingMode::eConcurrent).setQueueFamilyIndices(families);
    info.setPreTransform(surface.currentTransform);
    info.setCompositeAlpha(chooseAlpha(surface.supportedCompositeAlpha));
    info.setPresentMode(vk::PresentModeKHR::eFifo);  // the one that every surface has
    info.setClipped(true).setOldSwapchain(*native_->chain);
    native_->images.clear();
    native_->chain = vk::raii::SwapchainKHR(native.device, info);
    native_->addImages(native.device);
  });
}

SurfaceState Swapchain::acquire() {
  return surfaceState("acquire an image of the window", [&] {
    const auto [result, index] = native_->chain.acquireNextImage(kPatience, *native_->acquired);
    native_->current = index;
    if (result == vk::Result::eTimeout || result == vk::Result::eNotReady)
      throw vk::OutOfDateKHRError("no image in time");
    return result;
  });
}

void Swapchain::draw(const std::function<void(SwapchainPass&)>& record) {
  translated("draw the window", [&] {
    const auto& native = device_.native();
    const auto& image = native_->images[native_->current];
    const auto& commands = native_->commands;
    commands.reset();
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    const vk::Rect2D area({0, 0}, native_->extent);
    commands.beginRenderPass({*native_->pass, *image.framebuffer, area, {}}, vk::SubpassContents::eInline);
    commands.setViewport(0, vk::Viewport(0, 0, float(area.extent.width), float(area.extent.height), 0, 1));
    commands.setScissor(0, area);
    SwapchainPass pass{commands};
    record(pass);
    commands.endRenderPass();
    commands.end();
    constexpr vk::PipelineStageFlags kWait = vk::PipelineStageFlagBits::eColorAttachmentOutput;
    const vk::Semaphore acquired = *native_->acquired, drawn = *image.drawn;
    const vk::CommandBuffer submitted = *commands;
    native.queue.submit(vk::SubmitInfo(acquired, kWait, submitted, drawn), *native_->done);
    // What the window draws from may be written again after this.
    if (native.device.waitForFences(*native_->done, true, ~uint64_t(0)) != vk::Result::eSuccess)
      fail(ExitCode::runtime, "'{}' does not finish drawing the window", native.info.name);
    native.device.resetFences(*native_->done);
  });
}

SurfaceState Swapchain::present() {
  return surfaceState("show the window", [&] {
    const vk::Semaphore drawn = *native_->images[native_->current].drawn;
    const vk::SwapchainKHR chain = *native_->chain;
    return device_.native().presentQueue.presentKHR({drawn, chain, native_->current});
  });
}

}  // namespace boxlight::gpu
