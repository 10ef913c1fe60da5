// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/window_app.h"

#include <chrono>
#include <thread>

#include "common/base/log.h"
#include "runtime/app/controller.h"
#include "runtime/app/gui.h"
#include "runtime/vulkan/swapchain.h"

namespace boxlight::gpu {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kFrame = 16ms;          // the most often that the window is drawn: not every system waits
constexpr auto kProgress = 100ms;      // while slices of a picture are drawn that nobody sees yet
constexpr int kSettlingFrames = 4;     // until the interface has dealt with what happened
constexpr double kIdleSeconds = 0.25;  // between looks at the window while nothing happens

class WindowApp {
 public:
  explicit WindowApp(const ViewOptions& options);
  ~WindowApp() { window_.detachInterface(); }
  void run();
  std::shared_ptr<const ValidationLog> validation() const { return device_.validationLog(); }

 private:
  bool show();

  Window window_;
  WindowSystem system_;
  Gui gui_;
  Device device_;
  Swapchain swapchain_;
  PresentLoop loop_{swapchain_};
  Viewer viewer_;
  ScreenPass screen_;
  std::optional<Overlay> overlay_;
  Controller controller_;
  PassHistory history_;
  Clock::time_point shown_;  // when the window was drawn last
  int settling_ = 0;         // frames to draw though nothing happens
};

WindowApp::WindowApp(const ViewOptions& options)
    : window_(options.settings.camera.size, "ptview"),
      system_(window_.system()),
      gui_(window_.contentScale()),
      device_({.select = options.device, .validation = options.validation, .window = &system_}),
      swapchain_(device_),
      viewer_(device_, options.common.threads),
      screen_(device_, viewer_.display().bindings(), swapchain_),
      controller_(options, window_, viewer_) {
  window_.attachInterface();
  swapchain_.recreate(glm::max(window_.framebufferSize(), 1u));
  overlay_.emplace(device_, swapchain_);
  log().debug("device {}: {}, {}", device_.info().index, device_.info().name, device_.info().driver);
  log().debug("content scale {:.3g}", window_.contentScale());
}

bool WindowApp::show() {
  const uvec2 framebuffer = window_.framebufferSize();
  Session& session = controller_.session();
  overlay_->newFrame();
  window_.newInterfaceFrame();
  gui_.draw(
      session, {viewer_, history_, device_.info().name, controller_.progress()},
      [&](Action action) { controller_.act(action); },
      [&](const std::string& path) { controller_.open(path); });
  return loop_.show(framebuffer, [&] {
    const uvec2 size = swapchain_.extent();
    const ViewSettings& s = session.settings();
    viewer_.display().compose(size, s.toneMap, s.exposure, controller_.splitColumn(size));
    swapchain_.draw([&](SwapchainPass& pass) {
      screen_.draw(pass, std::as_bytes(std::span(&viewer_.display().push(), 1)));
      overlay_->draw(pass);
    });
  });
}

void WindowApp::run() {
  auto last = Clock::now();
  bool busy = true;
  while (!window_.closing()) {
    const auto events = window_.events(busy ? 0.0 : kIdleSeconds);
    const auto start = Clock::now();
    for (const WindowEvent& event : events) controller_.handle(event);
    const uvec2 size = window_.framebufferSize();
    busy = size.x > 0 && size.y > 0;  // else it is minimised
    if (!busy) continue;
    controller_.advance(size, std::chrono::duration<float>(start - last).count());
    last = start;
    const bool changed = viewer_.work(controller_.session().settings());
    if (changed) history_.add(viewer_.times());
    if (changed || !events.empty() || viewer_.isResting() || controller_.isBusy() ||
        start - shown_ > kProgress) {
      show();
      shown_ = start;
    }
    settling_ = events.empty() ? std::max(settling_ - 1, 0) : kSettlingFrames;
    busy = !viewer_.isResting() || settling_ > 0 || controller_.isBusy();
    if (busy && viewer_.isResting()) std::this_thread::sleep_until(start + kFrame);
  }
}

}  // namespace

void runWindow(const ViewOptions& options) {
  std::shared_ptr<const ValidationLog> validation;
  {
    WindowApp app(options);
    validation = app.validation();
    app.run();
  }
  requireSilence(*validation);
}

}  // namespace boxlight::gpu
