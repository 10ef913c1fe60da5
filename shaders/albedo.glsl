// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_ALBEDO_GLSL
#define BOXLIGHT_ALBEDO_GLSL

#include "frame.glsl"

/// albedo_nodes.h: the node below (roughness, n.v), and the fractions to the next.
struct AlbedoNode {
  uint index;
  vec2 fraction;
};

AlbedoNode albedoNode(float roughness, float nDotV) {
  float last = float(kAlbedoNodes - 1);
  vec2 at = sqrt(clamp(vec2(roughness, nDotV), 0.0, 1.0)) * last;
  uvec2 corner = uvec2(min(at, last - 1.0));
  return AlbedoNode(corner.y * kAlbedoNodes + corner.x, at - vec2(corner));
}

/// directional_albedo.h: AlbedoTable::specular.
vec2 specularAlbedo(float roughness, float nDotV) {
  AlbedoNode node = albedoNode(roughness, nDotV);
  uint i = 2 * node.index, below = i + 2 * kAlbedoNodes;
  vec2 top = mix(vec2(tableAt(i), tableAt(i + 1)), vec2(tableAt(i + 2), tableAt(i + 3)), node.fraction.x);
  vec2 bottom = mix(vec2(tableAt(below), tableAt(below + 1)), vec2(tableAt(below + 2), tableAt(below + 3)), node.fraction.x);
  return mix(top, bottom, node.fraction.y);
}

/// directional_albedo.h: AlbedoTable::diffuseFresnel.
float diffuseFresnel(float nDotV) {
  float at = sqrt(clamp(nDotV, 0.0, 1.0)) * float(kAlbedoNodes - 1);
  uint i = uint(min(at, float(kAlbedoNodes - 2)));
  return mix(tableAt(kTableFresnel + i), tableAt(kTableFresnel + i + 1), at - float(i));
}

/// sheen.h: albedo.
float sheenAlbedo(float roughness, float nDotV) {
  AlbedoNode node = albedoNode(roughness, nDotV);
  uint i = kTableSheen + node.index, below = i + kAlbedoNodes;
  float top = mix(tableAt(i), tableAt(i + 1), node.fraction.x), bottom = mix(tableAt(below), tableAt(below + 1), node.fraction.x);
  return mix(top, bottom, node.fraction.y);
}

#endif
