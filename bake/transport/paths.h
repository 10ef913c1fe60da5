// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
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
  MediumStack media;     ///< around the surface on that side
};

struct PathLimits {
  uint32_t bounces = kUnlimitedBounces;  ///< surface interactions at most
  /// Deposits are scaled down to this throughput (largest channel): a policy against fireflies that costs
  /// energy.
  float throughput = std::numeric_limits<float>::infinity();
};

/// What the paths of one kernel brought home.
struct KernelPaths {
  std::vector<Deposit> deposits;
  dvec3 emitted{0.0};   ///< sum of throughput times the radiance of emitters met
  uint32_t traced = 0;  ///< paths, those that escaped nowhere included
  double removed = 0;   ///< luminance that PathLimits::throughput took, summed like the deposits
  /// Sum of the luminances of first throughputs that are not reflected by microfacets and leave the scene
  /// straight away: of rays that meet a surface or scatter in a medium, those below the geometric horizon,
  /// and all of other lobes.
  double hidden = 0;
  std::vector<FirstDirection> first;  ///< of traceLambert: of every path

  void clear();
  /// Leaves of the deposits what pixels cannot make themselves; drops those of which nothing is left.
  void removeMirrored();
  /// Drops what went straight to the light.
  void removeStraight();
  /// Mean radiance by way of the scene's emitters.
  Rgb emission() const { return traced ? Rgb(emitted / double(traced)) : Rgb(0.0f); }
  /// Which part of the lobes a pixel cannot make itself.
  float hiddenPart() const { return traced ? float(hidden / double(traced)) : 0.0f; }
};

/// The directions that one kernel of arriving light stands for.
struct DirectionCell {
  vec3 towards{0, 1, 0};  ///< unit, away from the surface
  float capCosine = 1;    ///< of the cap around it that they are uniform over
  float alpha = 0;        ///< of the GGX mirror, seen head-on, that spreads them further
};

/// Backward photon tracing, docs/theory.md section 2: paths start on a texel, stratified over its surface and
/// the first lobe, and scatter until they escape. First hits are demodulated: the pixel multiplies their
/// albedo back.
class PathTracer {
 public:
  PathTracer(const Intersector& world, const PathLimits& limits) : world_(world), limits_(limits) {}

  /// Lambert kernel: cosine-distributed first directions of throughput 1, without albedo and Fresnel factor.
  /// On the back of a volume's boundary they lead into the medium: subsurface scattering as the front's
  /// pixels need it. Adds up to `pathCount` paths, less those that found no surface (MASK).
  void traceLambert(const PathOrigin& origin, const StreamKey& key, uint32_t pathCount,
                    KernelPaths& paths) const;

  /// Kernel of the view-dependent lobes towards the unit vector wo, above the horizon of origin.normal,
  /// divided by their directional albedo. Paths that find no such lobe are left out too.
  void traceGlossy(const PathOrigin& origin, vec3 wo, const StreamKey& key, uint32_t pathCount,
                   KernelPaths& paths) const;

  /// Kernel of what arrives by way of other surfaces from the directions of a cell, whatever the texel makes
  /// of it: first directions of throughput 1, of which those that leave the scene straight away deposit
  /// nothing. Directions below the surface's own horizon are not among them: there is nothing that the texel
  /// sees there.
  void traceIncident(const PathOrigin& origin, const DirectionCell& cell, const StreamKey& key,
                     uint32_t pathCount, KernelPaths& paths) const;

  /// Does light from outside reach this side of a texel at all, by any path that passes no volume's boundary?
  /// Tried with a fixed number of diffuse paths: an opening that fewer than 1 path in 30 finds may be missed.
  bool isReached(const PathOrigin& origin, const StreamKey& key) const;

 private:
  bool startPoint(const PathOrigin& origin, Sampler& sampler, SurfacePoint& point) const;
  /// Did the path meet nothing?
  bool leave(const SurfaceView& surface, PathState path, Rgb mirrored, Sampler& sampler,
             KernelPaths& paths) const;
  void deposit(const PathState& path, Rgb mirrored, bool straight, KernelPaths& paths) const;
  bool escapes(Ray ray, Sampler& sampler) const;

  const Intersector& world_;
  PathLimits limits_;
};

/// The media around one side of a texel; empty where the scene has no volumes.
MediumStack mediaAround(const Intersector& world, std::span<const FootprintPiece> footprint, bool back);

}  // namespace boxlight
