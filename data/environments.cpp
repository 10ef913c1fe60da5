// SPDX-License-Identifier: Apache-2.0
#include "data/environments.h"

#include <fmt/ranges.h>

#include <cmath>

#include "common/base/error.h"
#include "common/light/light_domain.h"

namespace boxlight::data {
namespace {

constexpr uvec2 kDetailedSize{1024, 512};

/// The mean of `radiance(direction)` over each texel, from samples x samples points.
template <class Radiance>
Image paint(uvec2 size, uint32_t samples, Radiance radiance) {
  Image image = makeImage(size.x, size.y, 3);
  for (uint32_t y = 0; y < size.y; ++y)
    for (uint32_t x = 0; x < size.x; ++x) {
      dvec3 sum(0.0);
      double weight = 0;
      for (uint32_t j = 0; j < samples; ++j)
        for (uint32_t i = 0; i < samples; ++i) {
          const double u = (x + (i + 0.5) / samples) / size.x, v = (y + (j + 0.5) / samples) / size.y;
          const double sine = std::sin(kPiDouble * v);  // solid angle of the sample
          sum += sine * dvec3(radiance(uvToDirection({float(u), float(v)})));
          weight += sine;
        }
      for (int k = 0; k < 3; ++k) image.at(x, y)[k] = float(sum[k] / weight);
    }
  return image;
}

/// Adds a disc light so that every texel gets its mean radiance: by the share of a texel's solid angle that
/// lies in the disc, then scaled to the disc's exact solid angle.
void addDisc(Image& image, const Sun& sun) {
  constexpr int kSamples = 64;
  const vec2 centre = directionToUv(sun.direction) * vec2(float(image.width), float(image.height));
  const double cosine = std::cos(double(sun.angularRadius));
  const int reach = 4 + int(sun.angularRadius / kPi * float(image.height));
  std::vector<std::pair<ivec2, double>> coverage;
  double covered = 0;
  for (int y = int(centre.y) - reach; y <= int(centre.y) + reach; ++y)
    for (int x = int(centre.x) - reach; x <= int(centre.x) + reach; ++x) {
      double inside = 0;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const dvec3 d(
            uvToDirection({(float(x) + (float(k % kSamples) + 0.5f) / kSamples) / float(image.width),
                           (float(y) + (float(k / kSamples) + 0.5f) / kSamples) / float(image.height)}));
        inside += glm::dot(d, dvec3(sun.direction)) >= cosine ? 1 : 0;
      }
      if (inside == 0) continue;
      const double omega =
          rectangleSolidAngle(1.0 / image.width, double(y) / image.height, (y + 1.0) / image.height);
      coverage.push_back({{x, y}, inside / (kSamples * kSamples)});
      covered += coverage.back().second * omega;
    }
  const double exact = 2.0 * kPiDouble * (1.0 - cosine);
  for (const auto& [texel, fraction] : coverage)
    for (int k = 0; k < 3; ++k)
      image.at(uint32_t(texel.x), uint32_t(texel.y))[k] +=
          float(fraction * exact / covered * double(sun.radiance[k]));
}

/// A clear afternoon: gradient, haze towards the horizon and around the sun, a dull ground. Not a measured
/// sky.
Rgb skyRadiance(vec3 d) {
  if (d.y < 0) return Rgb(0.17f, 0.16f, 0.13f) + 0.25f * std::exp(14.0f * d.y) * Rgb(0.8f, 0.9f, 1.0f);
  const Rgb gradient = glm::mix(Rgb(0.07f, 0.17f, 0.45f), Rgb(0.55f, 0.6f, 0.65f), std::exp(-5.0f * d.y));
  const float towardsSun = std::max(glm::dot(d, skySun().direction), 0.0f);
  const float glow = 0.2f * std::pow(towardsSun, 8.0f) + 1.5f * std::pow(towardsSun, 400.0f);
  return gradient + glow * Rgb(1.0f, 0.85f, 0.6f);
}

Image makeSky() {
  Image image = paint(kDetailedSize, 2, skyRadiance);
  addDisc(image, skySun());
  return image;
}

/// A rectangle of even radiance in the room, seen from the centre.
struct Softbox {
  vec3 centre, halfRight, halfUp;  ///< metres
  Rgb radiance;
};

bool sees(const Softbox& box, vec3 d) {
  const vec3 normal = glm::cross(box.halfRight, box.halfUp);
  const float along = glm::dot(d, normal);
  const float distance = glm::dot(box.centre, normal) / (along == 0 ? 1e-20f : along);
  if (distance <= 0) return false;
  const vec3 offset = distance * d - box.centre;
  return std::abs(glm::dot(offset, box.halfRight)) <= glm::dot(box.halfRight, box.halfRight) &&
         std::abs(glm::dot(offset, box.halfUp)) <= glm::dot(box.halfUp, box.halfUp);
}

Softbox softbox(vec3 centre, float halfWidth, float halfHeight, Rgb radiance) {
  const vec3 back = glm::normalize(centre);
  const vec3 right =
      glm::normalize(glm::cross(std::abs(back.y) < 0.95f ? vec3(0, 1, 0) : vec3(0, 0, -1), back));
  return {centre, halfWidth * right, halfHeight * glm::cross(back, right), radiance};
}

/// Key from the left front, a warm strip from the right, a blue box behind, a large weak one overhead.
Image makeStudio() {
  const Softbox boxes[] = {softbox({-2.2f, 1.8f, 2.4f}, 0.9f, 0.9f, Rgb(14.0f)),
                           softbox({3.0f, 1.0f, 1.0f}, 0.25f, 1.3f, {18.0f, 11.0f, 6.0f}),
                           softbox({0.6f, 1.2f, -3.0f}, 1.1f, 0.5f, {1.5f, 4.0f, 12.0f}),
                           softbox({0.3f, 3.0f, -0.2f}, 1.4f, 0.8f, Rgb(2.5f))};
  return paint(kDetailedSize, 4, [&](vec3 d) {
    for (const Softbox& box : boxes)
      if (sees(box, d)) return box.radiance;
    return d.y < 0 ? Rgb(0.012f) : Rgb(0.03f);
  });
}

/// Soft enough for gloss of any sharpness to show, strong enough from behind for what shines through.
Image makeGallery() {
  const Softbox boxes[] = {softbox({-2.0f, 2.2f, 1.7f}, 0.55f, 0.55f, {12.0f, 10.3f, 8.0f}),
                           softbox({2.2f, 1.9f, -2.2f}, 0.7f, 0.7f, {11.0f, 13.0f, 16.0f})};
  return paint(kDetailedSize, 4, [&](vec3 d) {
    for (const Softbox& box : boxes)
      if (sees(box, d)) return box.radiance;
    const float up = 0.5f + 0.5f * d.y;
    return glm::mix(Rgb(0.16f, 0.14f, 0.12f), Rgb(0.42f, 0.5f, 0.62f), up * up * (3 - 2 * up));
  });
}

/// By the dominant axis of the direction: red, cyan, green, magenta, blue, yellow for +X, -X, +Y, -Y, +Z, -Z.
Image makeAxes() {
  return paint({256, 128}, 1, [](vec3 d) {
    const vec3 size = glm::abs(d);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    Rgb colour(0.0f);
    colour[axis] = 1;
    return d[axis] > 0 ? colour : Rgb(1.0f) - colour;
  });
}

Image makeWhite() {
  Image image = makeImage(64, 32, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), 1.0f);
  return image;
}

/// x > 0 is a quarter turn to both sides of the centre column: the border runs between texels.
Image makeHalf() {
  Image image = makeImage(1024, 512, 3);
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = image.width / 4; x < image.width * 3 / 4; ++x)
      for (int k = 0; k < 3; ++k) image.at(x, y)[k] = 1;
  return image;
}

Image makeTexelSun() {
  Image image = makeImage(kTexelSunSize.x, kTexelSunSize.y, 3);
  for (int k = 0; k < 3; ++k) image.at(kLitTexel.x, kLitTexel.y)[k] = 1000;
  return image;
}

}  // namespace

Sun skySun() {
  // The centre of a texel, 38 degrees high, from the front right: at least that texel is all sun.
  const vec2 uv((620.5f) / float(kDetailedSize.x), (148.5f) / float(kDetailedSize.y));
  return {uvToDirection(uv), 0.27f * kPi / 180.0f, Rgb(6.2e4f, 5.5e4f, 4.4e4f)};
}

const std::vector<EnvironmentRecipe>& environmentRecipes() {
  static const std::vector<EnvironmentRecipe> recipes = {
      {"sky", "clear afternoon with a sun disc of .27 degrees radius", makeSky},
      {"studio", "dark room with four softboxes", makeStudio},
      {"gallery", "soft sky, a warm key from the left front, a cool softbox behind", makeGallery},
      {"axes", "one colour per dominant axis: +X red, -X cyan, +Y green, -Y magenta, +Z blue, -Z yellow",
       makeAxes},
      {"white", "radiance 1 everywhere", makeWhite},
      {"half", "radiance 1 where x > 0, black elsewhere", makeHalf},
      {"texel_sun", "one texel of radiance 1000, black elsewhere", makeTexelSun},
  };
  return recipes;
}

Image makeEnvironment(const std::string& name) {
  std::vector<std::string> names;
  for (const EnvironmentRecipe& recipe : environmentRecipes()) {
    if (recipe.name == name) return recipe.make();
    names.push_back(recipe.name);
  }
  fail(ExitCode::usage, "no environment is called '{}'; there are {}", name, fmt::join(names, ", "));
}

}  // namespace boxlight::data
