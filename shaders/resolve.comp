// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// The picture: the mean over a pixel's samples of shaded texels, filtered, times the material at full resolution.
#include "background.glsl"
#include "filter.glsl"
#include "fragments.glsl"
#include "reflectance.glsl"

layout(constant_id = kConstantGlossy) const bool kGlossy = true;
layout(constant_id = kConstantBackground) const bool kBackground = true;

layout(local_size_x = kPixelGroup, local_size_y = kPixelGroup) in;
layout(std430, binding = kBindPicture) writeonly buffer Picture { vec4 picture[]; };

const float kLeastDivisor = 0.75;  // of the gloss: theory.md, section 7, thin films

/// What kernels are divided by, and the luminance of the gloss over that; under a film they are of different colours.
vec4 kernelDivisor(Reflectance factors, vec3 gloss) {
  if (!(kFilm && factors.lobe[0].filmed)) return vec4(gloss, 1.0);
  vec3 divisor = max(max(factors.glossy, kLeastDivisor * gloss), kLeastGloss);
  return vec4(divisor, max(strength(gloss / divisor), kLeastGloss));
}

/// Radiance by way of the view-dependent lobes: those of the pixel's own that microfacets reflect, each times its part of the
/// factor, and with the hidden parts of them whatever other lobes there are.
vec3 splitGloss(FilteredRadiance seen, Reflectance factors) {
  vec3 radiance = vec3(0.0), total = factors.glossy, towards = vec3(0.0);
  if (kFilm) total += factors.filmed;
  for (uint l = 0; l < (kClearcoat ? kPixelLobes : 1); ++l) total -= factors.reflected[l];
  float hidden = strength(total);
  for (uint l = 0; l < (kClearcoat ? kPixelLobes : 1); ++l) {
    vec3 assumed = factors.lobe[l].albedo, factor = factors.reflected[l];
    vec3 albedo = lobeAlbedo(factors.lobe[l], kExtended && assumed != vec3(0.0));
    ClippedLobe lobe = seeLobe(factors.lobe[l], seen.maps, factor != vec3(0.0));
    if (assumed != vec3(0.0)) factor *= albedo / max(assumed, 1e-6);
    radiance += factor * lobe.radiance;
    hidden += strength(factor) * lobe.hidden;
    towards += strength(factor) * lobe.towards;
    total += factor;
  }
  total = max(total, 1e-30);
  vec4 divisor = kernelDivisor(factors, total);
  vec4 stored = seen.hidden;
  if (kCells) {
    bool hides = dot(towards, towards) > 0.0;  // and not only unmirrored lobes
    if (!hides) seen.cells.count = 0;
    vec4 arriving = arrivingFrom(hides ? normalize(towards) : vec3(0.0, 1.0, 0.0), seen.cells);
    stored += kFilm && factors.lobe[0].filmed ? arriving * vec4(total / divisor.rgb, divisor.a) : arriving;
  }
  hidden = clamp(hidden / strength(total), 0.0, 1.0);
  return divisor.rgb * splitRadiance(radiance / divisor.rgb, hidden, divisor.a, stored);
}

vec3 glossyRadiance(FilteredRadiance seen, Reflectance factors) {
  vec3 whole = factors.glossy * seen.glossy;
  if (!kSplit) return whole;
  vec3 split = splitGloss(seen, factors);
  return seen.split > 0.0 ? whole + seen.split * split : whole;
}

/// Towards the eye, of the plane of a triangle where the ray through a pixel position meets it; of a share of the pixel's area.
vec3 surfaceRadiance(uint index, vec2 position, float share) {
  uvec4 triangle = triangles[index];
  Plane plane = loadPlane(triangle.xyz);
  vec3 direction = rayDirection(position);
  SurfacePoint point;
  point.vertices = triangle.xyz;
  point.weight = hitWeights(plane, direction);
  PlaneSteps steps = planeSteps(plane, position);
  point.weightDx = point.weight + steps.dx;
  point.weightDy = point.weight + steps.dy;
  if (kSplit) point.turn = normalTurn(triangle.xyz, point.weight, steps, share);
  bool front = seesFront(plane);
  vec3 normal = shadingNormal(materials[triangle.w], point) * (front ? 1.0 : -1.0);
  Reflectance factors = reflectance(triangle.w, point, front, normal, -normalize(direction));
  Bend bend = Bend(materials[triangle.w].normalTexture.texture != kAbsent, normal);
  AtlasPlace place = atlasPlace(triangle.xyz, point.weight, steps);
  FilteredRadiance seen = filterShaded(place, front, kGlossy && factors.glossy != vec3(0.0), bend);
  vec3 radiance = factors.diffuse * seen.diffuse;
  if (kGlossy) radiance += glossyRadiance(seen, factors);
  if (kOtherSide && showsOtherSide(triangle.w)) {
    // What a medium scatters does not come straight from the light.
    bend = Bend(bend.bends && (materials[triangle.w].flags & kVolume) == 0, -normal);
    radiance += factors.transmitted * filterShaded(place, !front, false, bend).diffuse;
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

float samplesOfPixel() { return float(frame.samples * frame.samples); }

/// Radiance and coverage where a triangle, or with 0 the background, is seen.
vec4 seenRadiance(uint triangle, vec2 position, float share) {
  vec4 seen = vec4(0.0);
  if (triangle != 0)
    seen = vec4(surfaceRadiance(triangle - 1, position, share), 1.0);
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
    if (share > 0.0) sum += share * seenRadiance(last ? fragment.triangle : triangle, fragment.position, float(fragment.samples) / samplesOfPixel());
    ++layer;
  } while (!last);
  return sum;
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy + uvec2(0, firstRow);
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
        sum += float(fragment.samples) * seenRadiance(fragment.triangle, fragment.position, float(fragment.samples) / samplesOfPixel());
    }
  } while (pending != uvec2(0));
  picture[pixel.y * tile.size.x + pixel.x] = sum / samplesOfPixel();
}
