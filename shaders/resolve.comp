// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// The picture: the mean over a pixel's samples of shaded texels, filtered, times the material at full resolution.
#include "atlas.glsl"
#include "fragments.glsl"
#include "light_domain.glsl"
#include "reflectance.glsl"

layout(constant_id = 0) const bool kGlossy = true;
layout(constant_id = 1) const bool kBackground = true;

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;
layout(std430, binding = kBindMarks) readonly buffer Marks { uint marks[]; };
layout(std430, binding = kBindShaded) readonly buffer Shaded { vec4 shaded[]; };
layout(std430, binding = kBindBackground) readonly buffer Background { float background[]; };
layout(std430, binding = kBindPicture) writeonly buffer Picture { vec4 picture[]; };

vec3 backgroundTexel(int x, int y) {
  ivec2 size = ivec2(frame.backgroundSize);
  x = x < 0 ? x + size.x : x >= size.x ? x - size.x : x;
  int i = 3 * (clamp(y, 0, size.y - 1) * size.x + x);
  return vec3(background[i], background[i + 1], background[i + 2]);
}

/// environment.h: sampleEnvironment, turned.
vec3 backgroundRadiance(vec3 direction) {
  vec2 uv = directionToUv(normalize(direction));
  vec2 at = vec2(fract(uv.x + frame.lightOffset), uv.y) * vec2(frame.backgroundSize) - 0.5;
  ivec2 corner = ivec2(floor(at));
  vec2 f = at - vec2(corner);
  vec3 top = mix(backgroundTexel(corner.x, corner.y), backgroundTexel(corner.x + 1, corner.y), f.x);
  vec3 bottom = mix(backgroundTexel(corner.x, corner.y + 1), backgroundTexel(corner.x + 1, corner.y + 1), f.x);
  return mix(top, bottom, f.y);
}

/// Demodulated radiance at an atlas position, over those of the four records that were shaded. (All that exist were marked; should
/// two shaders round a position to different texels, the filter shrinks instead of reading what was never written.)
void filterShaded(vec2 uv, bool front, out vec3 diffuse, out vec3 glossy) {
  AtlasCorners corners = atlasCorners(uv, front);
  diffuse = glossy = vec3(0.0);
  float total = 0.0;
  for (int k = 0; k < 4; ++k) {
    uint r = corners.record[k];
    if (r == kAbsent || marks[r] == 0) continue;
    total += corners.weight[k];
    diffuse += corners.weight[k] * shaded[2 * r].rgb;
    if (kGlossy) glossy += corners.weight[k] * shaded[2 * r + 1].rgb;
  }
  float scale = total > 0.0 ? 1.0 / total : 0.0;
  diffuse *= scale;
  glossy *= scale;
}

vec3 surfaceRadiance(Fragment fragment) {
  uvec4 triangle = triangles[fragment.triangle - 1];
  Plane plane = loadPlane(triangle.xyz);
  vec3 direction = rayDirection(fragment.position);
  SurfacePoint point;
  point.vertices = triangle.xyz;
  point.weight = hitWeights(plane, direction);
  if (kTextured) {
    point.weightDx = planeWeights(plane, rayDirection(fragment.position + vec2(1.0, 0.0)));
    point.weightDy = planeWeights(plane, rayDirection(fragment.position + vec2(0.0, 1.0)));
  }
  bool front = seesFront(plane);
  Reflectance factors = reflectance(materials[triangle.w], point, front, -normalize(direction));
  vec3 diffuse, glossy;
  filterShaded(interpolate2(triangle.xyz, point.weight, kAtlasUvAt), front, diffuse, glossy);
  return factors.diffuse * diffuse + (kGlossy ? factors.glossy * glossy : vec3(0.0));
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, tile.size))) return;
  vec3 sum = vec3(0.0);
  uint covered = 0;
  uvec2 pending = allSamples();
  do {
    Fragment fragment = nextFragment(pixel, pending);
    if (fragment.triangle != 0) {
      sum += surfaceRadiance(fragment) * float(fragment.samples);
      covered += fragment.samples;
    } else if (kBackground) {
      sum += backgroundRadiance(rayDirection(fragment.position)) * float(fragment.samples);
      covered += fragment.samples;
    }
  } while (pending != uvec2(0));
  picture[pixel.y * tile.size.x + pixel.x] = vec4(sum, float(covered)) / float(frame.samples * frame.samples);
}
