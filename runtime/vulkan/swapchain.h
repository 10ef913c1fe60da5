// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "runtime/vulkan/device.h"
#include "runtime/vulkan/pipeline.h"
#include "runtime/vulkan/present_loop.h"

namespace boxlight::gpu {

struct SwapchainPass;  // a render pass being recorded: vulkan/native.h

/// The images of the device's window: 8 bits a channel in whatever order the surface has, in step with the
/// screen if it waits for that.
class Swapchain final : public PresentTarget {
 public:
  /// `device` was made with a window. Error: ExitCode::runtime if the surface cannot be drawn on.
  explicit Swapchain(Device& device);
  ~Swapchain() override;

  uvec2 extent() const override;
  void recreate(uvec2 framebufferSize) override;
  SurfaceState acquire() override;
  /// Records one render pass over the acquired image and submits it; present() then shows it.
  void draw(const std::function<void(SwapchainPass&)>& record);
  SurfaceState present() override;

  bool encodesSrgb() const;  ///< does the images' format encode what is drawn?
  struct Native;
  Native& native() const { return *native_; }

 private:
  Device& device_;
  std::unique_ptr<Native> native_;
};

/// What a Display composed (runtime/kernels/display.h), drawn over the whole image.
class ScreenPass {
 public:
  /// `bindings`: the display's.
  ScreenPass(const Device& device, const Bindings& bindings, const Swapchain& swapchain);
  ~ScreenPass();
  /// `push`: the DisplayPush that was composed with.
  void draw(SwapchainPass& pass, std::span<const std::byte> push) const;

 private:
  const Bindings& bindings_;
  struct Native;
  std::unique_ptr<Native> native_;
};

/// Dear ImGui on the device: its context must exist, and the swapchain must have images.
class Overlay {
 public:
  Overlay(Device& device, const Swapchain& swapchain);
  ~Overlay();
  void newFrame() const;                 ///< before ImGui::NewFrame
  void draw(SwapchainPass& pass) const;  ///< after ImGui::Render

 private:
  struct Native;
  std::unique_ptr<Native> native_;
};

}  // namespace boxlight::gpu
