// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_MESH_GLSL
#define BOXLIGHT_MESH_GLSL

#include "frame.glsl"

layout(std430, binding = kBindVertices) readonly buffer Vertices { float vertexFloats[]; };
layout(std430, binding = kBindTriangles) readonly buffer Triangles { uvec4 triangles[]; };  // three vertices, material

const uint kVertexFloats = 20;  // asset::Vertex, member by member
const uint kNormalAt = 3, kTangentAt = 6, kAtlasUvAt = 10, kUvAt = 12, kColorAt = 16;

vec2 vertexVec2(uint vertex, uint member) {
  uint i = vertex * kVertexFloats + member;
  return vec2(vertexFloats[i], vertexFloats[i + 1]);
}

vec3 vertexVec3(uint vertex, uint member) { return vec3(vertexVec2(vertex, member), vertexFloats[vertex * kVertexFloats + member + 2]); }

vec4 vertexVec4(uint vertex, uint member) { return vec4(vertexVec2(vertex, member), vertexVec2(vertex, member + 2)); }

vec3 vertexPosition(uint vertex) { return vertexVec3(vertex, 0); }

vec2 interpolate2(uvec3 vertices, vec3 weight, uint member) {
  return weight.x * vertexVec2(vertices.x, member) + weight.y * vertexVec2(vertices.y, member) + weight.z * vertexVec2(vertices.z, member);
}

vec3 interpolate3(uvec3 vertices, vec3 weight, uint member) {
  return weight.x * vertexVec3(vertices.x, member) + weight.y * vertexVec3(vertices.y, member) + weight.z * vertexVec3(vertices.z, member);
}

vec4 interpolate4(uvec3 vertices, vec3 weight, uint member) {
  return weight.x * vertexVec4(vertices.x, member) + weight.y * vertexVec4(vertices.y, member) + weight.z * vertexVec4(vertices.z, member);
}

/// A triangle's plane: one corner and the edges from it.
struct Plane {
  vec3 corner, ab, ac;
};

Plane loadPlane(uvec3 vertices) {
  vec3 a = vertexPosition(vertices.x);
  return Plane(a, vertexPosition(vertices.y) - a, vertexPosition(vertices.z) - a);
}

/// Does the eye see the front of the triangle? One answer for all its points: the camera is a point.
bool seesFront(Plane plane) { return dot(cross(plane.ab, plane.ac), frame.eye.xyz - plane.corner) > 0.0; }

/// Direction of the ray through a continuous pixel position, not of unit length (camera.h: Camera::direction).
vec3 rayDirection(vec2 pixel) {
  vec2 screen = 2.0 * pixel / vec2(frame.imageSize) - 1.0;
  return frame.forward.xyz + screen.x * frame.rayRight.xyz - screen.y * frame.rayUp.xyz;
}

/// Barycentric weights of the point where the plane of a triangle meets the ray from the eye along `direction`. Möller and Trumbore,
/// "Fast, Minimum Storage Ray-Triangle Intersection", JGT 2(1), 1997.
vec3 planeWeights(Plane plane, vec3 direction) {
  vec3 fromCorner = frame.eye.xyz - plane.corner;
  vec3 p = cross(direction, plane.ac), q = cross(fromCorner, plane.ab);
  float determinant = dot(plane.ab, p);
  if (determinant == 0.0) return vec3(1.0, 0.0, 0.0);
  vec2 yz = vec2(dot(fromCorner, p), dot(direction, q)) / determinant;
  return vec3(1.0 - yz.x - yz.y, yz);
}

/// The same, kept inside the triangle: a point on its edge may miss it by a rounding error.
vec3 hitWeights(Plane plane, vec3 direction) {
  vec3 weight = clamp(planeWeights(plane, direction), 0.0, 1.0);
  return weight / (weight.x + weight.y + weight.z);
}

/// How barycentric weights change from a pixel to the next in x and in y.
struct PlaneSteps {
  vec3 dx, dy;
};

PlaneSteps planeSteps(Plane plane, vec2 position) {
  vec3 at = planeWeights(plane, rayDirection(position));
  return PlaneSteps(planeWeights(plane, rayDirection(position + vec2(1.0, 0.0))) - at,
                    planeWeights(plane, rayDirection(position + vec2(0.0, 1.0))) - at);
}

/// How the interpolated normal turns inside a pixel: its variance along a unit vector of its plane, the larger one, and across.
struct NormalTurn {
  vec3 along;
  vec2 variance;
};

const float kLeastTurn = 1e-5, kMostTurned = 1e3;  // from pixel to pixel: less is rounding, and more says nothing

/// From a pixel to the next, in units of the normal.
vec3 normalStep(uvec3 vertices, vec3 normal, vec3 weightStep) {
  vec3 first = vertexVec3(vertices.x, kNormalAt);
  vec3 step = weightStep.y * (vertexVec3(vertices.y, kNormalAt) - first) + weightStep.z * (vertexVec3(vertices.z, kNormalAt) - first);
  float size = dot(normal, normal);
  step -= dot(step, normal) / size * normal;
  return clamp(step * inversesqrt(size), -kMostTurned, kMostTurned);
}

/// Of a share of the pixel's area. A square of side 1 has a variance of 1/12 each way.
NormalTurn normalTurn(uvec3 vertices, vec3 weight, PlaneSteps steps, float share) {
  vec3 normal = interpolate3(vertices, weight, kNormalAt), dx = normalStep(vertices, normal, steps.dx), dy = normalStep(vertices, normal, steps.dy);
  float most = max(length(dx), length(dy));
  if (!(most > kLeastTurn)) return NormalTurn(vec3(1.0, 0.0, 0.0), vec2(0.0));
  dx /= most;
  dy /= most;
  float xx = dot(dx, dx), yy = dot(dy, dy), xy = dot(dx, dy), mean = 0.5 * (xx + yy), difference = 0.5 * (xx - yy);
  float spread = sqrt(difference * difference + xy * xy);
  // The eigenvector of the larger variance, in whichever of its two forms is the longer one; none if both are the same.
  vec3 along = difference >= 0.0 ? (spread + difference) * dx + xy * dy : xy * dx + (spread - difference) * dy;
  along = dot(along, along) > 1e-12 ? normalize(along) : normalize(xx > yy ? dx : dy);
  return NormalTurn(along, vec2(mean + spread, max(mean - spread, 0.0)) * most * most * share / 12.0);
}

#endif
