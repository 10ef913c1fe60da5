// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/truth_render.h"

#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>

#include "common/base/error.h"

namespace boxlight::gpu {
namespace {

constexpr int kPathsPerPixel = 64;
constexpr int kLowestPriority = 19;

/// ptbake beside this program, else by the PATH.
std::string bakeProgram() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto beside = self.parent_path() / "ptbake";
  return !error && std::filesystem::exists(beside) ? beside.string() : "ptbake";
}

std::string text(vec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

std::vector<std::string> command(const std::filesystem::path& scene, const SettingsFile& file,
                                 const std::filesystem::path& output) {
  const CameraOptions& camera = file.settings.camera;
  return {bakeProgram(),
          "render",
          scene.string(),
          "--quiet",
          "--env",
          file.environment.string(),
          "-o",
          output.string(),
          "--eye=" + text(*camera.eye),
          "--target=" + text(*camera.target),
          "--up=" + text(camera.up),
          fmt::format("--fov={}", camera.fovDegrees),
          fmt::format("--size={}x{}", camera.size.x, camera.size.y),
          fmt::format("--env-rotation={}", file.settings.environmentDegrees),
          fmt::format("--env-pitch={}", file.settings.environmentTilt.pitch),
          fmt::format("--env-roll={}", file.settings.environmentTilt.roll),
          fmt::format("--env-intensity={}", file.settings.environmentIntensity),
          fmt::format("--background={}", file.settings.background ? "on" : "off"),
          fmt::format("--spp={}", kPathsPerPixel)};
}

}  // namespace

TruthRender::TruthRender(const std::filesystem::path& scene, const SettingsFile& file)
    : file_(file),
      output_(std::filesystem::temp_directory_path() / fmt::format("ptview-truth-{}.exr", ::getpid())) {
  std::vector<std::string> words = command(scene, file, output_);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = -1;
  if (const int error = posix_spawnp(&process, arguments[0], nullptr, nullptr, arguments.data(), environ))
    fail(ExitCode::io, "{}: cannot start: {}; put ptbake beside ptview or on the PATH", words[0],
         std::strerror(error));
  process_ = process;
  setpriority(PRIO_PROCESS, id_t(process), kLowestPriority);
}

TruthRender::~TruthRender() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  std::error_code ignored;
  std::filesystem::remove(output_, ignored);
}

std::optional<Truth> TruthRender::poll() {
  int status = 0;
  if (process_ <= 0 || waitpid(process_, &status, WNOHANG) == 0) return {};
  process_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    fail(ExitCode::runtime, "ptbake render failed: its message is in the terminal");
  return Truth{readImage(output_),
               file_.settings.camera,
               file_.environment.string(),
               file_.settings.environmentDegrees,
               file_.settings.environmentTilt,
               file_.settings.environmentIntensity};
}

}  // namespace boxlight::gpu
