// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "bake/transport/paths.h"
#include "bake/transport/reference.h"
#include "common/light/light_domain.h"
#include "tests/support/scenes.h"

// Beams and kernels through scenes with known answers.

namespace boxlight::test {

/// A closed axis-aligned box whose faces look outwards.
void addBox(Scene& scene, vec3 low, vec3 high, uint32_t material = 0);

/// Fills scene.materialExtensions with the default.
void makeExtensions(Scene& scene);

/// The boundary of a medium that passes everything diffusely and reflects nothing, inside or outside.
Scene diffuseMedium(Rgb absorption, Rgb scattering, float g = 0);
/// Clear glass with a smooth surface. Index 1 with `specular` 0 bounds without reflecting.
Scene glass(float ior, Rgb absorption = Rgb(0.0f), float specular = 1);

/// Where a path went that started as a ray in free space.
struct BeamExit {
  bool escaped = false;
  vec3 direction{0.0f};
  dvec3 origin{0.0};  ///< of the last ray: a point of the line on which the path escapes
  Rgb throughput{0.0f};
  uint32_t bounces = 0;
};
BeamExit followBeam(const Intersector& world, Ray ray, const MediumStack& media, Sampler sampler);

/// Mean and the standard error of the mean.
struct Estimate {
  void add(double x) {
    ++count;
    const double delta = x - mean;
    mean += delta / double(count);
    squares += delta * (x - mean);
  }
  double error() const { return std::sqrt(squares / double(count) / double(count - 1)); }
  /// The deviation from `truth` in standard errors.
  double z(double truth) const { return (mean - truth) / error(); }

  uint64_t count = 0;
  double mean = 0, squares = 0;
};

/// Paths of the Lambert kernel around the middle of the longest edge of `triangle`, half of a quad: from its
/// back if `back`.
KernelPaths lambertPaths(const Intersector& world, uint32_t triangle, bool back, uint32_t count,
                         uint64_t seed = 1);

/// What of a slab's diffuse light comes back and what passes: per path, by the channel's throughput.
struct SlabAnswer {
  Estimate reflected, transmitted;
};
/// A slab of unit density 1/m and thickness `depth` whose first two triangles are its upper face.
Scene slab(Scene scene, float depth);
SlabAnswer slabAnswer(const KernelPaths& paths, int channel);

/// An environment of 128 x 64 texels by a function of the direction.
template <class Radiance>
Image environmentOf(const Radiance& radiance) {
  Image image = makeImage(128, 64, 3);
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x) {
      const vec2 uv((float(x) + 0.5f) / float(image.width), (float(y) + 0.5f) / float(image.height));
      const Rgb value = radiance(uvToDirection(uv));
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = value[c];
    }
  return image;
}

}  // namespace boxlight::test
