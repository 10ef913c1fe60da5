// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>

#include "bake/transport/environment_sampler.h"
#include "bake/transport/intersect.h"
#include "bake/transport/scatter.h"
#include "common/base/progress.h"
#include "common/image/camera.h"
#include "common/image/image.h"

namespace boxlight {

struct ReferenceOptions {
  uint32_t samplesPerPixel = 64;
  uint32_t bounces =
      kUnlimitedBounces;  ///< surface interactions of a path at most; Russian roulette ends them before
  uint64_t seed = 0;
  bool background = true;  ///< draw the environment behind the object
  /// Samples are scaled down to this radiance (largest channel): a policy against fireflies that costs
  /// energy.
  float radianceLimit = std::numeric_limits<float>::infinity();
  ProgressStyle progress = ProgressStyle::none;
};

/// A path-traced picture with its own error estimate.
struct ReferencePicture {
  Image mean;          ///< RGBA, premultiplied; A is the object's coverage, or 1 with a background
  Image variance;      ///< RGB: of each channel's mean, from the spread of its samples
  double removed = 0;  ///< by ReferenceOptions::radianceLimit, as a part of the picture's luminance
};

/// Radiance that leaves a surface point against `direction` into `media`, estimated by one path.
using RadianceEstimator =
    std::function<Rgb(const SurfacePoint& point, vec3 direction, const MediumStack& media, Sampler& sampler)>;

/// Means of `estimate` over the pixels' squares, environment behind. Deterministic for a seed, whatever the
/// threads. Back faces of single-sided materials are invisible to the camera, and to nothing else. Throws
/// Error(interrupted) after Ctrl-C.
ReferencePicture renderPicture(const Intersector& world, const EnvironmentSampler& environment,
                               const Camera& camera, const ReferenceOptions& options,
                               const RadianceEstimator& estimate);

/// The truth: renderPicture with unbiased path tracing of glTF's BSDF.
ReferencePicture renderReference(const Intersector& world, const EnvironmentSampler& environment,
                                 const Camera& camera, const ReferenceOptions& options);

}  // namespace boxlight
