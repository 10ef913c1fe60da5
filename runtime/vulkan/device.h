// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace boxlight::gpu {

class Commands;

struct DeviceInfo {
  uint32_t index = 0;  ///< what `--device` takes
  std::string name, kind, driver, apiVersion;
  bool usable = false;  ///< Vulkan 1.2 or later, with a queue for graphics and compute
};

/// What the device allows, in bytes and texels; nothing in the runtime assumes more.
struct DeviceLimits {
  uint64_t maxStorageBufferRange = 0;
  uint32_t maxStorageBuffers = 0;  ///< in one shader stage
  uint32_t maxImageSize = 0;       ///< of a colour attachment, each way
  uint32_t maxWorkGroups = 0;      ///< in x
  uint32_t maxTexels = 0;          ///< of a texel buffer
  bool texelBuffers = false;       ///< those are large enough to read light and visibility maps from
};

struct WindowSystem;  // vulkan/surface.h

struct DeviceOptions {
  std::string select;  ///< index or part of the name; empty takes the fastest kind
  /// Load the Khronos validation layer, with synchronisation checks, and fill new buffers with what is no
  /// number.
  bool validation = false;
  bool texelBuffers = true;              ///< use them where they are large
  const WindowSystem* window = nullptr;  ///< where a window is to be drawn; else no device needs to show any
};

/// Messages of the validation layer. It outlives the device, so that leaks found at its end are counted too.
class ValidationLog;
/// Throws Error(ExitCode::runtime) if the layer said anything.
void requireSilence(const ValidationLog& log);

struct PassTime {
  std::string name;
  double milliseconds = 0;
};

/// One Vulkan device with one queue, and one more where another one shows windows. Errors of Vulkan leave
/// this wing as Error(ExitCode::runtime).
class Device {
 public:
  explicit Device(const DeviceOptions& options);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const DeviceInfo& info() const;
  const DeviceLimits& limits() const;
  std::shared_ptr<const ValidationLog> validationLog() const;

  /// Records by `record`, submits and waits. Returns the GPU time of each pass that was marked
  /// (Commands::pass), in order; none if the device has no timestamps.
  std::vector<PassTime> run(const std::function<void(Commands&)>& record);

  struct Native;  ///< vulkan/native.h: for this wing only
  Native& native() const { return *native_; }

 private:
  std::unique_ptr<Native> native_;
};

/// Every device that the Vulkan loader finds, usable or not.
std::vector<DeviceInfo> listDevices();

}  // namespace boxlight::gpu
