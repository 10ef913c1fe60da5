// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/medium.h"

#include <cmath>

namespace boxlight {
namespace {

/// Russian roulette keeps a walk's throughput near what it came in with. From this step n on, it also ends a
/// walk that loses nothing, with probability 1/n: in a thick white medium the lengths of walks fall like
/// n^-1.5, and any fixed probability would make weights that grow exponentially and a variance without bound.
constexpr uint32_t kRouletteStep = 10000;
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

/// exp(-sigma distance); a channel without extinction passes any distance.
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

/// Media end at the scene's bounds, slightly enlarged: that of an open mesh, too.
struct Bounds {
  explicit Bounds(const Scene& scene) {
    const dvec3 low(scene.boundsMin), high(scene.boundsMax);
    const dvec3 margin(1e-3 * glm::length(high - low));
    min = low - margin, max = high + margin;
  }
  bool contain(dvec3 p) const { return glm::clamp(p, min, max) == p; }
  /// The length of the ray within the bounds, 0 where it starts outside.
  float exitDistance(const Ray& ray) const {
    double distance = std::numeric_limits<double>::infinity();
    for (int c = 0; c < 3; ++c) {
      const double direction = double(ray.direction[c]), side = direction < 0.0 ? min[c] : max[c];
      if (direction != 0.0) distance = std::min(distance, (side - ray.origin[c]) / direction);
    }
    return contain(ray.origin) ? float(std::max(distance, 0.0)) : 0.0f;
  }

  dvec3 min, max;
};

/// The places of scattering stay this far inside of a surface ahead, so that rounding does not put them
/// behind it.
float clearance(const Scene& scene, const dvec3& position) {
  const dvec3 p = glm::abs(position - dvec3(hitOrigin(scene)));
  return 8.0f * 0x1p-23f * float(std::max(p.x, std::max(p.y, p.z)));
}

/// A free flight of random length, cut short by the next surface.
struct Flight {
  std::optional<SurfacePoint> point;
  bool escaped = false;
};

Flight fly(const Intersector& world, const Bounds& bounds, const Medium& medium, Ray& ray, Rgb& throughput,
           Sampler& sampler) {
  const Rgb extinction = medium.extinction(),
            share = throughput / (throughput.x + throughput.y + throughput.z);
  const float sigma = extinction[chooseChannel(throughput, sampler.next())];
  const float random = sampler.next();
  float flight = sigma > 0.0f ? -std::log(1.0f - random) / sigma : std::numeric_limits<float>::infinity();
  const float clear = clearance(world.scene(), ray.origin);
  ray.limit = flight + clear;
  float distance;
  const auto point = world.intersect(ray, distance);
  const bool arrives = point && distance <= flight;
  const bool escapes = !point && !bounds.contain(ray.origin + double(flight) * dvec3(ray.direction));
  if (arrives || escapes) {
    if (escapes) distance = bounds.exitDistance(ray);
    const Rgb passed = transmittance(extinction, distance);
    throughput *= passed / glm::dot(share, passed);  // the chance to come this far
    return {point, escapes};
  }
  const Rgb passed = transmittance(extinction, flight);
  throughput *= medium.scattering * passed / glm::dot(share, extinction * passed);
  if (point) flight = std::max(0.0f, std::min(flight, distance - clear));
  ray.origin += double(flight) * dvec3(ray.direction);
  ray.direction = scatterDirection(ray.direction, medium.g, sampler.next2());
  return {};
}

/// Russian roulette of the walk's step number `step`; false ends it.
bool survives(Rgb& throughput, float entered, uint32_t step, Sampler& sampler) {
  const float longest = step < kRouletteStep ? 1.0f : 1.0f - 1.0f / float(step);
  const float survival = std::min(maxComponent(throughput) / entered, longest);
  if (sampler.next() >= survival) return false;
  throughput /= survival;
  return true;
}

}  // namespace

void MediumStack::enter(uint32_t material) {
  if (count_ < kDepth) materials_[count_++] = material;
}

bool MediumStack::leave(uint32_t material) {
  for (size_t i = count_; i-- > 0;)
    if (materials_[i] == material) {
      std::copy(materials_.begin() + i + 1, materials_.begin() + count_, materials_.begin() + i);
      --count_;
      return true;
    }
  return false;
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
  if (!Bounds(scene).contain(ray.origin)) return {};
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
      else if (!crossed.leave(material))
        around[count++] = material;
    }
    ray.origin = offsetOrigin(scene, *point, (leaving ? 1.0f : -1.0f) * frame.geometricNormal);
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
  const Bounds bounds(world.scene());
  if (maxComponent(medium.scattering) == 0.0f) {
    float distance;
    const auto point = world.intersect(ray, distance);
    throughput *= transmittance(medium.absorption, point ? distance : bounds.exitDistance(ray));
    return {point};
  }
  const float entered = maxComponent(throughput);
  for (uint32_t step = 0;; ++step) {
    const Flight flight = fly(world, bounds, medium, ray, throughput, sampler);
    if (flight.point || flight.escaped) return {flight.point, step > 0};
    if (!(maxComponent(throughput) > 0.0f) || !survives(throughput, entered, step, sampler)) {
      throughput = Rgb(0.0f);
      return {std::nullopt, true};
    }
  }
}

}  // namespace boxlight
