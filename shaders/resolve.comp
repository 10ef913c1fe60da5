// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// The picture: the mean over a pixel's samples of shaded texels, filtered, times the material at full resolution.
#include "atlas.glsl"
#include "fragments.glsl"
#include "light_domain.glsl"
#include "reflectance.glsl"

layout(constant_id = kConstantGlossy) const bool kGlossy = true;
layout(constant_id = kConstantBackground) const bool kBackground = true;
layout(constant_id = kConstantNormalMapped) const bool kNormalMapped = true;

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;
layout(std430, binding = kBindRecords) readonly buffer Records { GpuRecord records[]; };
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

/// What arrives at an atlas position, demodulated.
struct FilteredRadiance {
  vec3 diffuse, glossy;
};

/// A normal that a normal map bends, on the side that is looked at; elsewhere the records' own are good enough.
struct Bend {
  bool bends;
  vec3 normal;
};

/// Of a record's diffuse radiance, for another normal than its own: to first order, so that the mean over a texel stays what the
/// bake measured there.
vec3 diffuseChange(uint r, vec3 normal) {
  vec3 change = normal - dot(normal, records[r].normal) * records[r].normal;
  return vec3(dot(shaded[gradientIndex(r, 0)].xyz, change), dot(shaded[gradientIndex(r, 1)].xyz, change),
              dot(shaded[gradientIndex(r, 2)].xyz, change));
}

/// The mean over those of the four records that were shaded. (All that exist were marked; should two shaders round a position to
/// different texels, the filter shrinks instead of reading what was never written.)
FilteredRadiance filterShaded(vec2 uv, bool front, bool withGlossy, Bend bend) {
  AtlasCorners corners = atlasCorners(uv, front);
  FilteredRadiance sum = FilteredRadiance(vec3(0.0), vec3(0.0));
  float total = 0.0;
  for (int k = 0; k < 4; ++k) {
    uint r = corners.record[k];
    if (r == kAbsent || marks[r] == 0) continue;
    total += corners.weight[k];
    sum.diffuse += corners.weight[k] * shaded[kShadedRadiances * r].rgb;
    if (kNormalMapped && bend.bends) sum.diffuse += corners.weight[k] * diffuseChange(r, bend.normal);
    if (withGlossy) sum.glossy += corners.weight[k] * shaded[kShadedRadiances * r + 1].rgb;
  }
  float scale = total > 0.0 ? 1.0 / total : 0.0;
  return FilteredRadiance(max(sum.diffuse * scale, 0.0), sum.glossy * scale);
}

/// Towards the eye, of the plane of a triangle where the ray through a pixel position meets it.
vec3 surfaceRadiance(uint index, vec2 position) {
  uvec4 triangle = triangles[index];
  Plane plane = loadPlane(triangle.xyz);
  vec3 direction = rayDirection(position);
  SurfacePoint point;
  point.vertices = triangle.xyz;
  point.weight = hitWeights(plane, direction);
  if (kTextured) {
    point.weightDx = planeWeights(plane, rayDirection(position + vec2(1.0, 0.0)));
    point.weightDy = planeWeights(plane, rayDirection(position + vec2(0.0, 1.0)));
  }
  bool front = seesFront(plane);
  vec3 normal = shadingNormal(materials[triangle.w], point) * (front ? 1.0 : -1.0);
  Reflectance factors = reflectance(triangle.w, point, front, normal, -normalize(direction));
  Bend bend = Bend(materials[triangle.w].normalTexture.texture != kAbsent, normal);
  vec2 uv = interpolate2(triangle.xyz, point.weight, kAtlasUvAt);
  FilteredRadiance seen = filterShaded(uv, front, kGlossy, bend);
  vec3 radiance = factors.diffuse * seen.diffuse;
  if (kGlossy) radiance += factors.glossy * seen.glossy;
  if (kOtherSide && showsOtherSide(triangle.w)) {
    // What a medium scatters does not come straight from the light.
    bend = Bend(bend.bends && (materials[triangle.w].flags & kVolume) == 0, -normal);
    radiance += factors.transmitted * filterShaded(uv, !front, false, bend).diffuse;
  }
  return kExtended ? radiance + factors.emission : radiance;
}

const uint kWeights = kLayers + 1;

/// How much of a fragment's samples each layer covers, front to back, and last what is left for what lies behind them: alpha at
/// full resolution, sample by sample, each over the next (Porter and Duff, "Compositing Digital Images", SIGGRAPH 1984).
void layerWeights(uvec2 pixel, Fragment fragment, inout float weight[kWeights]) {
  for (uint layer = 0; layer < kWeights; ++layer) weight[layer] = 0.0;
  for (uint s = fragment.first; s < frame.samples * frame.samples; ++s) {
    if ((s < 32 ? fragment.members.x >> s & 1 : fragment.members.y >> (s - 32) & 1) == 0) continue;
    uint at = sampleIndex(pixel, s);
    float left = 1.0;
    for (uint layer = 0; layer < layerCount(); ++layer) {
      uvec2 covering = loadLayer(layer, at);
      if (covering.x == 0) break;
      float alpha = uintBitsToFloat(covering.y);
      weight[layer] += left * alpha;
      left *= 1.0 - alpha;
    }
    weight[kLayers] += left;
  }
}

/// Radiance and coverage where a triangle, or with 0 the background, is seen.
vec4 seenRadiance(uint triangle, vec2 position) {
  vec4 seen = vec4(0.0);
  if (triangle != 0)
    seen = vec4(surfaceRadiance(triangle - 1, position), 1.0);
  else if (kBackground)
    seen = vec4(backgroundRadiance(rayDirection(position)), 1.0);
  return seen;
}

/// The same, summed over the fragment's samples: of the layers and, last of all, of what lies behind them.
vec4 layeredRadiance(uvec2 pixel, Fragment fragment) {
  float weight[kWeights];
  layerWeights(pixel, fragment, weight);
  vec4 sum = vec4(0.0);
  uint layer = 0;
  bool last = false;
  do {
    uint triangle = layer < layerCount() ? loadLayer(layer, sampleIndex(pixel, fragment.first)).x : 0;
    last = triangle == 0;
    float share = weight[last ? kLayers : layer];
    if (share > 0.0) sum += share * seenRadiance(last ? fragment.triangle : triangle, fragment.position);
    ++layer;
  } while (!last);
  return sum;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, tile.size))) return;
  vec4 sum = vec4(0.0);
  uvec2 pending = allSamples();
  do {
    Fragment fragment = nextFragment(pixel, pending);
    // Always true, but lavapipe 22.3 masks what is inside an `if` only: without one, threads that are through add once more.
    if (fragment.samples > 0) {
      if (kLayers > 0)
        sum += layeredRadiance(pixel, fragment);
      else
        sum += float(fragment.samples) * seenRadiance(fragment.triangle, fragment.position);
    }
  } while (pending != uvec2(0));
  picture[pixel.y * tile.size.x + pixel.x] = sum / float(frame.samples * frame.samples);
}
