// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "bake/transport/deposits.h"
#include "common/light/summed_area.h"

// Kernels with known answers, made without a scene.

namespace boxlight::lab {

class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}
  float uniform() { return float(engine_() >> 40) * 0x1p-24f; }  ///< [0,1)
  vec3 direction();                                              ///< uniform over the sphere

 private:
  std::mt19937_64 engine_;
};

/// Radiance as a function of the direction.
using Light = std::function<Rgb(vec3)>;

/// Constant plus a few wide lobes, and for a sun one of 2 degrees with two fifths of the energy.
Light makeLight(uint64_t seed, bool sun);
SummedArea tableOf(const Light& light);

/// Equation 3.
dvec3 relight(const std::vector<Box>& boxes, const SummedArea& light);
/// The same by the deposits themselves.
dvec3 relight(const std::vector<Deposit>& deposits, size_t pathCount, const Light& light);

Rgb totalEnergy(const std::vector<Box>& boxes);

/// Deposits spread uniformly (by solid angle) and evenly over a rectangle.
std::vector<Deposit> rectangleDeposits(const Rectangle& rectangle, int count, Rgb throughput, Random& random);
/// A cosine lobe: the Lambert kernel of an open surface.
std::vector<Deposit> cosineDeposits(vec3 normal, int count, Random& random);

/// A GGX lobe of an open metal surface, part of which is hidden by round occluders that scatter on.
class GlossyTexel {
 public:
  GlossyTexel(uint64_t seed, float alpha);
  std::vector<Deposit> trace(vec3 view, int pathCount, Random& random) const;
  vec3 normal() const { return normal_; }
  /// A view at least `cosine` above the horizon.
  vec3 anyView(float cosine, Random& random) const;

 private:
  struct Occluder {
    vec3 direction, normal;
    float cosine;
    Rgb albedo;
  };
  vec3 normal_;
  float alpha_;
  std::vector<Occluder> occluders_;
};

/// Accumulates section "error, defined once": per light the square root of squared error over squared truth,
/// then the mean.
class RelativeError {
 public:
  void add(size_t light, dvec3 value, dvec3 truth);
  double mean() const;

 private:
  std::vector<double> error_, energy_;
};

}  // namespace boxlight::lab
