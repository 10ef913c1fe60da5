// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_KERNEL_GLSL
#define BOXLIGHT_KERNEL_GLSL

#include "light.glsl"

layout(constant_id = kConstantBoxPools) const uint kBoxPools = 1;
layout(constant_id = kConstantEmitters) const bool kEmitters = true;

layout(constant_id = kConstantCells) const bool kCells = true;

layout(std430, binding = kBindTiles) readonly buffer Tiles { uvec4 tiles[]; };  // first record, records, glossy, diffuse boxes
layout(std430, binding = kBindPageTable) readonly buffer PageTable { PageSlot pageTable[]; };
layout(std430, binding = kBindBoxPools) readonly buffer Boxes0 { uvec4 boxes0[]; };
layout(std430, binding = kBindBoxPools + 1) readonly buffer Boxes1 { uvec4 boxes1[]; };
layout(std430, binding = kBindBoxPools + 2) readonly buffer Boxes2 { uvec4 boxes2[]; };
layout(std430, binding = kBindBoxPools + 3) readonly buffer Boxes3 { uvec4 boxes3[]; };

/// Where the boxes of one kernel lie.
struct Kernel {
  bool present;
  uint pool, first;
};

Kernel findKernel(uint stream, GpuRecord record, uint boxes) {
  PageSlot page = pageTable[stream * frame.tileCount + record.tile];
  uint slot = record.slot & kRecordSlot;
  bool upper = slot >= 32;
  uint bit = 1u << (slot & 31u);
  uint rank = bitCount((upper ? page.maskHigh : page.maskLow) & (bit - 1)) + (upper ? bitCount(page.maskLow) : 0);
  return Kernel(((upper ? page.maskHigh : page.maskLow) & bit) != 0, page.pool, page.firstBox + rank * boxes);
}

/// Of a kernel that is not there an empty slot: whatever else lay in memory might be no number, and no weight takes that away.
uvec4 loadPacked(Kernel kernel, uint j) {
  if (!kernel.present) return uvec4(0);
  uint i = kernel.first + j;
  if (kBoxPools > 1 && kernel.pool == 1) return boxes1[i];
  if (kBoxPools > 2 && kernel.pool == 2) return boxes2[i];
  if (kBoxPools > 3 && kernel.pool == 3) return boxes3[i];
  return boxes0[i];
}

Box loadBox(Kernel kernel, uint j) { return unpackBox(loadPacked(kernel, j)); }

/// Of slot 0: true for all kernels of a tile and a kind of stream, or for none.
bool emits(Kernel kernel) { return kEmitters && kernel.present && isEmission(loadPacked(kernel, 0)); }

vec3 emittedRadiance(Kernel kernel) { return kernel.present ? unpackEmission(loadPacked(kernel, 0)) : vec3(0.0); }

bool hasCells(GpuRecord record) { return kCells && (record.slot & kRecordHasCells) != 0; }

/// Of a kernel of a split lobe, which has a slot for its hidden part (common/asset: checkSlotKinds): what its hidden directions
/// send, and the part of the lobe that this stands for.
vec4 hiddenRadiance(Kernel kernel, uint slots) {
  uint first = emits(kernel) ? 1 : 0, end = kernel.present ? first + 1 + min(slots - first - 1, frame.boxLimit) : 0;
  vec3 radiance = first > 0 ? emittedRadiance(kernel) : vec3(0.0);
  for (uint j = first + 1; j < end; ++j) {
    Box box = loadBox(kernel, j);
    float omega;
    vec3 light = integrateLight(box.u, box.du, box.latitudes, omega);
    radiance += box.energy * light / omega;
  }
  return vec4(radiance, unpackHiddenPart(loadPacked(kernel, first)));
}

#endif
