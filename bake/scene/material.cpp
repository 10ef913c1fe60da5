// SPDX-License-Identifier: Apache-2.0
#include "bake/scene/material.h"

#include <cmath>

namespace boxlight {
namespace {

using asset::kNone;

// The corners of a triangle and the weights of a point on it.
struct Corners {
  Corners(const Scene& scene, SurfacePoint point)
      : triangle(scene.triangles[point.triangle]),
        a(scene.vertices[triangle.vertex[0]]),
        b(scene.vertices[triangle.vertex[1]]),
        c(scene.vertices[triangle.vertex[2]]),
        weights(1.0f - point.barycentric.x - point.barycentric.y, point.barycentric.x, point.barycentric.y) {}

  float mix(float x, float y, float z) const { return weights.x * x + weights.y * y + weights.z * z; }
  // Interpolates the first three floats of an attribute.
  vec3 mix3(const float* x, const float* y, const float* z) const {
    return {mix(x[0], y[0], z[0]), mix(x[1], y[1], z[1]), mix(x[2], y[2], z[2])};
  }
  vec2 uv(uint32_t set) const {
    return {mix(a.uv[set][0], b.uv[set][0], c.uv[set][0]), mix(a.uv[set][1], b.uv[set][1], c.uv[set][1])};
  }
  vec4 color() const {
    return vec4(mix3(a.color, b.color, c.color), mix(a.color[3], b.color[3], c.color[3]));
  }

  const asset::Triangle& triangle;
  const asset::Vertex &a, &b, &c;
  vec3 weights;
};

vec4 sample(const Scene& scene, const Corners& corners, const asset::TextureRef& ref) {
  return sampleTexture(scene, ref.texture, corners.uv(ref.texcoord));
}

vec3 toVec3(const float* v) { return {v[0], v[1], v[2]}; }

// Unit, or `fallback` where v vanishes.
vec3 unitOr(vec3 v, vec3 fallback) {
  const float length2 = glm::dot(v, v);
  return length2 > 1e-12f ? v / std::sqrt(length2) : fallback;
}

// glTF 2.0, section 3.9.3: the texture maps [0,1] to [-1,1], scale multiplies x and y.
vec3 tangentNormal(vec4 texel, float scale) {
  const vec3 n = vec3(texel) * 2.0f - 1.0f;
  return unitOr({n.x * scale, n.y * scale, n.z}, {0, 0, 1});
}

}  // namespace

MaterialSample sampleMaterial(const Scene& scene, SurfacePoint point) {
  const Corners corners(scene, point);
  const asset::Material& m = scene.materials[corners.triangle.material];
  vec4 base = vec4(m.baseColor[0], m.baseColor[1], m.baseColor[2], m.baseColor[3]) * corners.color();
  if (m.baseColorTexture.texture != kNone) base *= sample(scene, corners, m.baseColorTexture);
  MaterialSample result{.baseColor = Rgb(base),
                        .alpha = m.flags & asset::kAlphaMask ? base.w : 1.0f,
                        .metallic = m.metallic,
                        .roughness = m.roughness,
                        .specular = m.specular,
                        .specularColor = toVec3(m.specularColor)};
  if (m.metallicRoughnessTexture.texture != kNone) {
    const vec4 texel = sample(scene, corners, m.metallicRoughnessTexture);
    result.roughness *= texel.y;
    result.metallic *= texel.z;
  }
  if (m.specularTexture.texture != kNone) result.specular *= sample(scene, corners, m.specularTexture).w;
  if (m.specularColorTexture.texture != kNone) {
    result.specularColor *= Rgb(sample(scene, corners, m.specularColorTexture));
  }
  if (m.normalTexture.texture != kNone) {
    result.tangentNormal = tangentNormal(sample(scene, corners, m.normalTexture), m.normalScale);
  }
  return result;
}

float sampleAlpha(const Scene& scene, SurfacePoint point) {
  const Corners corners(scene, point);
  const asset::Material& m = scene.materials[corners.triangle.material];
  if (!(m.flags & asset::kAlphaMask)) return 1.0f;
  float alpha = m.baseColor[3] * corners.mix(corners.a.color[3], corners.b.color[3], corners.c.color[3]);
  if (m.baseColorTexture.texture != kNone) alpha *= sample(scene, corners, m.baseColorTexture).w;
  return alpha;
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

vec3 shadingNormal(const SurfaceFrame& frame, const MaterialSample& material) {
  const vec3 n = material.tangentNormal;
  const vec3 tangent(frame.tangent);
  const vec3 bitangent = glm::cross(frame.normal, tangent) * frame.tangent.w;
  return unitOr(tangent * n.x + bitangent * n.y + frame.normal * n.z, frame.normal);
}

}  // namespace boxlight
