// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_LOBE_CLIP_GLSL
#define BOXLIGHT_LOBE_CLIP_GLSL

#include "kernel.glsl"
#include "light_domain.glsl"
#include "visibility_maps.glsl"

/// The maps around a pixel; their weights sum to 1.
struct FilteredMaps {
  uint count;
  uint map[kMaxCorners];  // of the rows
  float weight[kMaxCorners];
  uvec4 hiddenBlocks;  // of any of them
};

/// Of the cells that a rectangle touches in any of the maps: is one hidden, is one visible?
struct Mixture {
  bool anyHidden, anyVisible;
};

Mixture lookAt(Rectangle rectangle, FilteredMaps maps) {
  Columns columns = mapColumns(rectangle);
  Rows rows = mapRows(rectangle);
  if ((blocksOf(columns, rows) & maps.hiddenBlocks) == uvec4(0)) return Mixture(false, true);
  Mixture mixture = Mixture(false, false);
  for (int y = rows.first; y < rows.end && !(mixture.anyHidden && mixture.anyVisible); y += rows.step)
    for (int at = 0; at < columns.count;) {
      int x = (columns.first + at) & (kMapColumns - 1), taken = min(32 - x % 32, columns.count - at);
      uint mask = (~0u >> (32 - taken)) << (x % 32), word = mapWord(y, rows, x);
      for (uint k = 0; k < maps.count; ++k) {
        uint bits = mapAt(maps.map[k] + word) & mask;
        mixture.anyHidden = mixture.anyHidden || bits != mask;
        mixture.anyVisible = mixture.anyVisible || bits != 0;
      }
      at += taken;
    }
  return mixture;
}

/// lobe_clip.cpp: filter. The first `count` maps take part; with none, all is visible.
VisiblePart filterVisible(Rectangle rectangle, FilteredMaps maps, uint count) {
  if (count == 0) return VisiblePart(1.0, rectangle);
  float part = 0.0;
  vec3 latitudes = vec3(0.0);
  vec2 columns = vec2(0.0);
  for (uint k = 0; k < count; ++k) {
    VisiblePart seen = scanVisible(rectangle, maps.map[k]);
    float share = maps.weight[k] * seen.part;
    Latitudes l = seen.around.latitudes;
    part += share;
    latitudes += share * vec3(l.v, l.height, l.below);
    columns += share * vec2(seen.around.u, seen.around.du);
  }
  if (!(part > 0.0)) return VisiblePart(0.0, rectangle);
  latitudes /= part;
  columns /= part;
  return VisiblePart(part, Rectangle(columns.x, columns.y, Latitudes(latitudes.x, latitudes.y, latitudes.z)));
}

Rectangle quarterOf(Rectangle whole, uint i) {
  Latitudes l = whole.latitudes;
  float du = 0.5 * whole.du, height = 0.5 * l.height;
  Latitudes part = (i & 2) == 0 ? Latitudes(l.v, height, l.below + height) : Latitudes(l.v + height, height, l.below);
  return Rectangle(whole.u + float(i & 1) * du, du, part);
}

/// What reaches a point straight, and the part of its lobe that points at other surfaces.
struct ClippedLobe {
  vec3 radiance;
  float hidden;
  vec3 towards;  // sum of hidden energy times the mean direction of its box
};

const float kLeastQuartered = 8.0;  // lobe_clip.cpp

bool isLarge(Rectangle whole) {
  return max(whole.du * float(kMapColumns), whole.latitudes.height * float(kMapRows)) >= kLeastQuartered;
}

/// Adds the visible pieces of a box: radiance, and what arrives from a light of 1. Is any of it hidden?
bool addVisible(LobeBox box, FilteredMaps maps, inout vec3 radiance, inout vec3 direct) {
  Rectangle whole = box.rectangle;
  Mixture mixture = lookAt(whole, maps);
  bool quartered = mixture.anyHidden && isLarge(whole);
  float omegaWhole = solidAngle(whole.du, whole.latitudes);
  // A loop and not branches: lavapipe 22.3 leaves the one, but runs through the others whatever the lanes want.
  uint pieces = !mixture.anyVisible ? 0 : quartered ? 4 : 1;
  for (uint i = 0; i < pieces; ++i) {
    Rectangle piece = whole;
    if (quartered) piece = quarterOf(whole, i);
    VisiblePart seen = filterVisible(piece, maps, mixture.anyHidden ? maps.count : 0);
    vec3 energy = box.energy * seen.part;
    if (quartered) energy *= solidAngle(piece.du, piece.latitudes) / omegaWhole;
    float omega;
    vec3 light = integrateLight(seen.around.u, seen.around.du, seen.around.latitudes, omega);
    radiance += energy * light / max(omega, 1e-30);
    direct += energy;
  }
  return mixture.anyHidden;
}

/// lobe_clip.h: clipLobe of lobeBoxes, under the light. The boxes' energies are divided by their sum.
ClippedLobe clipLobe(GgxLobe lobe, FilteredMaps maps, bool wanted) {
  vec3 radiance = vec3(0.0), direct = vec3(0.0), all = vec3(0.0), towards = vec3(0.0);
  for (uint j = wanted && maps.count > 0 ? 0 : kLobeBoxes; j < kLobeBoxes; ++j) {
    LobeBox box = lobeBox(lobe, j);
    all += box.energy;
    vec3 seen = direct;
    bool hides = addVisible(box, maps, radiance, direct);
    if (kCells && hides) {
      Rectangle r = box.rectangle;
      towards += max(strength(box.energy - (direct - seen)), 0.0) * meanDirection(r.u, r.du, r.latitudes);
    }
  }
  all = max(all, 1e-30);
  return ClippedLobe(radiance / all, clamp(1.0 - strength(direct / all), 0.0, 1.0), towards / strength(all));
}

const float kUnseenHidden = 1.0 / 256.0;  // lobe_clip.h
const float kLeastDirect = 1e-3;

/// lobe_clip.h: splitRadiance. `own`: T there; `stored`: radiance that kernels hold and the part that it stands for.
vec3 splitRadiance(vec3 radiance, float hidden, float own, vec4 stored) {
  vec3 direct = radiance / (own * max(1.0 - hidden, kLeastDirect));
  return radiance + own * hidden * (stored.rgb + kUnseenHidden * direct) / (stored.a + kUnseenHidden);
}

#endif
