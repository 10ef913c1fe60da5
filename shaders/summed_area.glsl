// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_SUMMED_AREA_GLSL
#define BOXLIGHT_SUMMED_AREA_GLSL

#include "light_domain.glsl"

layout(std430, binding = kBindSummedArea) readonly buffer SummedArea { uvec4 summedArea[]; };
layout(binding = kBindLightTexels) uniform usamplerBuffer lightTexels;

/// Three 42-bit numbers: low words, and high parts of which the lowest 10 bits count.
struct Wide {
  uvec3 low, high;
};

Wide loadPrefix(uint index) {
  uvec4 packed = kTexelBuffers ? texelFetch(lightTexels, int(index)) : summedArea[index];
  return Wide(packed.xyz, uvec3(packed.w, packed.w >> 10, packed.w >> 20));
}

Wide add(Wide a, Wide b) {
  uvec3 low = a.low + b.low;
  return Wide(low, a.high + b.high + uvec3(lessThan(low, b.low)));
}

Wide subtract(Wide a, Wide b) { return Wide(a.low - b.low, a.high - b.high - uvec3(lessThan(a.low, b.low))); }

/// As two's complement: prefixes are rounded one by one, so the sum over an empty cell may be -1 or -2.
vec3 toFloat(Wide a) { return vec3(ivec3(a.high << 22) >> 22) * 4294967296.0 + vec3(a.low); }

/// The prefix at lattice column x of the row that starts at `base`, x up to two periods.
Wide prefixAt(uint base, uint x) {
  uint width = frame.lightSize.x;
  if (x <= width) return loadPrefix(base + x);
  return add(loadPrefix(base + min(x - width, width)), loadPrefix(base + width));
}

/// One axis of a rectangle in cells: part of cell `first`, `middle` whole cells, part of the next. Built from the size, not from
/// two edges: the parts add up to the size exactly.
struct Span {
  uint first, middle;
  float firstPart, lastPart;
};

Span makeSpan(float start, float size, uint cells) {
  Span span;
  span.first = min(uint(start), cells - 1);
  span.firstPart = min(1.0 - (start - float(span.first)), size);
  float rest = max(size - span.firstPart, 0.0);
  span.middle = uint(rest);
  span.lastPart = rest - float(span.middle);
  return span;
}

/// Differences across the three column bands of one lattice row.
struct Bands {
  Wide first, middle, last;
};

Bands loadBands(uint row, Span columns) {
  uint base = row * (frame.lightSize.x + 1), edge = columns.first + 1 + columns.middle;
  Wide a = prefixAt(base, columns.first), b = prefixAt(base, columns.first + 1);
  Wide c = prefixAt(base, edge), d = prefixAt(base, edge + 1);
  return Bands(subtract(b, a), subtract(c, b), subtract(d, c));
}

/// Integers are subtracted first and weighted after: a difference of large floats would have no digits left.
vec3 between(Bands above, Bands below, Span columns) {
  return columns.firstPart * toFloat(subtract(below.first, above.first)) +
         toFloat(subtract(below.middle, above.middle)) +
         columns.lastPart * toFloat(subtract(below.last, above.last));
}

/// cosineDifference of a whole row.
float rowCosines(uint row, uint rows) {
  return 2.0 * sinPi((float(min(row, rows - 1 - row)) + 0.5) / float(rows)) * sinPi(0.5 / float(rows));
}

/// Integral of the light map over a rectangle (radiance times steradian), linear in u and in cos(theta) across a row
/// (summed_area.h on the CPU). `omega` is its solid angle, summed over the same pieces, so that their quotient is the exact mean of
/// a constant map.
vec3 integrateLight(float u, float du, Latitudes l, out float omega) {
  uvec2 size = frame.lightSize;
  float height = float(size.y);
  Span columns = makeSpan(fract(u + frame.lightOffset) * float(size.x), du * float(size.x), size.x);
  Span rows = makeSpan(l.v * height, l.height * height, size.y);
  rows.middle = min(rows.middle, size.y - 1 - rows.first);
  uint edge = rows.first + 1 + rows.middle, lastRow = min(edge, size.y - 1);
  if (edge == size.y) rows.lastPart = 0.0;

  float firstHeight = rows.firstPart / height;
  float first = cosineDifference(Latitudes(l.v, firstHeight, l.below + max(l.height - firstHeight, 0.0)));
  float middle = cosineDifference(
      Latitudes(float(rows.first + 1) / height, float(rows.middle) / height, float(size.y - edge) / height));
  float last = cosineDifference(Latitudes(float(lastRow) / height, rows.lastPart / height, l.below));

  Bands r0 = loadBands(rows.first, columns), r1 = loadBands(rows.first + 1, columns);
  Bands r2 = loadBands(edge, columns), r3 = loadBands(lastRow + 1, columns);
  vec3 sum = first / rowCosines(rows.first, size.y) * between(r0, r1, columns) + between(r1, r2, columns);
  if (rows.lastPart > 0.0) sum += last / rowCosines(lastRow, size.y) * between(r2, r3, columns);
  omega = 2.0 * kPi * du * (first + middle + last);
  return sum * frame.lightUnit;
}

#endif
