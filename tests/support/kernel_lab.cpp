// SPDX-License-Identifier: Apache-2.0
#include "tests/support/kernel_lab.h"

#include <cmath>

#include "common/light/ggx.h"
#include "common/light/light_domain.h"

namespace boxlight::lab {
namespace {

constexpr uint32_t kLightWidth = 512, kLightHeight = 256;

vec3 cosineDirection(vec3 normal, Random& random) {
  return glm::normalize(normal + 0.999f * random.direction());
}

}  // namespace

vec3 Random::direction() {
  const float z = 1.0f - 2.0f * uniform(), phi = 2.0f * kPi * uniform();
  const float ring = std::sqrt(std::max(0.0f, 1.0f - z * z));
  return {ring * std::cos(phi), ring * std::sin(phi), z};
}

Light makeLight(uint64_t seed, bool sun) {
  struct Lobe {
    vec3 axis;
    float sharpness;
    Rgb amplitude;
  };
  Random random(seed);
  std::vector<Lobe> lobes;
  const auto addLobe = [&](float sharpness, float energy) {
    const Rgb colour = Rgb(0.5f) + 0.5f * Rgb(random.uniform(), random.uniform(), random.uniform());
    lobes.push_back({random.direction(), sharpness, 2.0f * sharpness * energy * colour});
  };
  for (int i = 0; i < 8; ++i) addLobe(2.0f * std::pow(100.0f, random.uniform()), 0.1f);
  if (sun) addLobe(2000.0f, 0.6f);
  return [lobes](vec3 direction) {
    Rgb radiance(0.2f);
    for (const Lobe& lobe : lobes)
      radiance += lobe.amplitude * std::exp(lobe.sharpness * (glm::dot(direction, lobe.axis) - 1.0f));
    return radiance;
  };
}

SummedArea tableOf(const Light& light) {
  Image map = makeImage(kLightWidth, kLightHeight, 3);
  for (uint32_t y = 0; y < kLightHeight; ++y)
    for (uint32_t x = 0; x < kLightWidth; ++x) {
      const vec2 uv((float(x) + 0.5f) / kLightWidth, (float(y) + 0.5f) / kLightHeight);
      const Rgb radiance = light(uvToDirection(uv));
      for (int c = 0; c < 3; ++c) map.at(x, y)[c] = radiance[c];
    }
  return SummedArea(map);
}

dvec3 relight(const std::vector<Box>& boxes, const SummedArea& light) {
  dvec3 sum(0.0);
  for (const Box& box : boxes) sum += dvec3(box.energy) / box.solidAngle() * light.integrate(box, 0.0);
  return sum;
}

dvec3 relight(const std::vector<Deposit>& deposits, size_t pathCount, const Light& light) {
  dvec3 sum(0.0);
  for (const Deposit& deposit : deposits) sum += dvec3(deposit.throughput * light(uvToDirection(deposit.uv)));
  return sum / double(pathCount);
}

Rgb totalEnergy(const std::vector<Box>& boxes) {
  dvec3 sum(0.0);
  for (const Box& box : boxes) sum += dvec3(box.energy);
  return Rgb(sum);
}

std::vector<Deposit> rectangleDeposits(const Rectangle& r, int count, Rgb throughput, Random& random) {
  const double top = std::cos(kPiDouble * r.v0), bottom = std::cos(kPiDouble * (r.v0 + r.dv));
  const int side = int(std::sqrt(double(count)));
  std::vector<Deposit> deposits;
  for (int i = 0; i < side * side; ++i) {
    const double s = (i % side + random.uniform()) / side, t = (i / side + random.uniform()) / side;
    const double u = r.u0 + s * r.du, v = std::acos(top + t * (bottom - top)) / kPiDouble;
    deposits.push_back({vec2(u - std::floor(u), v), throughput});
  }
  return deposits;
}

std::vector<Deposit> cosineDeposits(vec3 normal, int count, Random& random) {
  std::vector<Deposit> deposits;
  for (int i = 0; i < count; ++i)
    deposits.push_back({directionToUv(cosineDirection(normal, random)), Rgb(1.0f)});
  return deposits;
}

GlossyTexel::GlossyTexel(uint64_t seed, float alpha) : alpha_(alpha) {
  Random random(seed);
  normal_ = random.direction();
  const int count = 1 + int(3.0f * random.uniform());
  while (int(occluders_.size()) < count) {
    Occluder occluder;
    occluder.direction = random.direction();
    occluder.normal = glm::normalize(-occluder.direction + 0.8f * random.direction());
    occluder.cosine = std::cos(0.2f + 0.6f * random.uniform());
    occluder.albedo = Rgb(0.3f) + 0.6f * Rgb(random.uniform(), random.uniform(), random.uniform());
    if (glm::dot(occluder.direction, normal_) > -0.2f) occluders_.push_back(occluder);
  }
}

std::vector<Deposit> GlossyTexel::trace(vec3 view, int pathCount, Random& random) const {
  vec3 tangent, bitangent;
  orthonormalBasis(normal_, tangent, bitangent);
  const glm::mat3 frame(tangent, bitangent, normal_);
  const vec3 wo = view * frame;
  std::vector<Deposit> deposits;
  for (int i = 0; i < pathCount; ++i) {
    const vec2 sample(random.uniform(), random.uniform());
    const vec3 half = ggx::sampleVisibleNormal(wo, alpha_, sample);
    const vec3 wi = 2.0f * glm::dot(wo, half) * half - wo;
    if (wi.z <= 0.0f) continue;
    Rgb throughput(ggx::masking(wi.z, alpha_));
    vec3 direction = frame * wi;
    for (const Occluder& occluder : occluders_) {
      if (glm::dot(direction, occluder.direction) < occluder.cosine) continue;
      direction = cosineDirection(occluder.normal, random);
      throughput *= occluder.albedo;
      break;
    }
    deposits.push_back({directionToUv(glm::normalize(direction)), throughput});
  }
  return deposits;
}

vec3 GlossyTexel::anyView(float cosine, Random& random) const {
  while (true)
    if (const vec3 view = random.direction(); glm::dot(view, normal_) >= cosine) return view;
}

void RelativeError::add(size_t light, dvec3 value, dvec3 truth) {
  error_.resize(std::max(error_.size(), light + 1));
  energy_.resize(error_.size());
  error_[light] += glm::dot(value - truth, value - truth);
  energy_[light] += glm::dot(truth, truth);
}

double RelativeError::mean() const {
  double sum = 0.0;
  for (size_t i = 0; i < error_.size(); ++i) sum += std::sqrt(error_[i] / energy_[i]);
  return sum / double(error_.size());
}

}  // namespace boxlight::lab
