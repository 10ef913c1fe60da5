// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/intersect.h"

#include <embree3/rtcore.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <span>

#include "common/base/error.h"
#include "common/base/file.h"

namespace boxlight {

struct Intersector::Impl {
  explicit Impl(const Scene& s) : scene(s), origin(hitOrigin(s)) {}
  ~Impl() {
    if (world) rtcReleaseScene(world);
    if (device) rtcReleaseDevice(device);
  }
  const Scene& scene;
  const vec3 origin;
  RTCDevice device = nullptr;
  RTCScene world = nullptr;
};

namespace {

constexpr uint32_t kCutOut = asset::kAlphaMask | asset::kAlphaBlend;

bool hasCutOuts(const Scene& scene) {
  for (const asset::Material& material : scene.materials)
    if (material.flags & kCutOut) return true;
  return false;
}

/// A number of [0,1) from a ray and a triangle.
float hashOf(const RTCFilterFunctionNArguments* arguments, uint32_t triangle) {
  const float words[6] = {RTCRayN_org_x(arguments->ray, 1, 0), RTCRayN_org_y(arguments->ray, 1, 0),
                          RTCRayN_org_z(arguments->ray, 1, 0), RTCRayN_dir_x(arguments->ray, 1, 0),
                          RTCRayN_dir_y(arguments->ray, 1, 0), RTCRayN_dir_z(arguments->ray, 1, 0)};
  return float(xxh64(std::as_bytes(std::span(words)), triangle) >> 40) * 0x1p-24f;
}

/// Embree calls it for one ray at a time, since only rtcIntersect1 and rtcOccluded1 are used.
void dropCutOuts(const RTCFilterFunctionNArguments* arguments) {
  const Scene& scene = *static_cast<const Scene*>(arguments->geometryUserPtr);
  const uint32_t triangle = RTCHitN_primID(arguments->hit, arguments->N, 0);
  const asset::Material& material = scene.materials[scene.triangles[triangle].material];
  if (!(material.flags & kCutOut)) return;
  const SurfacePoint point{
      triangle, {RTCHitN_u(arguments->hit, arguments->N, 0), RTCHitN_v(arguments->hit, arguments->N, 0)}};
  const float alpha = sampleAlpha(scene, point);
  const bool there = material.flags & asset::kAlphaMask ? alpha >= material.alphaCutoff
                                                        : hashOf(arguments, triangle) < alpha;
  if (!there) arguments->valid[0] = 0;
}

RTCGeometry makeGeometry(RTCDevice device, const Scene& scene) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), scene.vertices.size()));
  auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), scene.triangles.size()));
  if (!positions || !indices)
    fail(ExitCode::runtime, "{}: Embree has no memory for the scene", scene.path.string());
  const vec3 origin = hitOrigin(scene);
  for (size_t i = 0; i < scene.vertices.size(); ++i)
    for (int c = 0; c < 3; ++c) positions[3 * i + size_t(c)] = scene.vertices[i].position[c] - origin[c];
  for (size_t i = 0; i < scene.triangles.size(); ++i)
    std::memcpy(indices + 3 * i, scene.triangles[i].vertex, 12);
  rtcSetGeometryUserData(geometry, const_cast<Scene*>(&scene));
  if (hasCutOuts(scene)) {
    rtcSetGeometryIntersectFilterFunction(geometry, dropCutOuts);
    rtcSetGeometryOccludedFilterFunction(geometry, dropCutOuts);
  }
  rtcCommitGeometry(geometry);
  return geometry;
}

RTCRay makeRay(const Ray& ray, vec3 origin) {
  RTCRay r{};
  const vec3 start(ray.origin - dvec3(origin));
  r.org_x = start.x, r.org_y = start.y, r.org_z = start.z;
  r.dir_x = ray.direction.x, r.dir_y = ray.direction.y, r.dir_z = ray.direction.z;
  r.tnear = 0.0f;
  r.tfar = ray.limit;
  r.mask = ~0u;
  return r;
}

}  // namespace

Intersector::Intersector(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {
  // One instruction set: hits do not depend on the processor's newest extension.
  impl_->device = rtcNewDevice("max_isa=avx2");
  if (!impl_->device)
    fail(ExitCode::runtime, "Embree cannot start (error {})", int(rtcGetDeviceError(nullptr)));
  impl_->world = rtcNewScene(impl_->device);
  rtcSetSceneFlags(impl_->world, RTC_SCENE_FLAG_ROBUST);  // no rays through shared edges
  rtcSetSceneBuildQuality(impl_->world, RTC_BUILD_QUALITY_HIGH);
  RTCGeometry geometry = makeGeometry(impl_->device, scene);
  rtcAttachGeometry(impl_->world, geometry);
  rtcReleaseGeometry(geometry);
  {
    // A serial build gives the same hierarchy, and so the same hit where two triangles tie, whatever
    // --threads says. (Embree's own option threads=1 would limit every later loop of the program to one
    // thread.)
    const tbb::global_control serial(tbb::global_control::max_allowed_parallelism, 1);
    rtcCommitScene(impl_->world);
  }
  if (rtcGetDeviceError(impl_->device) != RTC_ERROR_NONE)
    fail(ExitCode::runtime, "{}: Embree cannot build its hierarchy", scene.path.string());
}

Intersector::~Intersector() = default;

const Scene& Intersector::scene() const { return impl_->scene; }

std::optional<SurfacePoint> Intersector::intersect(const Ray& ray) const {
  float distance;
  return intersect(ray, distance);
}

std::optional<SurfacePoint> Intersector::intersect(const Ray& ray, float& distance) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = makeRay(ray, impl_->origin);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->world, &context, &query);
  distance = query.ray.tfar;
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return SurfacePoint{query.hit.primID, {query.hit.u, query.hit.v}};
}

bool Intersector::occluded(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query = makeRay(ray, impl_->origin);
  rtcOccluded1(impl_->world, &context, &query);
  return query.tfar < 0.0f;
}

vec3 hitOrigin(const Scene& scene) {
  vec3 origin(0.0f);
  for (int c = 0; c < 3; ++c) {
    const float low = scene.boundsMin[c], high = scene.boundsMax[c], centre = 0.5f * low + 0.5f * high;
    if (high >= low && std::abs(centre) > high - low) origin[c] = centre;
  }
  return origin;
}

dvec3 offsetOrigin(const Scene& scene, const SurfacePoint& point, vec3 normal) {
  const vec3 origin = hitOrigin(scene);
  float magnitude = 0.0f;
  for (uint32_t vertex : scene.triangles[point.triangle].vertex)
    for (int c = 0; c < 3; ++c)
      magnitude = std::max(magnitude, std::abs(scene.vertices[vertex].position[c] - origin[c]));
  constexpr float kUnitsInLastPlace = 8.0f * 0x1p-23f;  // 2 suffice wherever it was measured
  return surfacePosition(scene, point) + dvec3((kUnitsInLastPlace * magnitude) * normal);
}

}  // namespace boxlight
