// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// A linear picture, and the truth right of the split, to what the window shows: 8-bit sRGB words.
#include "shared.h"
#include "tone_map.glsl"

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;
layout(std430, binding = kBindShown) readonly buffer Shown { vec4 shown[]; };
layout(std430, binding = kBindTruth) readonly buffer Truth { vec4 truth[]; };
layout(std430, binding = kBindDisplay) writeonly buffer Display { uint display[]; };
layout(push_constant) uniform Push { DisplayPush push; };

const vec3 kSplitLine = vec3(1.0, 0.8, 0.1);

vec4 texel(bool ofTruth, ivec2 at, ivec2 size) {
  at = clamp(at, ivec2(0), size - 1);
  int i = at.y * size.x + at.x;
  return ofTruth ? truth[i] : shown[i];
}

/// Bilinear at a position in [0,1]; a picture of the window's own size is met at its pixels' centres, exactly.
vec4 picture(bool ofTruth, vec2 position) {
  ivec2 size = ivec2(ofTruth ? push.truthSize : push.shownSize);
  vec2 at = position * vec2(size) - 0.5;
  if (size == ivec2(push.size)) return texel(ofTruth, ivec2(round(at)), size);
  ivec2 corner = ivec2(floor(at));
  vec2 f = at - vec2(corner);
  vec4 top = mix(texel(ofTruth, corner, size), texel(ofTruth, corner + ivec2(1, 0), size), f.x);
  vec4 bottom = mix(texel(ofTruth, corner + ivec2(0, 1), size), texel(ofTruth, corner + 1, size), f.x);
  return mix(top, bottom, f.y);
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, push.size))) return;
  vec4 linear = picture(pixel.x >= push.split, (vec2(pixel) + 0.5) / vec2(push.size));
  vec3 straight = linear.a > 0.0 ? linear.rgb / linear.a : linear.rgb;
  vec3 color = encodeSrgb(applyToneMap(push.toneMap, straight * push.gain));
  // Where nothing is, a checker that no picture has by chance.
  vec3 empty = vec3(((pixel.x / 8 + pixel.y / 8) & 1) == 0 ? 0.25 : 0.3);
  color = mix(empty, color, clamp(linear.a, 0.0, 1.0));
  if (pixel.x + 1 == push.split) color = kSplitLine;
  display[pixel.y * push.size.x + pixel.x] = packUnorm4x8(vec4(color, 1.0));
}
