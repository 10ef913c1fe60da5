// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Equation 3 for every visible texel record: the Lambert kernel as it is stored, and the glossy kernel of the record's own view
// direction, made from the boxes of the three nearest views.
#include "kernel.glsl"
#include "light_domain.glsl"
#include "views.glsl"
#include "visibility_maps.glsl"

layout(constant_id = kConstantWeights) const bool kInterpolateWeight = false;
layout(constant_id = kConstantGlossy) const bool kGlossy = true;
layout(constant_id = kConstantNormalMapped) const bool kNormalMapped = true;
layout(constant_id = kConstantSplit) const bool kSplit = true;
layout(constant_id = kConstantLambert) const bool kLambert = true;

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBindRecords) readonly buffer Records { GpuRecord records[]; };
layout(std430, binding = kBindVisible) readonly buffer Visible {
  VisibleHeader header;
  uint visible[];
};
layout(std430, binding = kBindShaded) writeonly buffer Shaded { vec4 shaded[]; };

const float kHorizonCosine = 0.05;        // view_sphere.h
const float kLeastGradientCosine = 0.1;  // relight.h

/// Of diffuse radiance: one column a channel is its gradient in the normal (relight.h: DiffuseRadiance).
struct Diffuse {
  vec3 radiance;
  mat3 gradient;
};

/// What a box of this mean direction adds to the gradient.
mat3 gradientTerm(vec3 normal, vec3 direction, vec3 radiance) {
  float cosine = max(dot(normal, direction), 0.0);
  return outerProduct(direction * (cosine / max(cosine * cosine, kLeastGradientCosine * kLeastGradientCosine)), radiance);
}

/// A slot of a Lambert kernel; straight light is summed apart.
void addSlot(uvec4 packed, vec3 normal, vec3 mapNormal, inout Diffuse sum, inout StraightLight straight) {
  if (isCosineBox(packed)) {
    addCosineBox(packed, mapNormal, straight);
    return;
  }
  Box box = unpackBox(packed);
  float omega;
  vec3 light = integrateLight(box.u, box.du, box.latitudes, omega);
  vec3 radiance = box.energy * light / omega;
  sum.radiance += radiance;
  if (kNormalMapped) sum.gradient += gradientTerm(normal, meanDirection(box.u, box.du, box.latitudes), radiance);
}

Diffuse diffuseRadiance(GpuRecord record) {
  uint boxes = tiles[record.tile].w;
  Kernel kernel = findKernel(frame.diffuseStream, record, boxes);
  Diffuse sum = Diffuse(vec3(0.0), mat3(0.0));
  if (!kernel.present) return sum;
  bool emitting = emits(kernel);
  if (emitting) sum.radiance = emittedRadiance(kernel);
  uint first = emitting ? 1 : 0, end = first + min(boxes - first, frame.boxLimit);
  vec3 mapNormal = turnedToMap(record.normal);
  StraightLight straight = StraightLight(vec3(0.0), Moment(vec3(0.0), vec3(0.0), vec3(0.0)));
  for (uint j = first; j < end; ++j) {
    uvec4 packed = loadPacked(kernel, j);
    if (packed == uvec4(0)) continue;  // many slots are empty
    addSlot(packed, record.normal, mapNormal, sum, straight);
  }
  sum.radiance += max(straight.irradiance, vec3(0.0)) / kPi;
  if (kNormalMapped) {
    Moment moment = turnedToWorld(straight.moment);
    sum.gradient += transpose(mat3(moment.x, moment.y, moment.z)) / kPi;
  }
  return sum;
}

/// The kernels of the three views nearest to the eye's.
struct GlossyKernels {
  Kernel of[3];
  vec3 weight;  // 0 where there is no kernel
  uint slots;
  bool emitting;
};

GlossyKernels findGlossy(GpuRecord record) {
  GlossyKernels kernels;
  kernels.slots = tiles[record.tile].z;
  vec3 towards = frame.eye.xyz - record.position;
  float distance = length(towards);
  vec3 view = distance > 0.0 ? towards / distance : record.normal;
  uint sphere = record.slot >> kRecordSphereShift & 3u;
  ViewBlend blend = locateView(raiseAboveHorizon(view, record.normal, kHorizonCosine), frame.sphereStart[sphere],
                               frame.sphereTriangles[sphere]);
  kernels.emitting = false;
  for (int k = 0; k < 3; ++k) {
    kernels.of[k] = findKernel(blend.view[k], record, kernels.slots);
    kernels.weight[k] = kernels.of[k].present ? blend.weight[k] : 0.0;
    kernels.emitting = kernels.emitting || emits(kernels.of[k]);
  }
  return kernels;
}

vec3 wholeRadiance(GlossyKernels kernels) {
  Kernel a = kernels.of[0], b = kernels.of[1], c = kernels.of[2];
  float total = kernels.weight.x + kernels.weight.y + kernels.weight.z;
  if (total <= 0.0) return vec3(0.0);
  vec3 weight = kernels.weight / total;
  vec3 sum = vec3(0.0);
  if (kernels.emitting)
    sum = weight.x * emittedRadiance(a) + weight.y * emittedRadiance(b) + weight.z * emittedRadiance(c);
  uint first = kernels.emitting ? 1 : 0;
  for (uint j = first; j < first + min(kernels.slots - first, frame.boxLimit); ++j) {
    Box box = interpolateBoxes(loadBox(a, j), loadBox(b, j), loadBox(c, j), weight, kInterpolateWeight);
    float omega;
    vec3 light = integrateLight(box.u, box.du, box.latitudes, omega);
    sum += box.energy * (kInterpolateWeight ? light : light / omega);
  }
  return sum;
}

/// Boxes of different views show different surfaces: each view is evaluated on its own.
vec4 hiddenOfViews(GlossyKernels kernels) {
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 3; ++k) sum += kernels.weight[k] * hiddenRadiance(kernels.of[k], kernels.slots);
  return sum;
}

vec4 glossyRadiance(uint r, GpuRecord record) {
  if (hasCells(record)) return vec4(0.0);  // for its pixels to find
  GlossyKernels kernels = findGlossy(record);
  if (kSplit && isSplit(r)) return hiddenOfViews(kernels);
  return vec4(wholeRadiance(kernels), 0.0);
}

void main() {
  if (gl_GlobalInvocationID.x >= header.count) return;
  uint entry = visible[gl_GlobalInvocationID.x], r = entry & ~kLambertOnly;
  GpuRecord record = records[r];
  Diffuse diffuse = Diffuse(vec3(0.0), mat3(0.0));
  if (kLambert) diffuse = diffuseRadiance(record);
  shaded[kShadedRadiances * r] = vec4(diffuse.radiance, 0.0);
  for (uint c = 0; kNormalMapped && c < kShadedGradients; ++c) shaded[gradientIndex(r, c)] = vec4(diffuse.gradient[c], 0.0);
  if (kGlossy && entry == r) shaded[kShadedRadiances * r + 1] = glossyRadiance(r, record);
}
