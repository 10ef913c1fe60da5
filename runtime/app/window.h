// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <variant>

#include "common/base/math.h"
#include "runtime/vulkan/surface.h"

struct GLFWwindow;

namespace boxlight::gpu {

struct KeyPress {
  int key;
  bool shift, control;
};
struct MouseDrag {
  vec2 heights;  ///< right and down, in heights of the window
  bool left, shift, control;
};
struct MouseWheel {
  float steps;  ///< away from the user
};
struct FileDrop {
  std::filesystem::path path;
};
using WindowEvent = std::variant<KeyPress, MouseDrag, MouseWheel, FileDrop>;

/// A window of the desktop, with Dear ImGui's input attached once attachInterface() is called. One at a time.
class Window {
 public:
  /// `size`: of the framebuffer where screen and framebuffer coordinates are the same. Error:
  /// ExitCode::runtime with GLFW's reason and the remedy.
  Window(uvec2 size, const char* title);
  ~Window();

  WindowSystem system() const;  ///< for a Device, which must not outlive the window
  void attachInterface();       ///< the ImGui context must exist
  void detachInterface();
  void newInterfaceFrame();

  /// Events since the last call, in order; those that the interface took are left out. Waits up to `seconds`
  /// if there are none.
  std::deque<WindowEvent> events(double seconds);
  bool closing() const;
  void close();
  bool isHeld(int key) const;
  bool isDragging() const;        ///< is a mouse button held?
  uvec2 framebufferSize() const;  ///< pixels; 0 while minimised
  float contentScale() const;  ///< of text and of what is touched: 2 on a screen of twice the usual density
  float cursorAcross() const;  ///< of the window's width, 0 to 1
  float pressAcross() const;   ///< the same where the mouse was pressed last
  void setTitle(const std::string& title);

 private:
  struct Callbacks;
  float across(double x) const;

  GLFWwindow* window_;
  std::deque<WindowEvent> queue_;
  dvec2 cursor_{0}, press_{0};
};

}  // namespace boxlight::gpu
