// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// One layer of depth peeling (Everitt, "Interactive Order-Independent Transparency", NVIDIA 2001): the nearest blended triangle that
// is not before the opaque one and behind the layer that was peeled last. Of triangles at the same depth the later one lies in front,
// as if they were drawn over each other in their order; the depth test keeps the last of equals.
#include "layers.glsl"
#include "material.glsl"

layout(std430, binding = kBindLayerDepths) readonly buffer LayerDepths { float layerDepths[]; };
layout(location = 0) flat in uint triangleIn;
layout(location = 0) out uvec2 layerOut;

const float kSolid = 1.0 - 1e-6;  // interpolated vertex alphas of 1 may miss it by a rounding error

bool isBehindLastLayer(uint at, float depth) {
  if (layersDrawn == 0) return true;
  uvec2 last = loadLayer(layersDrawn - 1, at);
  if (last.x == 0 || uintBitsToFloat(last.y) >= 1.0) return false;  // nothing behind, or nothing to be seen of it
  float lastDepth = layerDepths[tileSamples() + at];
  return depth < lastDepth || (depth == lastDepth && triangleIn + 1 < last.x);
}

void main() {
  float depth = gl_FragCoord.z;
  gl_FragDepth = depth;  // what is compared is what is stored
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  uint at = pixel.y * tile.size.x * frame.samples + pixel.x;
  if (depth < layerDepths[at] || !isBehindLastLayer(at, depth)) discard;
  uvec4 triangle = triangles[triangleIn];
  // The rasteriser's own weights depend on where an image tile begins, in the last digits.
  vec2 position = gl_FragCoord.xy / float(frame.samples) + vec2(tile.origin);
  float alpha = sampleAlpha(materials[triangle.w], triangle.xyz, hitWeights(loadPlane(triangle.xyz), rayDirection(position)));
  if (alpha <= 0.0) discard;
  layerOut = uvec2(triangleIn + 1, floatBitsToUint(alpha < kSolid ? alpha : 1.0));
}
