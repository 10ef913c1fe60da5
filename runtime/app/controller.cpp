// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/controller.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>

#include "common/base/error.h"
#include "common/base/log.h"
#include "runtime/app/camera_control.h"

namespace boxlight::gpu {
namespace {

constexpr float kOrbitDegrees = 180.0f;  // for a drag over the window's height
constexpr float kZoomStep = 1.1f, kExposureStep = 0.25f;
constexpr float kSplitReach = 0.02f;  // of the window's width, where the split's line is grabbed
constexpr float kLongestStep = 0.1f;  // seconds of flight in one frame

}  // namespace

Controller::Controller(const ViewOptions& options, Window& window, Viewer& viewer)
    : options_(options), window_(window), viewer_(viewer) {
  openFirst();
}

void Controller::advance(uvec2 size, float seconds) {
  if (!window_.isDragging()) dragging_ = false;
  flyHeld(std::min(seconds, kLongestStep));
  session_.camera().size = size;
  pollTruth();
  if (recording_) recordFrame();
}

void Controller::openFirst() {
  session_.file = {options_.asset, options_.environment, options_.settings};
  if (const uvec2 size = window_.framebufferSize(); size.x > 0 && size.y > 0) session_.camera().size = size;
  if (!options_.environment.empty()) viewer_.openEnvironment(options_.environment);
  viewer_.openAsset(options_.asset, session_.settings());
  session_.startCamera = session_.camera();
  if (options_.frames > 1) session_.recording.frames = int(options_.frames);
  session_.flySpeed = 0.5f * glm::length(viewer_.boundsMax() - viewer_.boundsMin());
  if (!options_.truth.empty()) loadTruth();
  window_.setTitle(fmt::format("ptview - {}", options_.asset.filename().string()));
}

void Controller::loadTruth() {
  session_.truth = Truth{readImage(options_.truth),           session_.camera(),
                         session_.file.environment.string(),  session_.settings().environmentDegrees,
                         session_.settings().environmentTilt, session_.settings().environmentIntensity};
  session_.truth->camera.size = {session_.truth->picture.width, session_.truth->picture.height};
  viewer_.display().setTruth(session_.truth->picture);
  session_.split = true;
}

/// What fails after the start leaves a message and everything as it was. False if it failed.
bool Controller::guarded(const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (const Error& error) {
    session_.message = error.what();
    log().error("{}", error.what());
    return false;
  }
}

void Controller::open(const std::filesystem::path& path) {
  guarded([&] {
    if (path.extension() == ".ptb") {
      ViewSettings settings = session_.settings();
      settings.camera.eye.reset();
      settings.camera.target.reset();
      viewer_.openAsset(path, settings);
      session_.settings() = settings;
      session_.file.asset = path;
      session_.startCamera = session_.camera();
      session_.flySpeed = 0.5f * glm::length(viewer_.boundsMax() - viewer_.boundsMin());
      session_.path.clear();
      session_.truth.reset();
      window_.setTitle(fmt::format("ptview - {}", path.filename().string()));
    } else {
      viewer_.openEnvironment(path);
      session_.file.environment = path;
    }
    session_.message = fmt::format("opened {}", path.string());
    log().info("opened {}", path.string());
  });
}

void Controller::drag(const MouseDrag& drag) {
  const vec2 d = drag.heights;
  if (!dragging_) draggingSplit_ = drag.left && holdsSplit();
  dragging_ = true;
  if (draggingSplit_) {
    session_.splitAt = window_.cursorAcross();
    return;
  }
  if (!drag.left || drag.shift)
    pan(session_.camera(), vec2(-d.x, d.y));
  else if (drag.control)
    session_.settings().environmentDegrees =
        std::remainder(session_.settings().environmentDegrees + kOrbitDegrees * d.x, 360.0f);
  else if (session_.flying)
    look(session_.camera(), session_.settings().camera.fovDegrees * d.x,
         -session_.settings().camera.fovDegrees * d.y);
  else
    orbit(session_.camera(), -kOrbitDegrees * d.x, kOrbitDegrees * d.y);
}

void Controller::handle(const WindowEvent& event) {
  if (const auto* key = std::get_if<KeyPress>(&event)) {
    const auto action = actionOf(key->key, key->shift, key->control, session_.flying);
    if (action && gpu::isHeld(*action)) flyKeys_.insert(key->key);
    if (action && !gpu::isHeld(*action)) act(*action);
  } else if (const auto* moved = std::get_if<MouseDrag>(&event)) {
    drag(*moved);
  } else if (const auto* wheel = std::get_if<MouseWheel>(&event)) {
    if (session_.flying)
      session_.flySpeed *= std::pow(kZoomStep, wheel->steps);
    else
      zoom(session_.camera(), std::pow(kZoomStep, wheel->steps));
  } else if (const auto* drop = std::get_if<FileDrop>(&event)) {
    open(drop->path);
  }
}

void Controller::act(Action action) {
  ViewSettings& settings = session_.settings();
  const uint32_t most = viewer_.mostBoxes(),
                 boxes = settings.boxes == 0 ? most : std::min(settings.boxes, most);
  switch (action) {
    case Action::toggleFly:
      session_.flying = !session_.flying;
      session_.message = session_.flying ? "flying: W A S D, E up, Q down; G ends it" : "";
      break;
    case Action::fit:
      fitView(session_.camera(), viewer_.boundsMin(), viewer_.boundsMax());
      break;
    case Action::reset: {
      const uvec2 size = session_.camera().size;
      session_.camera() = session_.startCamera;
      session_.camera().size = size;
      break;
    }
    case Action::help:
      session_.help = !session_.help;
      break;
    case Action::panel:
      session_.panel = !session_.panel;
      break;
    case Action::brighter:
      settings.exposure = std::min(settings.exposure + kExposureStep, 100.0f);
      break;
    case Action::darker:
      settings.exposure = std::max(settings.exposure - kExposureStep, -100.0f);
      break;
    case Action::nextToneMap:
      settings.toneMap = ToneMap((unsigned(settings.toneMap) + 1) % kToneMapNames.size());
      session_.message = fmt::format("tone map: {}", kToneMapNames[size_t(settings.toneMap)]);
      break;
    case Action::background:
      settings.background = !settings.background;
      break;
    case Action::moreBoxes:
      settings.boxes = boxes + 1 >= most ? 0 : boxes + 1;
      break;
    case Action::fewerBoxes:
      settings.boxes = std::max(boxes, 2u) - 1;
      break;
    case Action::cancel:
      if (recording_)
        recording_.reset();
      else if (session_.openDialog || session_.help)
        session_.openDialog = session_.help = false;
      else
        session_.flying = false;
      session_.message.clear();
      break;
    case Action::quit:
      window_.close();
      break;
    default:
      guarded([&] { actOnFiles(action); });
  }
}

void Controller::actOnFiles(Action action) {
  switch (action) {
    case Action::open:
      session_.openDialog = true;
      break;
    case Action::truth:
      toggleTruth();
      break;
    case Action::screenshot:
      screenshot();
      break;
    case Action::saveSettings: {
      const auto path = freeName(options_.captures, "settings", ".json");
      writeSettings(path, session_.file);
      session_.message = fmt::format("saved {}", path.string());
      log().info("saved {}", path.string());
      break;
    }
    case Action::turntable:
      startRecording("turntable", turntableCameras(session_.camera(), session_.recording.frames));
      break;
    case Action::addPathCamera:
      session_.path.push_back(session_.camera());
      session_.message = fmt::format("camera {} of the path", session_.path.size());
      break;
    case Action::clearPath:
      session_.path.clear();
      session_.message = "the path is empty";
      break;
    case Action::recordPath:
      if (session_.path.size() < 2) fail(ExitCode::usage, "a path has two cameras or more: C adds one");
      startRecording("flight", flightCameras(session_.path, session_.recording.frames));
      break;
    default:
      break;
  }
}

void Controller::screenshot() {
  const auto path = freeName(options_.captures, "screenshot", ".png");
  writePicture(path, viewer_.picture(session_.settings()), session_.settings());
  writeSettings(std::filesystem::path(path).replace_extension(".json"), session_.file);
  session_.message = fmt::format("saved {}", path.string());
  log().info("saved {}", path.string());
}

void Controller::startRecording(const char* stem, std::vector<CameraOptions> cameras) {
  recording_.emplace(options_.captures, stem, std::move(cameras), session_.recording.exr);
}

void Controller::recordFrame() {
  const bool went = guarded([&] {
    ViewSettings settings = session_.settings();
    const uvec2 size = settings.camera.size;
    settings.camera = recording_->camera();
    settings.camera.size = size;
    recording_->write(viewer_.picture(settings), settings);
    if (!recording_->done()) return;
    session_.message = fmt::format("recorded {}", recording_->folder().string());
    log().info("recorded {} frames in {}", recording_->frames(), recording_->folder().string());
  });
  if (!went || recording_->done()) recording_.reset();
}

void Controller::toggleTruth() {
  if (session_.truthFits()) {
    session_.split = !session_.split;
    return;
  }
  if (options_.truthScene.empty())
    throw Error(ExitCode::usage, session_.truth
                                     ? "the truth is of another camera or light: R goes back to the start"
                                     : "start ptview with --truth IMAGE, or with --truth-scene SCENE");
  if (session_.file.environment.empty()) fail(ExitCode::usage, "the truth needs a light from a file");
  truthRender_.emplace(options_.truthScene, session_.file);
}

void Controller::pollTruth() {
  if (!truthRender_) return;
  std::optional<Truth> truth;
  try {
    truth = truthRender_->poll();
  } catch (const Error& error) {
    session_.message = error.what();
    log().error("{}", error.what());
    truthRender_.reset();
  }
  if (!truth) return;
  truthRender_.reset();
  session_.truth = std::move(truth);
  viewer_.display().setTruth(session_.truth->picture);
  session_.split = true;
  log().info("the truth is there");
}

/// Along the keys that were pressed to fly and are still held; a tap is one step.
void Controller::flyHeld(float seconds) {
  vec3 direction(0.0f);
  for (const KeyBinding& row : keyTable()) {
    if (!gpu::isHeld(row.action) || !flyKeys_.contains(row.key)) continue;
    const auto axis = [&](Action plus, Action minus) {
      return float(row.action == plus) - float(row.action == minus);
    };
    direction += vec3(axis(Action::flyRight, Action::flyLeft), axis(Action::flyUp, Action::flyDown),
                      axis(Action::flyForward, Action::flyBack));
  }
  std::erase_if(flyKeys_, [&](int key) { return !session_.flying || !window_.isHeld(key); });
  if (!session_.flying || direction == vec3(0.0f)) return;
  const bool fast = window_.isHeld(GLFW_KEY_LEFT_SHIFT) || window_.isHeld(GLFW_KEY_RIGHT_SHIFT);
  fly(session_.camera(), session_.flySpeed * seconds * (fast ? 4.0f : 1.0f) * direction);
}

bool Controller::holdsSplit() const {
  return session_.split && session_.truthFits() &&
         std::abs(window_.pressAcross() - session_.splitAt) < kSplitReach;
}

uint32_t Controller::splitColumn(uvec2 size) const {
  if (!session_.split || !session_.truthFits()) return ~0u;
  return uint32_t(session_.splitAt * float(size.x));
}

std::string Controller::progress() const {
  if (recording_)
    return fmt::format("recording {}: frame {} of {} (Esc stops)", recording_->folder().string(),
                       recording_->written() + 1, recording_->frames());
  return truthRender_ ? "ptbake renders the truth of this camera" : "";
}

}  // namespace boxlight::gpu
