// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "bake/study/kernel_study.h"
#include "common/light/light_domain.h"
#include "common/light/relight.h"

namespace boxlight {
namespace {

constexpr uvec2 kMapSize{512, 256};

struct Probe {
  const char* name;
  vec3 axis;
  float cosine;  ///< light comes from directions at least as close to the axis
};

const std::array<Probe, 13>& probes() {
  static const float kLamp = std::cos(kPi / 18);
  static const std::array<Probe, 13> list = {{{"white sky", {0, 1, 0}, -2},
                                              {"half sky +X", {1, 0, 0}, 0},
                                              {"half sky -X", {-1, 0, 0}, 0},
                                              {"half sky +Y", {0, 1, 0}, 0},
                                              {"half sky -Y", {0, -1, 0}, 0},
                                              {"half sky +Z", {0, 0, 1}, 0},
                                              {"half sky -Z", {0, 0, -1}, 0},
                                              {"lamp +X", {1, 0, 0}, kLamp},
                                              {"lamp -X", {-1, 0, 0}, kLamp},
                                              {"lamp +Y", {0, 1, 0}, kLamp},
                                              {"lamp -Y", {0, -1, 0}, kLamp},
                                              {"lamp +Z", {0, 0, 1}, kLamp},
                                              {"lamp -Z", {0, 0, -1}, kLamp}}};
  return list;
}

Image lightMapOf(const Probe& probe) {
  Image map = makeImage(kMapSize.x, kMapSize.y, 3);
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 0; x < map.width; ++x) {
      const vec3 d = uvToDirection((vec2(x, y) + 0.5f) / vec2(kMapSize));
      if (glm::dot(d, probe.axis) >= probe.cosine) std::fill_n(map.at(x, y), 3, 1.0f);
    }
  const double mean = SummedArea(map).integrate({0, 0, 1, 1}).x / (4 * kPiDouble);
  for (float& value : map.pixels) value = float(value / mean);
  return map;
}

dvec3 ofPaths(const KernelStudy& study, const Image& map) {
  dvec3 sum(0.0);
  for (const Deposit& deposit : study.deposits) {
    const uvec2 texel = glm::min(uvec2(deposit.uv * vec2(kMapSize)), kMapSize - 1u);
    sum += dvec3(deposit.throughput) * double(map.at(texel.x, texel.y)[0]);
  }
  return study.traced ? sum / double(study.traced) : sum;
}

dvec3 ofBoxes(const KernelStudy& study, const SummedArea& light) {
  dvec3 sum(0.0);
  for (const Box& box : study.boxes) sum += dvec3(box.energy) * light.integrate(box, 0.0) / box.solidAngle();
  const auto& n = study.plan.record.normal;
  return sum + straightRadiance(study.cosineBoxes, dvec3(n[0], n[1], n[2]), light).radiance;
}

}  // namespace

double ProbeAnswer::error() const {
  const double difference = glm::length(boxes - paths), size = glm::length(paths);
  return difference > 0 ? difference / size : 0;
}

std::vector<ProbeAnswer> probeKernel(const KernelStudy& study) {
  std::vector<ProbeAnswer> answers;
  for (const Probe& probe : probes()) {
    const Image map = lightMapOf(probe);
    answers.push_back({probe.name, ofPaths(study, map), ofBoxes(study, SummedArea(map))});
  }
  return answers;
}

}  // namespace boxlight
