// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// How many samples of the image tile the last layer has.
#define LAYERS_ACCESS
#include "layers.glsl"

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;

shared uint groupCount;

void main() {
  if (gl_LocalInvocationIndex == 0) groupCount = 0;
  barrier();
  uvec2 size = tile.size * frame.samples, at = gl_GlobalInvocationID.xy;
  if (all(lessThan(at, size)) && loadLayer(layersDrawn - 1, at.y * size.x + at.x).x != 0) atomicAdd(groupCount, 1);
  barrier();
  if (gl_LocalInvocationIndex == 0 && groupCount > 0) atomicAdd(layerHeader.found, groupCount);
}
