// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Equation 3 for every visible texel record: the Lambert kernel as it is stored, and the glossy kernel of the record's own view
// direction, made from the boxes of the three nearest views.
#include "box.glsl"
#include "summed_area.glsl"
#include "views.glsl"

layout(constant_id = 0) const bool kInterpolateWeight = false;
layout(constant_id = 1) const uint kBoxPools = 1;
layout(constant_id = 2) const bool kGlossy = true;
layout(constant_id = 3) const bool kEmitters = true;  // has any kernel emitted radiance?
layout(constant_id = 4) const bool kNormalMapped = true;

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBindRecords) readonly buffer Records { GpuRecord records[]; };
layout(std430, binding = kBindTiles) readonly buffer Tiles { uvec4 tiles[]; };  // first record, records, glossy, diffuse boxes
layout(std430, binding = kBindPageTable) readonly buffer PageTable { PageSlot pageTable[]; };
layout(std430, binding = kBindBoxPools) readonly buffer Boxes0 { uvec4 boxes0[]; };
layout(std430, binding = kBindBoxPools + 1) readonly buffer Boxes1 { uvec4 boxes1[]; };
layout(std430, binding = kBindBoxPools + 2) readonly buffer Boxes2 { uvec4 boxes2[]; };
layout(std430, binding = kBindBoxPools + 3) readonly buffer Boxes3 { uvec4 boxes3[]; };
layout(std430, binding = kBindVisible) readonly buffer Visible {
  VisibleHeader header;
  uint visible[];
};
layout(std430, binding = kBindShaded) writeonly buffer Shaded { vec4 shaded[]; };

const float kHorizonCosine = 0.05;        // view_sphere.h
const float kLeastGradientCosine = 0.1;  // relight.h

/// Where the boxes of one kernel lie.
struct Kernel {
  bool present;
  uint pool, first;
};

Kernel findKernel(uint stream, GpuRecord record, uint boxes) {
  PageSlot page = pageTable[stream * frame.tileCount + record.tile];
  bool upper = record.slot >= 32;
  uint bit = 1u << (record.slot & 31u);
  uint rank = bitCount((upper ? page.maskHigh : page.maskLow) & (bit - 1)) + (upper ? bitCount(page.maskLow) : 0);
  return Kernel(((upper ? page.maskHigh : page.maskLow) & bit) != 0, page.pool, page.firstBox + rank * boxes);
}

uvec4 loadPacked(Kernel kernel, uint j) {
  uint i = kernel.present ? kernel.first + j : 0;
  if (kBoxPools > 1 && kernel.pool == 1) return boxes1[i];
  if (kBoxPools > 2 && kernel.pool == 2) return boxes2[i];
  if (kBoxPools > 3 && kernel.pool == 3) return boxes3[i];
  return boxes0[i];
}

Box loadBox(Kernel kernel, uint j) { return unpackBox(loadPacked(kernel, j)); }

/// Of slot 0: true for all kernels of a tile and a kind of stream, or for none.
bool emits(Kernel kernel) { return kEmitters && kernel.present && isEmission(loadPacked(kernel, 0)); }

vec3 emittedRadiance(Kernel kernel) { return kernel.present ? unpackEmission(loadPacked(kernel, 0)) : vec3(0.0); }

/// Of diffuse radiance: one column a channel is its gradient in the normal (relight.h: diffuseGradient).
struct Diffuse {
  vec3 radiance;
  mat3 gradient;
};

/// What a box of this mean direction adds to the gradient.
mat3 gradientTerm(vec3 normal, vec3 direction, vec3 radiance) {
  float cosine = max(dot(normal, direction), 0.0);
  return outerProduct(direction * (cosine / max(cosine * cosine, kLeastGradientCosine * kLeastGradientCosine)), radiance);
}

Diffuse diffuseRadiance(GpuRecord record) {
  uint boxes = tiles[record.tile].w;
  Kernel kernel = findKernel(frame.diffuseStream, record, boxes);
  Diffuse sum = Diffuse(vec3(0.0), mat3(0.0));
  if (!kernel.present) return sum;
  bool emitting = emits(kernel);
  if (emitting) sum.radiance = emittedRadiance(kernel);
  uint first = emitting ? 1 : 0;
  for (uint j = first; j < first + min(boxes - first, frame.boxLimit); ++j) {
    Box box = loadBox(kernel, j);
    float omega;
    vec3 light = integrateLight(box.u, box.du, box.latitudes, omega);
    vec3 radiance = box.energy * light / omega;
    sum.radiance += radiance;
    if (kNormalMapped) sum.gradient += gradientTerm(record.normal, meanDirection(box.u, box.du, box.latitudes), radiance);
  }
  return sum;
}

vec3 glossyRadiance(GpuRecord record) {
  uint boxes = tiles[record.tile].z;
  vec3 towards = frame.eye.xyz - record.position;
  float distance = length(towards);
  vec3 view = distance > 0.0 ? towards / distance : record.normal;
  ViewBlend blend = locateView(raiseAboveHorizon(view, record.normal, kHorizonCosine));
  Kernel a = findKernel(blend.view.x, record, boxes), b = findKernel(blend.view.y, record, boxes),
         c = findKernel(blend.view.z, record, boxes);
  vec3 weight = blend.weight * vec3(a.present, b.present, c.present);
  float total = weight.x + weight.y + weight.z;
  if (total <= 0.0) return vec3(0.0);
  weight /= total;
  bool emitting = emits(a) || emits(b) || emits(c);
  vec3 sum = vec3(0.0);
  if (emitting) sum = weight.x * emittedRadiance(a) + weight.y * emittedRadiance(b) + weight.z * emittedRadiance(c);
  uint first = emitting ? 1 : 0;
  for (uint j = first; j < first + min(boxes - first, frame.boxLimit); ++j) {
    Box box = interpolateBoxes(loadBox(a, j), loadBox(b, j), loadBox(c, j), weight, kInterpolateWeight);
    float omega;
    vec3 light = integrateLight(box.u, box.du, box.latitudes, omega);
    sum += box.energy * (kInterpolateWeight ? light : light / omega);
  }
  return sum;
}

void main() {
  if (gl_GlobalInvocationID.x >= header.count) return;
  uint entry = visible[gl_GlobalInvocationID.x], r = entry & ~kLambertOnly;
  GpuRecord record = records[r];
  Diffuse diffuse = diffuseRadiance(record);
  shaded[kShadedRadiances * r] = vec4(diffuse.radiance, 0.0);
  for (uint c = 0; kNormalMapped && c < kShadedGradients; ++c) shaded[gradientIndex(r, c)] = vec4(diffuse.gradient[c], 0.0);
  if (kGlossy && entry == r) shaded[kShadedRadiances * r + 1] = vec4(glossyRadiance(record), 0.0);
}
