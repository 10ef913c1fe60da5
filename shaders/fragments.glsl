// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_FRAGMENTS_GLSL
#define BOXLIGHT_FRAGMENTS_GLSL

#include "layers.glsl"
#include "material_extension.glsl"

layout(binding = kBindVisibility, r32ui) readonly uniform uimage2D visibility;

/// The samples of one pixel that see the same triangle, or the same surface with lobes to integrate, through the same blended
/// layers: shaded as one at their mean position. Coverage is sampled more finely than radiance, as multisampling does.
struct Fragment {
  uint triangle;  // + 1, of the first sample; 0 is the background
  uint first;     // of its samples
  uvec2 members;  // a bit for each
  uint samples;   // their number
  vec2 position;  // in pixels of the picture
};

/// One bit for each sample of a pixel that belongs to no fragment yet.
uvec2 allSamples() {
  uint count = frame.samples * frame.samples;
  return uvec2(count >= 32 ? ~0u : (1u << count) - 1, count >= 64 ? ~0u : count > 32 ? (1u << (count - 32)) - 1 : 0);
}

/// Of sample s of a pixel, among those of the image tile row by row.
uint sampleIndex(uvec2 pixel, uint s) {
  uvec2 at = pixel * frame.samples + uvec2(s % frame.samples, s / frame.samples);
  return at.y * tile.size.x * frame.samples + at.x;
}

uint visibleTriangle(uvec2 pixel, uint s) {
  return imageLoad(visibility, ivec2(pixel * frame.samples + uvec2(s % frame.samples, s / frame.samples))).x;
}

/// Does the pixel integrate lobes of its own there, of a surface without bumps? Nothing else is worth sparing samples; bumps need
/// every sample that there is.
bool hasSmoothLobes(uint m) {
  if (!kSplit || (materials[m].metallic <= 0.0 && materials[m].specular <= 0.0)) return false;
  bool bumps = materials[m].normalTexture.texture != kAbsent;
  if (kClearcoat) bumps = bumps || materialExtensions[m].textures[kClearcoatNormalTexture].texture != kAbsent;
  return !bumps;
}

/// Are two triangles one surface to a pixel that sees both? With a vertex in common, all that is interpolated goes on from the one to
/// the other: hard edges, borders of charts and of materials have vertices of their own.
bool continues(uint a, uint b) {
  if (a == b) return true;
  if (a == 0 || b == 0) return false;
  uvec4 s = triangles[a - 1], t = triangles[b - 1];
  if (!hasSmoothLobes(s.w)) return false;
  bvec3 x = equal(s.xxx, t.xyz), y = equal(s.yyy, t.xyz), z = equal(s.zzz, t.xyz);
  return s.w == t.w && (any(x) || any(y) || any(z)) && seesFront(loadPlane(s.xyz)) == seesFront(loadPlane(t.xyz));
}

/// Takes the next fragment of a pixel of the image tile out of `pending`, of which a bit must be set.
Fragment nextFragment(uvec2 pixel, inout uvec2 pending) {
  uint first = pending.x != 0 ? findLSB(pending.x) : 32 + findLSB(pending.y);
  Fragment fragment = Fragment(visibleTriangle(pixel, first), first, uvec2(0), 0, vec2(0.0));
  for (uint s = first; s < frame.samples * frame.samples; ++s) {
    uvec2 bit = s < 32 ? uvec2(1u << s, 0) : uvec2(0, 1u << (s - 32));
    if ((pending & bit) == uvec2(0) || !continues(fragment.triangle, visibleTriangle(pixel, s))) continue;
    if (!sameLayers(sampleIndex(pixel, first), sampleIndex(pixel, s))) continue;
    pending &= ~bit;
    fragment.members |= bit;
    ++fragment.samples;
    fragment.position += vec2(s % frame.samples, s / frame.samples) + 0.5;
  }
  fragment.position = fragment.position / float(fragment.samples * frame.samples) + vec2(pixel + tile.origin);
  return fragment;
}

#endif
