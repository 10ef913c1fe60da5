// SPDX-License-Identifier: Apache-2.0
#include <backends/imgui_impl_vulkan.h>

#include <array>

#include "runtime/vulkan/native.h"
#include "runtime/vulkan/swapchain.h"

namespace boxlight::gpu {
namespace {

void checkResult(VkResult result) {
  if (result < 0)
    fail(ExitCode::runtime, "Vulkan: user interface: {}", vk::to_string(static_cast<vk::Result>(result)));
}

vk::raii::DescriptorPool makePool(const vk::raii::Device& device) {
  constexpr uint32_t kTextures = 4;  // the font, and room for what a later Dear ImGui may want
  const std::array sizes = {vk::DescriptorPoolSize(vk::DescriptorType::eCombinedImageSampler, kTextures)};
  return {device, {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, kTextures, sizes}};
}

}  // namespace

struct Overlay::Native {
  vk::raii::DescriptorPool pool = nullptr;
};

Overlay::Overlay(Device& device, const Swapchain& swapchain) : native_(std::make_unique<Native>()) {
  translated("user interface", [&] {
    const auto& native = device.native();
    native_->pool = makePool(native.device);
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = static_cast<VkInstance>(*native.instance);
    info.PhysicalDevice = static_cast<VkPhysicalDevice>(*native.physical);
    info.Device = static_cast<VkDevice>(*native.device);
    info.QueueFamily = native.queueFamily;
    info.Queue = static_cast<VkQueue>(*native.queue);
    info.DescriptorPool = static_cast<VkDescriptorPool>(*native_->pool);
    info.MinImageCount = 2;
    info.ImageCount = std::max(uint32_t(swapchain.native().images.size()), 2u);
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = checkResult;
    ImGui_ImplVulkan_Init(&info, static_cast<VkRenderPass>(*swapchain.native().pass));

    const vk::CommandBufferAllocateInfo allocation(*native.pool, vk::CommandBufferLevel::ePrimary, 1);
    const vk::raii::CommandBuffer commands =
        std::move(vk::raii::CommandBuffers(native.device, allocation).front());
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    ImGui_ImplVulkan_CreateFontsTexture(static_cast<VkCommandBuffer>(*commands));
    commands.end();
    const vk::CommandBuffer submitted = *commands;
    native.queue.submit(vk::SubmitInfo({}, {}, submitted));
    native.queue.waitIdle();
    ImGui_ImplVulkan_DestroyFontUploadObjects();
  });
}

Overlay::~Overlay() { ImGui_ImplVulkan_Shutdown(); }

void Overlay::newFrame() const { ImGui_ImplVulkan_NewFrame(); }

void Overlay::draw(SwapchainPass& pass) const {
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), static_cast<VkCommandBuffer>(*pass.commands));
}

}  // namespace boxlight::gpu
