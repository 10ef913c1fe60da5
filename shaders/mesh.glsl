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

#endif
