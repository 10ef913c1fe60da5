// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_WIDE_LOBE_GLSL
#define BOXLIGHT_WIDE_LOBE_GLSL
// wide_lobe.h: lobes by cells of the light.

#include "lobe_clip.glsl"

// Mesa 22.3's lavapipe ends a lane's loops after 65535 rounds of all of them: inner ones are kept short.

layout(constant_id = kConstantWide) const bool kWide = true;

const float kWideFrom = 0.1, kWideTo = 0.13, kMergedFrom = 0.4;  // wide_lobe.h

/// light_moments.h: LightCell; the light in units of the moments.
struct LightCell {
  Moment light;
  vec3 one;
};

LightCell loadLightCell(uint first, uint cell) {
  uint i = first + 3 * cell;
  vec4 x = uintBitsToFloat(BOXLIGHT_MOMENT(i)), y = uintBitsToFloat(BOXLIGHT_MOMENT(i + 1)), z = uintBitsToFloat(BOXLIGHT_MOMENT(i + 2));
  return LightCell(Moment(x.xyz, y.xyz, z.xyz), vec3(x.w, y.w, z.w));
}

/// The lobe's density over the cosine; `axes` of the frame as the light map has it.
vec3 lobeDensity(GgxLobe lobe, mat3 axes, vec3 direction) {
  const float kLeastCosine = 1e-4;
  vec3 light = normalize(direction) * axes;
  light.z = max(light.z, kLeastCosine);
  vec3 halfVector = normalize(lobe.view + light);
  vec3 slope = vec3(halfVector.xy / lobe.alpha, halfVector.z);
  float square = dot(slope, slope), distribution = 1.0 / (kPi * lobe.alpha.x * lobe.alpha.y * square * square);
  float visibility = 0.5 / (light.z * stretchedLength(lobe.view, lobe.alpha) + lobe.view.z * stretchedLength(light, lobe.alpha));
  float grazing = clamp(1.0 - dot(lobe.view, halfVector), 0.0, 1.0), squared = grazing * grazing;
  vec3 fresnel = lobe.f0 + (lobe.f90 - lobe.f0) * (squared * squared * grazing);
  if (kFilm && lobe.filmed) fresnel = clamp(fresnel, kLeastFilmed, 1.0);
  return distribution * visibility * fresnel;
}

struct CellSums {
  vec3 radiance, direct, all, towards;
};

void addCellLight(Moment light, float visible, GgxLobe lobe, mat3 axes, inout CellSums sums) {
  vec3 arriving = max(along(light, axes[2]), vec3(0.0));
  vec3 centre = vec3(strength(light.x), strength(light.y), strength(light.z));
  if (visible > 0.0 && strength(arriving) > 0.0 && dot(centre, centre) > 0.0)
    sums.radiance += visible * arriving * lobeDensity(lobe, axes, centre);
}

void addCell(LightCell cell, float visible, GgxLobe lobe, mat3 axes, inout CellSums sums) {
  float cosine = dot(axes[2], cell.one);
  if (cosine > 0.0) {
    vec3 energy = cosine * lobeDensity(lobe, axes, cell.one);
    sums.all += energy;
    sums.direct += visible * energy;
    if (kCells) sums.towards += (1.0 - visible) * strength(energy) * normalize(cell.one);
  }
  addCellLight(cell.light, visible, lobe, axes, sums);
}

Rectangle cellRectangle(uvec2 at, uvec2 count) {
  float height = 1.0 / float(count.y), v = float(at.y) * height;
  return Rectangle(fract(float(at.x) / float(count.x) - BOXLIGHT_LIGHT_OFFSET), 1.0 / float(count.x), Latitudes(v, height, 1.0 - v - height));
}

/// Of one map the visible parts of a block's quarters: of 8 rows, of which the block covers 8 columns from `shift` behind the first.
vec4 visibleQuarters(uint map, int column, int row, float shift) {
  vec4 visible = vec4(0.0);
  vec2 all = vec2(0.0);
  for (int i = 0; i < kBlockCells; ++i) {
    uint word = map + 4 * uint(row + i), x = uint(column), bits = mapAt(word + x / 32) >> (x % 32);
    if (x % 32 > 32 - 9) bits |= mapAt(word + (x / 32 + 1) % 4) << (32 - x % 32);
    float middle = (float(row + i) + 0.5) / float(kMapRows), weight = sinPi(min(middle, 1.0 - middle));
    vec2 counts = mix(vec2(bitCount(bits & 0xFu), bitCount(bits & 0xF0u)), vec2(bitCount(bits & 0x1Eu), bitCount(bits & 0x1E0u)), shift);
    vec2 upper = vec2(i < kBlockCells / 2, i >= kBlockCells / 2);
    visible += weight * vec4(upper.x * counts, upper.y * counts);
    all += weight * upper;
  }
  return visible / (float(kBlockCells / 2) * all.xxyy);
}

/// Of all maps.
vec4 visibleQuarters(uvec2 at, FilteredMaps maps) {
  Rectangle block = cellRectangle(at, uvec2(kHorizonCellColumns, kHorizonCellRows) / 2);
  Columns columns = mapColumns(block);
  if ((blocksOf(columns, mapRows(block)) & maps.hiddenBlocks) == uvec4(0)) return vec4(1.0);
  vec4 visible = vec4(0.0);
  for (uint k = 0; k < maps.count; ++k)
    visible += maps.weight[k] * visibleQuarters(maps.map[k], columns.first & (kMapColumns - 1), kBlockCells * int(at.y), columns.start);
  const float kOpen = 1.0 - 1e-5;
  return mix(visible, vec4(1.0), greaterThanEqual(visible, vec4(kOpen)));
}

void addBlock(uvec2 at, GgxLobe lobe, mat3 axes, FilteredMaps maps, inout CellSums sums) {
  vec4 visible = visibleQuarters(at, maps);
  bool open = min(lobe.alpha.x, lobe.alpha.y) >= kMergedFrom && min(min(visible.x, visible.y), min(visible.z, visible.w)) == 1.0;
  for (uint k = 0; k < (open ? 1 : 4); ++k) {
    uvec2 quarter = 2 * at + uvec2(k & 1, k >> 1);
    LightCell cell = open ? loadLightCell(kMomentBlocks, at.y * (kHorizonCellColumns / 2) + at.x)
                          : loadLightCell(kMomentLightCells, quarter.y * kHorizonCellColumns + quarter.x);
    addCell(cell, open ? 1.0 : visible[k], lobe, axes, sums);
  }
}

void addBrightLight(GgxLobe lobe, mat3 axes, FilteredMaps maps, inout CellSums sums) {
  uint end = kMomentBright + 1 + 3 * BOXLIGHT_MOMENT(kMomentBright).x;
  for (uint i = kMomentBright + 1; i < end; i += 3) {
    uvec4 x = BOXLIGHT_MOMENT(i), y = BOXLIGHT_MOMENT(i + 1), z = BOXLIGHT_MOMENT(i + 2);
    Rectangle texel = cellRectangle(uvec2(y.w, z.w), uvec2(kMomentColumns, kMomentRows));
    float visible = lookAt(texel, maps).anyHidden ? filterVisible(texel, maps, maps.count).part : 1.0;
    addCellLight(toMoment(MomentSum(x.xyz, y.xyz, z.xyz)), visible, lobe, axes, sums);
  }
}

/// wide_lobe.h: seeByCells.
ClippedLobe seeByCells(GgxLobe lobe, FilteredMaps maps) {
  const float kFarBelow = -0.3;
  mat3 axes = mat3(turnedToMap(lobe.frame[0]), turnedToMap(lobe.frame[1]), turnedToMap(lobe.frame[2]));
  CellSums sums = CellSums(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
  for (uint i = 0; i < kHorizonCellCount / 4; ++i) {
    uvec2 at = uvec2(i % (kHorizonCellColumns / 2), i / (kHorizonCellColumns / 2));
    if (dot(axes[2], normalize(loadLightCell(kMomentBlocks, i).one)) >= kFarBelow) addBlock(at, lobe, axes, maps, sums);
  }
  addBrightLight(lobe, axes, maps, sums);
  vec3 all = max(sums.all, 1e-30);
  float hidden = clamp(1.0 - strength(sums.direct / all), 0.0, 1.0);
  return ClippedLobe(BOXLIGHT_MOMENT_UNIT * sums.radiance / all, hidden, lobe.frame * (sums.towards * axes) / strength(all));
}

/// wide_lobe.h: seeLobe.
ClippedLobe seeLobe(GgxLobe lobe, FilteredMaps maps, bool wanted) {
  float part = kWide ? clamp((min(lobe.alpha.x, lobe.alpha.y) - kWideFrom) / (kWideTo - kWideFrom), 0.0, 1.0) : 0.0;
  ClippedLobe seen = clipLobe(lobe, maps, wanted && part < 1.0);
  if (!kWide || part == 0.0 || !wanted || maps.count == 0) return seen;
  ClippedLobe cells = seeByCells(lobe, maps);
  return ClippedLobe(mix(seen.radiance, cells.radiance, part), mix(seen.hidden, cells.hidden, part), mix(seen.towards, cells.towards, part));
}

#endif
