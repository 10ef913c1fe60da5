// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/window.h"

#define GLFW_INCLUDE_NONE
#include <vulkan/vulkan_core.h>
// GLFW declares its Vulkan functions once Vulkan is known.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <string>

#include "common/base/error.h"

namespace boxlight::gpu {
namespace {

std::string lastReason;  // GLFW reports by callback

void onError(int, const char* description) { lastReason = description; }

[[noreturn]] void failWindow() {
  glfwTerminate();
  fail(ExitCode::runtime,
       "no window can be opened: {}; run ptview where there is a display (DISPLAY or "
       "WAYLAND_DISPLAY), or add --headless",
       lastReason.empty() ? "no reason given" : lastReason);
}

bool interfaceHasMouse() { return ImGui::GetCurrentContext() && ImGui::GetIO().WantCaptureMouse; }
bool interfaceHasText() { return ImGui::GetCurrentContext() && ImGui::GetIO().WantTextInput; }

}  // namespace

/// What GLFW calls.
struct Window::Callbacks {
  static Window& of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

  static void onKey(GLFWwindow* window, int key, int, int action, int modifiers) {
    if (action == GLFW_RELEASE) return;
    if (interfaceHasText() && key != GLFW_KEY_ESCAPE) return;
    of(window).queue_.push_back(
        KeyPress{key, (modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_CONTROL) != 0});
  }

  static void onCursor(GLFWwindow* handle, double x, double y) {
    Window& window = of(handle);
    const dvec2 moved = dvec2(x, y) - window.cursor_;
    window.cursor_ = {x, y};
    if (!window.isDragging() || interfaceHasMouse()) return;
    const bool left = glfwGetMouseButton(handle, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    int width = 0, height = 0;
    glfwGetWindowSize(handle, &width, &height);
    const bool shift = window.isHeld(GLFW_KEY_LEFT_SHIFT) || window.isHeld(GLFW_KEY_RIGHT_SHIFT);
    const bool control = window.isHeld(GLFW_KEY_LEFT_CONTROL) || window.isHeld(GLFW_KEY_RIGHT_CONTROL);
    window.queue_.push_back(MouseDrag{vec2(moved / double(std::max(height, 1))), left, shift, control});
  }

  static void onButton(GLFWwindow* handle, int, int action, int) {
    if (action == GLFW_PRESS) of(handle).press_ = of(handle).cursor_;
  }

  static void onScroll(GLFWwindow* window, double, double y) {
    if (!interfaceHasMouse()) of(window).queue_.push_back(MouseWheel{float(y)});
  }

  static void onDrop(GLFWwindow* window, int count, const char** paths) {
    for (int i = 0; i < count; ++i) of(window).queue_.push_back(FileDrop{paths[i]});
  }
};

Window::Window(uvec2 size, const char* title) {
  lastReason.clear();
  glfwSetErrorCallback(onError);
  if (!glfwInit()) failWindow();
  if (!glfwVulkanSupported()) {
    lastReason = "no Vulkan loader or driver; install one, for example mesa-vulkan-drivers";
    failWindow();
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(int(size.x), int(size.y), title, nullptr, nullptr);
  if (!window_) failWindow();
  glfwSetWindowUserPointer(window_, this);
  glfwGetCursorPos(window_, &cursor_.x, &cursor_.y);
  glfwSetKeyCallback(window_, Callbacks::onKey);
  glfwSetCursorPosCallback(window_, Callbacks::onCursor);
  glfwSetMouseButtonCallback(window_, Callbacks::onButton);
  glfwSetScrollCallback(window_, Callbacks::onScroll);
  glfwSetDropCallback(window_, Callbacks::onDrop);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

WindowSystem Window::system() const {
  WindowSystem system;
  uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (names) system.instanceExtensions.assign(names, names + count);
  system.makeSurface = [window = window_](VkInstance instance, VkSurfaceKHR* surface) {
    return glfwCreateWindowSurface(instance, window, nullptr, surface);
  };
  return system;
}

void Window::attachInterface() { ImGui_ImplGlfw_InitForVulkan(window_, true); }
void Window::detachInterface() { ImGui_ImplGlfw_Shutdown(); }
void Window::newInterfaceFrame() { ImGui_ImplGlfw_NewFrame(); }

std::deque<WindowEvent> Window::events(double seconds) {
  if (seconds > 0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
  return std::exchange(queue_, {});
}

bool Window::closing() const { return glfwWindowShouldClose(window_); }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
bool Window::isDragging() const {
  const auto down = [&](int button) { return glfwGetMouseButton(window_, button) == GLFW_PRESS; };
  return down(GLFW_MOUSE_BUTTON_LEFT) || down(GLFW_MOUSE_BUTTON_MIDDLE) || down(GLFW_MOUSE_BUTTON_RIGHT);
}

bool Window::isHeld(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

uvec2 Window::framebufferSize() const {
  if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return uvec2(0);
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {std::max(width, 0), std::max(height, 0)};
}

float Window::contentScale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::max(x, y);
}

float Window::across(double x) const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_, &width, &height);
  return std::clamp(float(x) / float(std::max(width, 1)), 0.0f, 1.0f);
}

float Window::cursorAcross() const { return across(cursor_.x); }
float Window::pressAcross() const { return across(press_.x); }

void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

}  // namespace boxlight::gpu
