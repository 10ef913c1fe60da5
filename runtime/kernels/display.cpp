// SPDX-License-Identifier: Apache-2.0
#include "runtime/kernels/display.h"

#include <cmath>
#include <cstring>
#include <utility>

#include "runtime/kernels/visibility.h"
#include "spirv/display_comp.h"

namespace boxlight::gpu {
namespace {

uint64_t area(uvec2 size) { return uint64_t(size.x) * size.y; }

}  // namespace

Display::Display(Device& device)
    : device_(device),
      bindings_(device),
      pipeline_(device, bindings_, display_comp),
      shown_{uvec2(1), Buffer(device, "picture shown", sizeof(vec4))},
      next_{uvec2(1), Buffer(device, "picture shown next", sizeof(vec4))},
      truth_{uvec2(1), Buffer(device, "truth", sizeof(vec4))},
      display_(device, "display", sizeof(uint32_t)) {
  const vec4 nothing(0.0f);
  for (Picture* picture : {&shown_, &next_, &truth_})
    upload(device, picture->pixels, std::as_bytes(std::span(&nothing, 1)));
}

/// Buffers only grow: pictures change their size with every movement.
void Display::fit(Picture& picture, const char* name, uvec2 size) {
  picture.size = size;
  if (area(size) * sizeof(vec4) > picture.pixels.size())
    picture.pixels = Buffer(device_, name, area(size) * sizeof(vec4));
}

void Display::beginPicture(uvec2 size) { fit(next_, "picture shown next", size); }

void Display::addTile(const Buffer& pixels, const ImageTile& tile) {
  device_.run([&](Commands& commands) { commands.copyTile(pixels, next_.pixels, tile, next_.size.x); });
}

void Display::endPicture() {
  std::swap(shown_, next_);
  stale_ = true;
}

void Display::setTruth(const Image& truth) {
  std::vector<vec4> pixels;
  pixels.reserve(area({truth.width, truth.height}));
  for (uint32_t y = 0; y < truth.height; ++y)
    for (uint32_t x = 0; x < truth.width; ++x) pixels.emplace_back(rgbAt(truth, x, y), alphaAt(truth, x, y));
  fit(truth_, "truth", {truth.width, truth.height});
  upload(device_, truth_.pixels, std::as_bytes(std::span(pixels)));
  stale_ = true;
}

void Display::compose(uvec2 size, ToneMap toneMap, float exposure, uint32_t split) {
  const DisplayPush push{size, shown_.size, truth_.size, uint32_t(toneMap), split, std::exp2(exposure)};
  if (!stale_ && std::memcmp(&push, &push_, sizeof(push)) == 0) return;
  stale_ = false;
  push_ = push;
  if (area(size) * sizeof(uint32_t) > display_.size())
    display_ = Buffer(device_, "display", area(size) * sizeof(uint32_t));
  bindings_.set(kBindShown, shown_.pixels);
  bindings_.set(kBindTruth, truth_.pixels);
  bindings_.set(kBindDisplay, display_);
  device_.run([&](Commands& commands) {
    commands.dispatch(pipeline_, imageGroups(size), std::as_bytes(std::span(&push_, 1)));
  });
}

std::vector<uint32_t> Display::read() { return readBuffer<uint32_t>(device_, display_, area(push_.size)); }

}  // namespace boxlight::gpu
