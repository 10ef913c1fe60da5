// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/headless_app.h"

#include <fmt/format.h>

#include <future>
#include <nlohmann/json.hpp>

#include "common/base/file.h"
#include "common/base/log.h"
#include "common/image/image_sequence.h"
#include "common/light/environment.h"
#include "runtime/app/frame.h"
#include "runtime/app/keys.h"
#include "runtime/app/recording.h"
#include "runtime/app/stats.h"
#include "runtime/light/light_size.h"

namespace boxlight::gpu {
namespace {

/// Frame after frame under the images of a sequence, each picture to a file of its own; the next image is
/// read while this one's frame is drawn.
void runSequence(const ViewOptions& options, FrameRenderer& renderer, FrameTimes& times) {
  const auto read = [&](uint32_t frame) {
    return std::async(std::launch::async, readEnvironment, numberedPath(options.environment, frame));
  };
  std::future<Image> next;
  for (uint32_t i = 0; i < options.frames; ++i) {
    const uint32_t frame = options.firstFrame + i;
    if (i > 0) {
      const Image environment = next.get();
      renderer.set(renderer.settings(), &environment);
    }
    if (i + 1 < options.frames) next = read(frame + 1);
    times.add(renderer.run());
    writePicture(numberedPath(options.output, frame), renderer.picture(), options.settings);
  }
}

void renderOn(Device& device, const ViewOptions& options, const asset::AssetReader& reader,
              const Image& environment) {
  const uvec2 lightSize = chooseLightSize(reader, {environment.width, environment.height});
  const FrameSettings settings =
      frameSettings(options.settings, reader.asset().info, lightSize, options.common.threads);
  log().debug("device {}: {}, {}", device.info().index, device.info().name, device.info().driver);
  FrameRenderer renderer(device, reader, environment, settings);
  FrameTimes times;
  if (isNumbered(options.environment)) {
    runSequence(options, renderer, times);
  } else {
    for (uint32_t frame = 0; frame < options.frames; ++frame) times.add(renderer.run());
    writePicture(options.output, renderer.picture(), options.settings);
  }
  const auto stats = describeFrame(device.info(), settings, renderer.counts(), times, options.frames);
  if (!options.stats.empty()) writeTextFile(options.stats, stats.dump(2) + "\n");
  if (options.common.json) fmt::print("{}\n", stats.dump(2));
}

}  // namespace

void printDevices(bool json) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DeviceInfo& device : listDevices()) {
    if (!json)
      fmt::print("{}: {} ({}, Vulkan {}, {}){}\n", device.index, device.name, device.kind, device.apiVersion,
                 device.driver, device.usable ? "" : " - not usable");
    list.push_back({{"index", device.index},
                    {"name", device.name},
                    {"kind", device.kind},
                    {"api", device.apiVersion},
                    {"driver", device.driver},
                    {"usable", device.usable}});
  }
  if (json) fmt::print("{}\n", list.dump(2));
}

void printKeys() { fmt::print("{}", keysAsMarkdown()); }

void renderHeadless(const ViewOptions& options) {
  const asset::AssetReader reader(options.asset);
  reader.verifyPages();  // a picture is either from a sound asset or not made; the camera needs only some of
                         // the pages
  const Image environment = readEnvironment(numberedPath(options.environment, options.firstFrame));
  std::shared_ptr<const ValidationLog> validation;
  {
    Device device({options.device, options.validation});
    validation = device.validationLog();
    renderOn(device, options, reader, environment);
  }
  requireSilence(*validation);
}

}  // namespace boxlight::gpu
