// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "bake/scene/texels.h"
#include "bake/transport/deposits.h"
#include "bake/transport/intersect.h"
#include "bake/transport/scatter.h"

namespace boxlight {

/// The surface that the paths of a kernel start from: one side of one texel.
struct PathOrigin {
  std::span<const FootprintPiece> footprint;
  bool back = false;
  vec3 normal{0, 1, 0};  ///< the texel's mean shading normal on that side
};

/// Backward photon tracing, docs/theory.md section 2: paths start on a texel, stratified over its surface and
/// the first lobe, and scatter until they escape. First hits are demodulated: the pixel multiplies their
/// albedo back.
class PathTracer {
 public:
  PathTracer(const Intersector& world, uint32_t maximumBounces)
      : world_(world), maximumBounces_(maximumBounces) {}

  /// Lambert kernel: cosine-distributed first directions of throughput 1, without albedo and Fresnel factor.
  /// Appends the deposits and returns the number of paths, `pathCount` less those that found no surface
  /// (MASK, or no gloss).
  uint32_t traceLambert(const PathOrigin& origin, const StreamKey& key, uint32_t pathCount,
                        std::vector<Deposit>& deposits) const;

  /// Glossy kernel towards the unit vector wo, above the horizon of origin.normal: the GGX part divided by
  /// its directional albedo.
  uint32_t traceGlossy(const PathOrigin& origin, vec3 wo, const StreamKey& key, uint32_t pathCount,
                       std::vector<Deposit>& deposits) const;

 private:
  bool startPoint(const PathOrigin& origin, Sampler& sampler, SurfacePoint& point) const;
  void leave(const SurfaceView& surface, vec3 direction, Rgb throughput, Sampler& sampler,
             std::vector<Deposit>& deposits) const;

  const Intersector& world_;
  uint32_t maximumBounces_;
};

}  // namespace boxlight
