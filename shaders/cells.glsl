// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_CELLS_GLSL
#define BOXLIGHT_CELLS_GLSL

#include "kernel.glsl"
#include "views.glsl"

/// What arrives at a record's texel from around a direction by way of other surfaces, and the part of the directions there that
/// point at some.
vec4 arrivingRadiance(GpuRecord record, ViewBlend blend) {
  uint slots = tiles[record.tile].z;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 3; ++k)
    sum += blend.weight[k] * hiddenRadiance(findKernel(frame.diffuseStream + 1 + blend.view[k], record, slots), slots);
  return sum;
}

#endif
