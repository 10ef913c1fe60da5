// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/medium.h"

#include <cmath>

namespace boxlight {
namespace {

/// A long walk ends by Russian roulette against the throughput it came in with, so that thick white media,
/// whose light scatters hundreds of times, stay nearly without roulette noise.
constexpr float kMaximumSurvival = 0.999f;
constexpr int kMaximumBoundaries = 256;  ///< along the ray that looks for enclosing volumes

Rgb toRgb(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

struct Medium {
  Rgb absorption, scattering;
  float g;
  Rgb extinction() const { return absorption + scattering; }
};

Medium mediumOf(const Scene& scene, uint32_t material) {
  const asset::MaterialExtension& x = scene.materialExtensions[material];
  return {toRgb(x.absorption), toRgb(x.scattering), x.scatterAnisotropy};
}

float iorOf(const Scene& scene, uint32_t material) {
  const float ior = scene.materialExtensions[material].ior;
  return ior > 0.0f ? ior : 1.0f;  // 0 stands for complete reflection: nothing enters
}

/// exp(-sigma distance); a channel without extinction passes any distance, infinity included.
Rgb transmittance(Rgb extinction, float distance) {
  Rgb result(1.0f);
  for (int c = 0; c < 3; ++c)
    if (extinction[c] > 0.0f) result[c] = std::exp(-extinction[c] * distance);
  return result;
}

int chooseChannel(Rgb weight, float random) {
  random *= weight.x + weight.y + weight.z;
  if (random < weight.x) return 0;
  return random < weight.x + weight.y ? 1 : 2;
}

/// Henyey and Greenstein, "Diffuse radiation in the galaxy", ApJ 93, 1941; inverted by the cosine.
vec3 scatterDirection(vec3 forward, float g, vec2 random) {
  float cosine = 1.0f - 2.0f * random.x;
  if (std::abs(g) > 1e-3f) {
    const float ratio = (1.0f - g * g) / (1.0f + g - 2.0f * g * random.x);
    cosine = std::clamp((1.0f + g * g - ratio * ratio) / (2.0f * g), -1.0f, 1.0f);
  }
  const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)), phi = 2.0f * kPi * random.y;
  vec3 tangent, bitangent;
  orthonormalBasis(forward, tangent, bitangent);
  return sine * (std::cos(phi) * tangent + std::sin(phi) * bitangent) + cosine * forward;
}

/// A free flight of random length, cut short by the next surface.
struct Flight {
  std::optional<SurfacePoint> point;
  bool escaped = false;
};

Flight fly(const Intersector& world, const Medium& medium, Ray& ray, Rgb& throughput, Sampler& sampler) {
  const Rgb extinction = medium.extinction(),
            share = throughput / (throughput.x + throughput.y + throughput.z);
  const float sigma = extinction[chooseChannel(throughput, sampler.next())];
  const float random = sampler.next();
  ray.limit = sigma > 0.0f ? -std::log(1.0f - random) / sigma : std::numeric_limits<float>::infinity();
  float distance;
  const auto point = world.intersect(ray, distance);
  const Rgb passed = transmittance(extinction, distance);
  if (point || std::isinf(distance)) {  // the chance to come this far
    throughput *= passed / glm::dot(share, passed);
    return {point, !point};
  }
  throughput *= medium.scattering * passed / glm::dot(share, extinction * passed);
  ray.origin += distance * ray.direction;
  ray.direction = scatterDirection(ray.direction, medium.g, sampler.next2());
  return {};
}

/// Russian roulette of the walk; false ends it.
bool survives(Rgb& throughput, float entered, Sampler& sampler) {
  const float survival = std::min(maxComponent(throughput) / entered, kMaximumSurvival);
  if (sampler.next() >= survival) return false;
  throughput /= survival;
  return true;
}

}  // namespace

void MediumStack::enter(uint32_t material) {
  if (count_ < kDepth) materials_[count_++] = material;
}

void MediumStack::leave(uint32_t material) {
  for (size_t i = count_; i-- > 0;)
    if (materials_[i] == material) {
      std::copy(materials_.begin() + i + 1, materials_.begin() + count_, materials_.begin() + i);
      --count_;
      return;
    }
}

std::optional<uint32_t> MediumStack::innermost() const {
  return count_ ? std::optional(materials_[count_ - 1]) : std::nullopt;
}

float MediumStack::ior(const Scene& scene) const {
  return count_ ? iorOf(scene, materials_[count_ - 1]) : 1.0f;
}

float MediumStack::iorWithout(const Scene& scene, uint32_t material) const {
  MediumStack rest = *this;
  rest.leave(material);
  return rest.ior(scene);
}

MediumStack enclosingMedia(const Intersector& world, Ray ray) {
  const Scene& scene = world.scene();
  MediumStack crossed;  // entered along the ray, not around its origin
  std::array<uint32_t, kMaximumBoundaries> around{};
  size_t count = 0;
  for (int boundary = 0; boundary < kMaximumBoundaries; ++boundary) {
    const auto point = world.intersect(ray);
    if (!point) break;
    const uint32_t material = scene.triangles[point->triangle].material;
    const SurfaceFrame frame = surfaceFrame(scene, *point);
    const bool leaving = glm::dot(frame.geometricNormal, ray.direction) > 0.0f;
    if (scene.materials[material].flags & asset::kVolume) {
      if (!leaving)
        crossed.enter(material);
      else if (crossed.innermost() == material)
        crossed.leave(material);
      else
        around[count++] = material;
    }
    ray.origin =
        offsetOrigin(scene, *point, frame.position, (leaving ? 1.0f : -1.0f) * frame.geometricNormal);
  }
  MediumStack media;
  while (count > 0) media.enter(around[--count]);
  return media;
}

Travel travel(const Intersector& world, const MediumStack& media, Ray& ray, Rgb& throughput,
              Sampler& sampler) {
  const auto inside = media.innermost();
  if (!inside) return {world.intersect(ray)};
  const Medium medium = mediumOf(world.scene(), *inside);
  if (maxComponent(medium.scattering) == 0.0f) {
    float distance;
    const auto point = world.intersect(ray, distance);
    throughput *= transmittance(medium.absorption, distance);
    return {point};
  }
  const float entered = maxComponent(throughput);
  for (bool scattered = false;; scattered = true) {
    const Flight flight = fly(world, medium, ray, throughput, sampler);
    if (flight.point || flight.escaped) return {flight.point, scattered};
    if (!(maxComponent(throughput) > 0.0f) || !survives(throughput, entered, sampler)) {
      throughput = Rgb(0.0f);
      return {std::nullopt, true};
    }
  }
}

}  // namespace boxlight
