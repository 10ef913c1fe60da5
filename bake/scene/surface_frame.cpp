// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "bake/scene/corners.h"

namespace boxlight {

dvec3 surfacePosition(const Scene& scene, SurfacePoint point) {
  const Corners corners(scene, point);
  const dvec3 a(toVec3(corners.a.position)), b(toVec3(corners.b.position)), c(toVec3(corners.c.position));
  return a + double(point.barycentric.x) * (b - a) + double(point.barycentric.y) * (c - a);
}

SurfaceFrame surfaceFrame(const Scene& scene, SurfacePoint point) {
  const Corners corners(scene, point);
  const asset::Vertex &a = corners.a, &b = corners.b, &c = corners.c;
  SurfaceFrame frame;
  frame.position = corners.mix3(a.position, b.position, c.position);
  // In double precision: the products of short edges underflow in float.
  const dvec3 origin = toVec3(a.position);
  frame.geometricNormal = vec3(
      glm::normalize(glm::cross(dvec3(toVec3(b.position)) - origin, dvec3(toVec3(c.position)) - origin)));
  frame.normal = unitOr(corners.mix3(a.normal, b.normal, c.normal), frame.geometricNormal);
  const vec3 tangent = corners.mix3(a.tangent, b.tangent, c.tangent);
  vec3 inPlane = tangent - frame.normal * glm::dot(frame.normal, tangent);
  if (glm::dot(inPlane, inPlane) > 1e-12f) {
    inPlane = glm::normalize(inPlane);
  } else {
    vec3 bitangent;
    orthonormalBasis(frame.normal, inPlane, bitangent);
  }
  frame.tangent = vec4(inPlane, corners.mix(a.tangent[3], b.tangent[3], c.tangent[3]) < 0.0f ? -1.0f : 1.0f);
  return frame;
}

vec3 fromTangentSpace(const SurfaceFrame& frame, vec3 v) {
  const vec3 tangent(frame.tangent);
  const vec3 bitangent = glm::cross(frame.normal, tangent) * frame.tangent.w;
  return unitOr(tangent * v.x + bitangent * v.y + frame.normal * v.z, frame.normal);
}

}  // namespace boxlight
