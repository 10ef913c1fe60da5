// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/headless_app.h"
#include "runtime/app/window_app.h"

int main(int argc, char** argv) {
  using namespace boxlight;
  CLI::App app("Relights baked assets (.ptb) on a Vulkan device", "ptview");
  gpu::ViewOptions options;
  gpu::addViewOptions(app, options);
  return runMain(app, argc, argv, options.common, [&] {
    gpu::checkViewOptions(options);
    if (options.listDevices) return gpu::printDevices(options.common.json);
    if (options.listKeys) return gpu::printKeys();
    if (!options.headless) return gpu::runWindow(options);
    gpu::renderHeadless(options);
  });
}
