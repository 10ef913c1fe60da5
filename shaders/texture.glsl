// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_TEXTURE_GLSL
#define BOXLIGHT_TEXTURE_GLSL

#include "frame.glsl"

layout(std430, binding = kBindTextures) readonly buffer Textures { TextureHeader textures[]; };
layout(std430, binding = kBindTextureLevels) readonly buffer TextureLevels { TextureLevel textureLevels[]; };
layout(std430, binding = kBindTexels) readonly buffer Texels { uint texels[]; };

const uint kClampToEdge = 1, kMirroredRepeat = 2;  // asset::Wrap
const uint kMinNearest = 0, kMinTrilinear = 2;

int wrapIndex(int i, int size, uint mode) {
  if (mode == kClampToEdge) return clamp(i, 0, size - 1);
  int period = mode == kMirroredRepeat ? 2 * size : size;
  int inside = i - period * int(floor(float(i) / float(period)));
  inside = clamp(inside, 0, period - 1);
  return inside < size ? inside : period - 1 - inside;
}

/// One texel, decoded before anything is filtered.
vec4 fetchTexel(TextureHeader header, TextureLevel level, ivec2 at) {
  uint x = uint(wrapIndex(at.x, int(level.width), header.wrapS)), y = uint(wrapIndex(at.y, int(level.height), header.wrapT));
  uint word = texels[level.firstTexel + y * level.width + x];
  if (header.srgb == 0) return unpackUnorm4x8(word);
  return vec4(tableAt(kTableSrgb + (word & 255u)), tableAt(kTableSrgb + (word >> 8 & 255u)),
              tableAt(kTableSrgb + (word >> 16 & 255u)), float(word >> 24) / 255.0);
}

vec4 sampleLevel(TextureHeader header, uint levelIndex, vec2 uv, bool nearest) {
  TextureLevel level = textureLevels[header.firstLevel + levelIndex];
  vec2 at = uv * vec2(level.width, level.height);
  if (nearest) return fetchTexel(header, level, ivec2(floor(at)));
  at -= 0.5;
  ivec2 corner = ivec2(floor(at));
  vec2 f = at - vec2(corner);
  vec4 top = mix(fetchTexel(header, level, corner), fetchTexel(header, level, corner + ivec2(1, 0)), f.x);
  vec4 bottom = mix(fetchTexel(header, level, corner + ivec2(0, 1)), fetchTexel(header, level, corner + ivec2(1, 1)), f.x);
  return mix(top, bottom, f.y);
}

/// Linear RGBA. `dx` and `dy` are the changes of uv from one pixel to the next: the longer one in texels chooses the level (OpenGL 4.6,
/// section 8.14).
vec4 sampleTexture(uint index, vec2 uv, vec2 dx, vec2 dy) {
  TextureHeader header = textures[index];
  TextureLevel base = textureLevels[header.firstLevel];
  vec2 size = vec2(base.width, base.height);
  float texelsPerPixel = max(length(dx * size), length(dy * size));
  float lod = log2(max(texelsPerPixel, 1e-6));
  if (lod <= 0.0) return sampleLevel(header, 0, uv, header.magNearest != 0);
  if (header.minFilter != kMinTrilinear) return sampleLevel(header, 0, uv, header.minFilter == kMinNearest);
  lod = min(lod, float(header.levelCount - 1));
  uint level = uint(lod);
  vec4 fine = sampleLevel(header, level, uv, false);
  if (level + 1 >= header.levelCount) return fine;
  return mix(fine, sampleLevel(header, level + 1, uv, false), lod - float(level));
}

#endif
