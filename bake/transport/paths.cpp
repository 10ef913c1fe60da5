// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/paths.h"

#include "bake/transport/bsdf.h"
#include "bake/transport/warp.h"
#include "common/light/ggx.h"
#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr int kMaskTries = 16;        ///< points drawn on a texel before it counts as cut away by its mask
constexpr uint32_t kReachPaths = 64;  ///< of isReached
constexpr int kReachBounces = 8;
/// That throughputs are divided by. Under a film, which may reflect a channel that its albedo has next to
/// none of, kernels must stay half floats.
float leastAlbedo(const Bsdf& bsdf) { return bsdf.isFilmed() ? 1e-4f : 1e-6f; }

/// `local` as seen in some frame whose z is the unit vector `axis`.
vec3 alignTo(vec3 axis, vec3 local) {
  vec3 tangent, bitangent;
  orthonormalBasis(axis, tangent, bitangent);
  return glm::normalize(local.x * tangent + local.y * bitangent + local.z * axis);
}

bool hasVolumes(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const asset::Material& m) { return m.flags & asset::kVolume; });
}

/// Of a path that leaves by view-dependent lobes, divided by their albedo.
struct FirstThroughput {
  Rgb all{0.0f};       ///< 0 if it leaves by none
  Rgb mirrored{0.0f};  ///< what of it was reflected by microfacets
};

FirstThroughput firstThroughput(const Bsdf& bsdf, const LobeSample& drawn) {
  const Rgb albedo = glm::max(bsdf.viewDependentAlbedo(), Rgb(leastAlbedo(bsdf)));
  if (drawn.delta) return {drawn.weight / albedo};
  if (drawn.wi == vec3(0.0f)) return {};
  const LobeValue lobes = bsdf.evaluate(drawn.wi, kViewDependent);
  if (!(lobes.density > 0.0f)) return {};
  const Rgb all = lobes.value / lobes.density / albedo;
  if (!bsdf.has(kSheen)) return {all, drawn.wi.z > 0.0f ? all : Rgb(0.0f)};
  const Rgb reflected = bsdf.evaluate(drawn.wi, kMirrored).value;
  return {all, drawn.wi.z > 0.0f ? reflected / lobes.density / albedo : Rgb(0.0f)};
}

vec3 directionOf(const DirectionCell& cell, vec2 inCap, vec2 spread) {
  const vec3 centre = alignTo(cell.towards, capDirection(inCap, cell.capCosine));
  const vec3 half = ggx::sampleVisibleNormal({0, 0, 1}, std::max(cell.alpha, ggx::kMinAlpha), spread);
  return alignTo(centre, 2.0f * half.z * half - vec3(0, 0, 1));
}

}  // namespace

void KernelPaths::clear() {
  deposits.clear();
  first.clear();
  emitted = dvec3(0.0);
  traced = 0;
  removed = 0;
  hidden = 0;
}

void KernelPaths::removeMirrored() {
  constexpr float kRounding = 1e-6f;  // what is left of a difference of equal sums
  std::erase_if(deposits, [](Deposit& deposit) {
    deposit.throughput = glm::max(deposit.throughput - deposit.mirrored, Rgb(0.0f));
    return maxComponent(deposit.throughput) <= kRounding * maxComponent(deposit.mirrored);
  });
}

void KernelPaths::removeStraight() {
  std::erase_if(deposits, [](const Deposit& deposit) { return deposit.straight; });
}

bool PathTracer::startPoint(const PathOrigin& origin, Sampler& sampler, SurfacePoint& point) const {
  const Scene& scene = world_.scene();
  point = sampleFootprint(origin.footprint, sampler.next2());
  const asset::Material& material = scene.materials[scene.triangles[point.triangle].material];
  if (!(material.flags & asset::kAlphaMask)) return true;
  for (int tries = 0; tries < kMaskTries; ++tries) {
    if (sampleAlpha(scene, point) >= material.alphaCutoff) return true;
    const float u = sampler.next();
    point = sampleFootprint(origin.footprint, {u, sampler.next()});
  }
  return false;
}

void PathTracer::deposit(const PathState& path, Rgb mirrored, bool straight, KernelPaths& paths) const {
  Rgb throughput = path.throughput;
  const float largest = maxComponent(throughput);
  if (largest > limits_.throughput) {
    const Rgb kept = throughput * (limits_.throughput / largest);
    paths.removed += double(luminance(throughput - kept));
    throughput = kept;
    mirrored *= limits_.throughput / largest;
  }
  paths.deposits.push_back({directionToUv(path.direction), throughput, mirrored, straight});
}

bool PathTracer::leave(const SurfaceView& first, PathState path, Rgb mirrored, Sampler& sampler,
                       KernelPaths& paths) const {
  const Scene& scene = world_.scene();
  SurfaceView surface = first;
  const vec3 start = path.direction;
  const double lobe = double(luminance(path.throughput)), own = double(luminance(mirrored));
  for (uint32_t bounce = 0;; ++bounce) {
    Ray ray = leaveSurface(scene, surface, path.direction);
    const Rgb sent = path.throughput;
    const Travel next = travel(world_, path.media, ray, path.throughput, sampler);
    path.direction = ray.direction;
    const bool direct = bounce == 0 && !next.point && path.direction == start && path.throughput == sent;
    if (bounce == 0) paths.hidden += direct ? lobe - own : lobe;
    if (!(maxComponent(path.throughput) > 0.0f)) return false;
    if (!next.point) {
      deposit(path, direct ? mirrored : Rgb(0.0f), direct, paths);
      return direct;
    }
    surface = viewSurface(scene, *next.point, -path.direction, path.media);
    const Bsdf bsdf(surface.material, surface.toLocal(-path.direction), surface.interface,
                    surface.coatNormal);
    paths.emitted += dvec3(path.throughput) * dvec3(bsdf.emission());
    if (!continuePath(bounce, limits_.bounces, path.throughput, sampler)) return false;
    if (scatter(surface, bsdf, path, sampler) == 0.0f) return false;
  }
}

void PathTracer::traceLambert(const PathOrigin& origin, const StreamKey& key, uint32_t pathCount,
                              KernelPaths& paths) const {
  for (uint32_t path = 0; path < pathCount; ++path) {
    Sampler sampler(key, path);
    SurfacePoint point;
    if (!startPoint(origin, sampler, point)) continue;
    ++paths.traced;
    const SurfaceView surface =
        viewSurfaceSide(world_.scene(), point, origin.normal, origin.back, origin.media);
    const vec3 direction = surface.toWorld(cosineDirection(sampler.next2()));
    const bool straight = glm::dot(direction, surface.geometricNormal) > 0.0f &&
                          leave(surface, {direction, Rgb(1.0f), origin.media}, Rgb(0.0f), sampler, paths);
    paths.first.push_back({direction, straight});
  }
}

void PathTracer::traceGlossy(const PathOrigin& origin, vec3 wo, const StreamKey& key, uint32_t pathCount,
                             KernelPaths& paths) const {
  for (uint32_t path = 0; path < pathCount; ++path) {
    Sampler sampler(key, path);
    SurfacePoint point;
    if (!startPoint(origin, sampler, point)) continue;
    const SurfaceView surface = viewSurfaceSide(world_.scene(), point, wo, origin.back, origin.media);
    const Bsdf bsdf(surface.material, surface.toLocal(wo), surface.interface, surface.coatNormal);
    if (!bsdf.has(kViewDependent))
      continue;  // another material's part of the texel: its pixels do not ask for this kernel
    ++paths.traced;
    const vec2 random = sampler.next2();
    const float choice = bsdf.viewDependentCount() > 1 ? sampler.next() : 0.0f;
    const LobeSample drawn = bsdf.sample(choice, random, kViewDependent);
    paths.hidden +=
        double(luminance(drawn.lost / glm::max(bsdf.viewDependentAlbedo(), Rgb(leastAlbedo(bsdf)))));
    const FirstThroughput throughput = firstThroughput(bsdf, drawn);
    PathState state{-wo, throughput.all, origin.media};
    if (!(maxComponent(state.throughput) > 0.0f)) continue;
    if (turnPath(surface, drawn, state))
      leave(surface, state, throughput.mirrored, sampler, paths);
    else
      paths.hidden += double(luminance(state.throughput));
  }
}

void PathTracer::traceIncident(const PathOrigin& origin, const DirectionCell& cell, const StreamKey& key,
                               uint32_t pathCount, KernelPaths& paths) const {
  for (uint32_t path = 0; path < pathCount; ++path) {
    Sampler sampler(key, path);
    SurfacePoint point;
    if (!startPoint(origin, sampler, point)) continue;
    const SurfaceView surface =
        viewSurfaceSide(world_.scene(), point, origin.normal, origin.back, origin.media);
    const vec2 inCap = sampler.next2();
    const vec3 direction = directionOf(cell, inCap, sampler.next2());
    if (!(glm::dot(direction, surface.geometricNormal) > 0.0f)) continue;
    ++paths.traced;
    leave(surface, {direction, Rgb(1.0f), origin.media}, Rgb(1.0f), sampler, paths);
  }
  paths.removeMirrored();
}

bool PathTracer::escapes(Ray ray, Sampler& sampler) const {
  const Scene& scene = world_.scene();
  for (int bounce = 0; bounce < kReachBounces; ++bounce) {
    const auto point = world_.intersect(ray);
    if (!point) return true;
    SurfaceView surface;
    const SurfaceFrame frame = surfaceFrame(scene, *point);
    const float side = glm::dot(frame.geometricNormal, ray.direction) > 0.0f ? -1.0f : 1.0f;
    surface.normal = side * frame.geometricNormal;
    orthonormalBasis(surface.normal, surface.tangent, surface.bitangent);
    ray = {offsetOrigin(scene, *point, surface.normal), surface.toWorld(cosineDirection(sampler.next2()))};
  }
  return false;
}

bool PathTracer::isReached(const PathOrigin& origin, const StreamKey& key) const {
  for (uint32_t path = 0; path < kReachPaths; ++path) {
    Sampler sampler(key, path);
    SurfacePoint point;
    if (!startPoint(origin, sampler, point)) continue;
    const SurfaceView surface = viewSurfaceSide(world_.scene(), point, origin.normal, origin.back);
    const vec3 direction = surface.toWorld(cosineDirection(sampler.next2()));
    if (glm::dot(direction, surface.geometricNormal) > 0.0f &&
        escapes(leaveSurface(world_.scene(), surface, direction), sampler))
      return true;
  }
  return false;
}

MediumStack mediaAround(const Intersector& world, std::span<const FootprintPiece> footprint, bool back) {
  const Scene& scene = world.scene();
  if (!hasVolumes(scene)) return {};
  const SurfacePoint point = sampleFootprint(footprint, vec2(0.5f));
  const SurfaceFrame frame = surfaceFrame(scene, point);
  const vec3 outward = (back ? -1.0f : 1.0f) * frame.geometricNormal;
  MediumStack media = enclosingMedia(world, {offsetOrigin(scene, point, outward), outward});
  // The back of an open mesh that claims to be a volume: its medium is there, if only on this side.
  const uint32_t material = scene.triangles[point.triangle].material;
  if (back && (scene.materials[material].flags & asset::kVolume) && media.innermost() != material)
    media.enter(material);
  return media;
}

}  // namespace boxlight
