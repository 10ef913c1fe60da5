// SPDX-License-Identifier: Apache-2.0
#include "runtime/vulkan/device.h"

#include <array>
#include <cctype>

#include "common/base/log.h"
#include "runtime/vulkan/native.h"
#include "runtime/vulkan/surface.h"

namespace boxlight::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

/// Throws with a remedy where no Vulkan is installed at all.
template <class Action>
auto withLoader(Action&& action) {
  try {
    return translated("start", [&] {
      try {
        return action();
      } catch (const vk::IncompatibleDriverError&) {
        fail(ExitCode::runtime, "no Vulkan driver; install one, for example mesa-vulkan-drivers");
      }
    });
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {  // from the dynamic loader
    fail(ExitCode::runtime, "no Vulkan loader ({}); install a Vulkan driver, for example mesa-vulkan-drivers",
         error.what());
  }
}

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                         VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  static_cast<ValidationLog*>(user)->add(data->pMessage);
  return VK_FALSE;
}

vk::DebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog& log) {
  using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
  using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
  return {{}, Severity::eError | Severity::eWarning, Type::eValidation | Type::ePerformance, onMessage, &log};
}

void requireLayer(const vk::raii::Context& context) {
  for (const auto& layer : context.enumerateInstanceLayerProperties())
    if (std::string_view(layer.layerName.data()) == kValidationLayer) return;
  fail(ExitCode::runtime, "--validation: {} is not installed (Debian package vulkan-validationlayers)",
       kValidationLayer);
}

void requireExtensions(const vk::raii::Context& context, const std::vector<const char*>& names) {
  const auto there = context.enumerateInstanceExtensionProperties();
  for (const std::string_view name : names)
    if (std::none_of(there.begin(), there.end(), [&](const vk::ExtensionProperties& extension) {
          return name == extension.extensionName.data();
        }))
      fail(ExitCode::runtime, "no Vulkan driver here draws into windows ({} is missing); use --headless",
           name);
}

vk::raii::Instance makeInstance(const vk::raii::Context& context, ValidationLog* log,
                                const WindowSystem* window = nullptr) {
  const vk::ApplicationInfo application("ptview", 1, "boxlight", 1, VK_API_VERSION_1_2);
  std::vector<const char*> extensions;
  if (window) extensions = window->instanceExtensions;
  requireExtensions(context, extensions);
  if (!log) return {context, vk::InstanceCreateInfo({}, &application, {}, extensions)};
  requireLayer(context);
  const std::array layers = {kValidationLayer};
  extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  const std::array enabled = {vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
  const vk::StructureChain chain(vk::InstanceCreateInfo({}, &application, layers, extensions),
                                 messengerInfo(*log), vk::ValidationFeaturesEXT(enabled));
  return {context, chain.get<vk::InstanceCreateInfo>()};
}

std::optional<uint32_t> workFamily(const vk::raii::PhysicalDevice& physical) {
  const auto families = physical.getQueueFamilyProperties();
  constexpr auto kNeeded = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
  for (uint32_t i = 0; i < families.size(); ++i)
    if ((families[i].queueFlags & kNeeded) == kNeeded) return i;
  return {};
}

/// The family that shows windows: the working one if it does.
std::optional<uint32_t> presentFamily(const vk::raii::PhysicalDevice& physical, vk::SurfaceKHR surface) {
  std::optional<uint32_t> found;
  const auto work = workFamily(physical);
  for (uint32_t i = 0; i < physical.getQueueFamilyProperties().size(); ++i)
    if (physical.getSurfaceSupportKHR(i, surface) && (!found || i == work)) found = i;
  return found;
}

/// Can it show the window at all, in some format and some mode?
bool canPresent(const vk::raii::PhysicalDevice& physical, vk::SurfaceKHR surface) {
  const auto extensions = physical.enumerateDeviceExtensionProperties();
  const bool swapchains =
      std::any_of(extensions.begin(), extensions.end(), [](const vk::ExtensionProperties& extension) {
        return std::string_view(extension.extensionName.data()) == VK_KHR_SWAPCHAIN_EXTENSION_NAME;
      });
  return swapchains && presentFamily(physical, surface) && !physical.getSurfaceFormatsKHR(surface).empty() &&
         !physical.getSurfacePresentModesKHR(surface).empty();
}

DeviceInfo describe(const vk::raii::PhysicalDevice& physical, uint32_t index) {
  const auto chain =
      physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
  const auto& properties = chain.get<vk::PhysicalDeviceProperties2>().properties;
  const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
  DeviceInfo info;
  info.index = index;
  info.name = properties.deviceName.data();
  info.kind = vk::to_string(properties.deviceType);
  info.driver = fmt::format("{} {}", driver.driverName.data(), driver.driverInfo.data());
  info.apiVersion =
      fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(properties.apiVersion),
                  VK_API_VERSION_MINOR(properties.apiVersion), VK_API_VERSION_PATCH(properties.apiVersion));
  info.usable = properties.apiVersion >= VK_API_VERSION_1_2 && workFamily(physical).has_value();
  return info;
}

int rank(const DeviceInfo& info) {
  constexpr std::array kFastestFirst = {"DiscreteGpu", "IntegratedGpu", "VirtualGpu", "Cpu"};
  return int(std::find(kFastestFirst.begin(), kFastestFirst.end(), info.kind) - kFastestFirst.begin());
}

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool matches(const DeviceInfo& info, const std::string& select) {
  if (select.find_first_not_of("0123456789") == std::string::npos)
    return std::to_string(info.index) == select;
  return lower(info.name).find(lower(select)) != std::string::npos;
}

/// `shows`: which of them can show the window; empty without one.
uint32_t chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& select,
                      const std::vector<bool>& shows) {
  bool hidden = false;
  const DeviceInfo* best = nullptr;
  std::string names;
  for (const auto& info : devices) {
    names += fmt::format("{}{}: {}", names.empty() ? "" : ", ", info.index, info.name);
    if (!info.usable || (!select.empty() && !matches(info, select))) continue;
    if (!shows.empty() && !shows[info.index]) {
      hidden = true;
      continue;
    }
    if (!best || rank(info) < rank(*best)) best = &info;
  }
  if (devices.empty())
    fail(ExitCode::runtime, "no Vulkan device; install a driver, for example mesa-vulkan-drivers");
  if (!best && hidden)
    fail(ExitCode::runtime,
         "{} can show this window; there are {}. Choose another --device, or use --headless",
         select.empty() ? "no Vulkan device" : fmt::format("no Vulkan device that matches '{}'", select),
         names);
  if (!best && !select.empty())
    fail(ExitCode::runtime, "--device: no usable Vulkan device matches '{}'; there are {}", select, names);
  if (!best)
    fail(ExitCode::runtime, "no device has Vulkan 1.2 with graphics and compute; there are {}", names);
  return best->index;
}

std::vector<DeviceInfo> describeAll(const std::vector<vk::raii::PhysicalDevice>& devices) {
  std::vector<DeviceInfo> infos;
  for (const auto& physical : devices) infos.push_back(describe(physical, uint32_t(infos.size())));
  return infos;
}

/// What the drivers of desktops have at least; elsewhere it may be 65536.
constexpr uint32_t kLargeTexelBuffer = 1u << 27;

DeviceLimits queryLimits(const vk::raii::PhysicalDevice& physical) {
  const auto limits = physical.getProperties().limits;
  DeviceLimits result;
  result.maxStorageBufferRange = limits.maxStorageBufferRange;
  result.maxStorageBuffers =
      std::min({limits.maxPerStageDescriptorStorageBuffers, limits.maxDescriptorSetStorageBuffers,
                limits.maxPerStageResources - 2});
  result.maxImageSize =
      std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight,
                limits.maxViewportDimensions[0], limits.maxViewportDimensions[1]});
  result.maxWorkGroups = limits.maxComputeWorkGroupCount[0];
  result.maxTexels = limits.maxTexelBufferElements;
  result.texelBuffers = result.maxTexels >= kLargeTexelBuffer;
  return result;
}

void openQueue(Device::Native& native) {
  native.queueFamily = *workFamily(native.physical);
  native.timestampBits = native.physical.getQueueFamilyProperties()[native.queueFamily].timestampValidBits;
  native.nanosecondsPerTick = native.physical.getProperties().limits.timestampPeriod;
  const float priority = 1.0f;
  const bool shows = *native.surface != vk::SurfaceKHR();
  native.presentFamily = shows ? *presentFamily(native.physical, *native.surface) : native.queueFamily;
  std::vector<vk::DeviceQueueCreateInfo> queues = {{{}, native.queueFamily, 1, &priority}};
  if (native.presentFamily != native.queueFamily)
    queues.emplace_back(vk::DeviceQueueCreateFlags{}, native.presentFamily, 1, &priority);
  std::vector<const char*> extensions;
  if (shows) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  native.device = vk::raii::Device(native.physical, vk::DeviceCreateInfo({}, queues, {}, extensions));
  native.queue = native.device.getQueue(native.queueFamily, 0);
  native.presentQueue = native.device.getQueue(native.presentFamily, 0);
  native.pool =
      vk::raii::CommandPool(native.device, {vk::CommandPoolCreateFlagBits::eTransient, native.queueFamily});
  native.queries = vk::raii::QueryPool(native.device, {{}, vk::QueryType::eTimestamp, 2 * kMaxPasses});
}

}  // namespace

void ValidationLog::add(const char* message) {
  const std::lock_guard lock(mutex_);
  if (count_++ == 0) first_ = message;
  log().warn("validation: {}", message);
}

void ValidationLog::require() const {
  const std::lock_guard lock(mutex_);
  if (count_)
    fail(ExitCode::runtime, "the Vulkan validation layer gave {} messages, the first: {}", count_, first_);
}

void requireSilence(const ValidationLog& log) { log.require(); }

std::vector<DeviceInfo> listDevices() {
  return withLoader([] {
    const vk::raii::Context context;
    const vk::raii::Instance instance = makeInstance(context, nullptr);
    return describeAll(vk::raii::PhysicalDevices(instance));
  });
}

Device::Device(const DeviceOptions& options) {
  withLoader([&] {
    native_ = std::make_unique<Native>();
    native_->instance = makeInstance(
        native_->context, options.validation ? native_->validation.get() : nullptr, options.window);
    if (options.validation)
      native_->messenger =
          vk::raii::DebugUtilsMessengerEXT(native_->instance, messengerInfo(*native_->validation));
    vk::raii::PhysicalDevices devices(native_->instance);
    const auto infos = describeAll(devices);
    std::vector<bool> shows;
    if (options.window) {
      VkSurfaceKHR surface = VK_NULL_HANDLE;
      if (options.window->makeSurface(*native_->instance, &surface) != VK_SUCCESS)
        fail(ExitCode::runtime, "the window has no surface for Vulkan to draw on; use --headless");
      native_->surface = vk::raii::SurfaceKHR(native_->instance, surface);
      for (const auto& physical : devices) shows.push_back(canPresent(physical, surface));
    }
    const uint32_t chosen = chooseDevice(infos, options.select, shows);
    native_->info = infos[chosen];
    native_->physical = std::move(devices[chosen]);
    native_->limits = queryLimits(native_->physical);
    native_->limits.texelBuffers &= options.texelBuffers;
    native_->validated = options.validation;
    openQueue(*native_);
  });
}

Device::~Device() = default;

const DeviceInfo& Device::info() const { return native_->info; }
const DeviceLimits& Device::limits() const { return native_->limits; }
std::shared_ptr<const ValidationLog> Device::validationLog() const { return native_->validation; }

vk::raii::DeviceMemory Device::Native::allocate(const vk::MemoryRequirements& requirements,
                                                vk::MemoryPropertyFlags wanted,
                                                vk::MemoryPropertyFlags needed) const {
  const auto memory = physical.getMemoryProperties();
  for (const auto& properties : {wanted, needed})
    for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
      if ((requirements.memoryTypeBits >> i & 1) &&
          (memory.memoryTypes[i].propertyFlags & properties) == properties)
        return {device, vk::MemoryAllocateInfo(requirements.size, i)};
  fail(ExitCode::runtime, "'{}' has no memory of the kind needed", info.name);
}

}  // namespace boxlight::gpu
