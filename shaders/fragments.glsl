// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_FRAGMENTS_GLSL
#define BOXLIGHT_FRAGMENTS_GLSL

#include "layers.glsl"

layout(binding = kBindVisibility, r32ui) readonly uniform uimage2D visibility;

/// The samples of one pixel that see the same triangle, through the same blended layers, shaded as one at their mean position:
/// coverage is sampled more finely than radiance, as multisampling does.
struct Fragment {
  uint triangle;  // + 1; 0 is the background
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

/// Takes the next fragment of a pixel of the image tile out of `pending`, of which a bit must be set.
Fragment nextFragment(uvec2 pixel, inout uvec2 pending) {
  uint first = pending.x != 0 ? findLSB(pending.x) : 32 + findLSB(pending.y);
  Fragment fragment = Fragment(visibleTriangle(pixel, first), first, uvec2(0), 0, vec2(0.0));
  for (uint s = first; s < frame.samples * frame.samples; ++s) {
    uvec2 bit = s < 32 ? uvec2(1u << s, 0) : uvec2(0, 1u << (s - 32));
    if ((pending & bit) == uvec2(0) || visibleTriangle(pixel, s) != fragment.triangle) continue;
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
