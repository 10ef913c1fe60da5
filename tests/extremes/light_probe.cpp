// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/light_probe.h"

#include <array>

#include "probe_comp.h"

namespace boxlight::test {
namespace {

struct Where {
  uvec2 size;
  float unit, offset;
};

}  // namespace

LightProbe::LightProbe(gpu::Device& device, const Image& environment, const gpu::LightSettings& settings,
                       EnvironmentTilt tilt)
    : device_(device),
      light_(device, environment, tilt, settings),
      bindings_(device),
      pipeline_(device, bindings_, probe_comp,
                std::array<uint32_t, 1>{settings.scheme == gpu::SatScheme::exact}) {
  device.run([&](gpu::Commands& commands) { light_.build(commands); });
  light_.show();
}

std::vector<Integral> LightProbe::integrate(std::span<const GridBox> boxes, float uOffset) {
  std::vector<std::array<float, 5>> rectangles;
  for (const GridBox& b : boxes)
    rectangles.push_back({float(b.u) / 65536, float(b.du) / 65536, float(b.v) / 65536, float(b.dv) / 65536,
                          float(65536 - b.v - b.dv) / 65536});
  return integrate(rectangles, uOffset);
}

std::vector<Integral> LightProbe::integrate(const std::vector<std::array<float, 5>>& rectangles,
                                            float uOffset) {
  const auto where =
      gpu::makeBuffer(device_, "where", std::vector{Where{light_.size(), light_.unit(), uOffset}});
  const auto asked = gpu::makeBuffer(device_, "rectangles", rectangles);
  const gpu::Buffer integrals(device_, "integrals", rectangles.size() * sizeof(Integral));
  bindings_.set(0, where);
  bindings_.set(1, light_.table());
  bindings_.set(2, asked);
  bindings_.set(3, integrals);
  const auto groups = uint32_t((rectangles.size() + 63) / 64);
  device_.run([&](gpu::Commands& commands) { commands.dispatch(pipeline_, {groups, 1, 1}); });
  return gpu::readBuffer<Integral>(device_, integrals, rectangles.size());
}

}  // namespace boxlight::test
