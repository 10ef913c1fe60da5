// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_GLSL
#define BOXLIGHT_GLSL
// The evaluation of boxes under a distant light, for any renderer: docs/integration.md. It needs GLSL 4.5 and includes nothing.
// Before it is included, these say where the light's table lies (runtime/light):
//
//   BOXLIGHT_LIGHT_SIZE         uvec2, texels of the light map
//   BOXLIGHT_LIGHT_UNIT         float, radiance times steradian of 1 in the table
//   BOXLIGHT_LIGHT_OFFSET       float in [0, 1), the environment's rotation in turns
//   BOXLIGHT_COMPACT_ENTRY(i)   uvec4, entry i of a table of 42-bit prefixes
//   BOXLIGHT_EXACT_ENTRY(i, c)  uvec2, low and high word of channel c in entry i of a table of 64-bit prefixes
//   BOXLIGHT_EXACT              bool, a constant: which of the two there is; without it, the first

#ifndef BOXLIGHT_EXACT
#define BOXLIGHT_EXACT false
#define BOXLIGHT_EXACT_ENTRY(i, c) uvec2(0)
#endif

const float kPi = 3.14159265358979;

/// sin(pi x) for x in [0, 1/2] to a relative 2e-7, also at 0: Taylor series. Vulkan promises no more than 2^-11 of its own sin,
/// of which nothing would be left for a box at a pole.
float sinPi(float x) {
  float a = kPi * x, s = a * a;
  float series = 1.0 / 362880.0 - s * (1.0 / 39916800.0);
  series = 1.0 / 5040.0 - s * series;
  series = 1.0 / 120.0 - s * series;
  series = 1.0 / 6.0 - s * series;
  return a - a * s * series;
}

float cosPi(float x) { return x <= 0.5 ? sinPi(0.5 - x) : -sinPi(x - 0.5); }  // x in [0, 1]

/// The extent of a rectangle in v: upper edge, height, and what is left below the lower edge. The three sum to 1; the last is kept
/// because 1 - v - height would have no digits near the south pole.
struct Latitudes {
  float v, height, below;
};

/// cos(pi v) - cos(pi (v + height)) as a product, which keeps its digits for thin rectangles and at both poles.
float cosineDifference(Latitudes l) {
  return 2.0 * sinPi(min(min(l.v, l.below) + 0.5 * l.height, 0.5)) * sinPi(0.5 * l.height);
}

/// Steradians.
float solidAngle(float du, Latitudes l) { return 2.0 * kPi * du * cosineDifference(l); }

/// Three numbers modulo 2^42, low words and high parts of which the lowest 10 bits count, or modulo 2^64.
struct Wide {
  uvec3 low, high;
};

Wide loadPrefix(uint index) {
  if (BOXLIGHT_EXACT) {
    uvec2 r = BOXLIGHT_EXACT_ENTRY(index, 0), g = BOXLIGHT_EXACT_ENTRY(index, 1), b = BOXLIGHT_EXACT_ENTRY(index, 2);
    return Wide(uvec3(r.x, g.x, b.x), uvec3(r.y, g.y, b.y));
  }
  uvec4 packed = BOXLIGHT_COMPACT_ENTRY(index);
  return Wide(packed.xyz, uvec3(packed.w, packed.w >> 10, packed.w >> 20));
}

Wide add(Wide a, Wide b) {
  uvec3 low = a.low + b.low;
  return Wide(low, a.high + b.high + uvec3(lessThan(low, b.low)));
}

Wide subtract(Wide a, Wide b) { return Wide(a.low - b.low, a.high - b.high - uvec3(lessThan(a.low, b.low))); }

/// Prefixes of 42 bits are rounded one by one, so that a difference may be as low as -2: it is decoded from there.
vec3 toFloat(Wide a) {
  if (BOXLIGHT_EXACT) return vec3(a.high) * 4294967296.0 + vec3(a.low);
  uvec3 low = a.low + 2u;
  return vec3((a.high + uvec3(lessThan(low, uvec3(2u)))) & 1023u) * 4294967296.0 + (vec3(low) - 2.0);
}

/// The prefix at lattice column x of the row that starts at `base`, x up to two periods.
Wide prefixAt(uint base, uint x) {
  uint width = BOXLIGHT_LIGHT_SIZE.x;
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
  uint base = row * (BOXLIGHT_LIGHT_SIZE.x + 1), edge = columns.first + 1 + columns.middle;
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
  uvec2 size = BOXLIGHT_LIGHT_SIZE;
  float height = float(size.y);
  Span columns = makeSpan(fract(u + BOXLIGHT_LIGHT_OFFSET) * float(size.x), du * float(size.x), size.x);
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
  return sum * BOXLIGHT_LIGHT_UNIT;
}

/// box.h.
struct Box {
  float u, du;
  Latitudes latitudes;
  vec3 energy;
};

Box unpackBox(uvec4 packed) {
  uvec2 corner = uvec2(packed.x & 0xFFFFu, packed.x >> 16), size = uvec2(packed.y & 0xFFFFu, packed.y >> 16) + 1;
  size.y = min(size.y, 65536 - corner.y);
  Latitudes latitudes = Latitudes(float(corner.y), float(size.y), float(65536 - corner.y - size.y));
  latitudes = Latitudes(latitudes.v / 65536.0, latitudes.height / 65536.0, latitudes.below / 65536.0);
  vec3 energy = vec3(unpackHalf2x16(packed.z), unpackHalf2x16(packed.w).x);
  return Box(float(corner.x) / 65536.0, float(size.x) / 65536.0, latitudes, energy);
}

/// box.h: isEmission, unpackEmission.
bool isEmission(uvec4 packed) { return packed.w >> 16 == 1; }

vec3 unpackEmission(uvec4 packed) {
  int exponent = clamp(int(packed.y & 0xFFFFu) - 32768, -126, 128);
  return ldexp(vec3(unpackHalf2x16(packed.z), unpackHalf2x16(packed.w).x), ivec3(exponent));
}

/// box.h: unpackHiddenPart.
float unpackHiddenPart(uvec4 packed) { return unpackHalf2x16(packed.z).x; }

bool isEmpty(Box box) { return all(equal(box.energy, vec3(0.0))); }

vec3 boxWeight(Box box) { return box.energy / solidAngle(box.du, box.latitudes); }

/// sin(2 pi x) and cos(2 pi x) for x in [-1/2, 1/2].
vec2 sinCosTurn(float x) {
  float half_turns = 2.0 * abs(x), s = sinPi(min(half_turns, 1.0 - half_turns));
  return vec2(x < 0.0 ? -s : s, cosPi(half_turns));
}

/// The mean of shifts on the circle, in turns; 0 where they cancel out.
float meanShift(vec3 shift, vec3 share) {
  vec2 sum = share.x * sinCosTurn(shift.x) + share.y * sinCosTurn(shift.y) + share.z * sinCosTurn(shift.z);
  if (sum == vec2(0.0)) return 0.0;
  // An atan of 1e-5, as Mesa's, would be half of a sharp box; a step of Newton's mends it.
  float mean = clamp(atan(sum.x, sum.y) / (2.0 * kPi), -0.5, 0.5);
  vec2 at = sinCosTurn(mean);
  return mean + (sum.x * at.y - sum.y * at.x) / (2.0 * kPi * length(sum));
}

/// relight.h: interpolateBoxes, whose energy becomes weights where `interpolateWeight` says so.
Box interpolateBoxes(Box a, Box b, Box c, vec3 weight, bool interpolateWeight) {
  vec3 g = weight * vec3(!isEmpty(a), !isEmpty(b), !isEmpty(c));
  float total = g.x + g.y + g.z;
  if (total <= 0.0) return Box(0.0, 1.0, Latitudes(0.0, 1.0, 0.0), vec3(0.0));
  vec3 du = vec3(a.du, b.du, c.du);
  Box result;
  result.du = min(dot(g, du) / total, 1.0);
  result.latitudes.v = dot(g, vec3(a.latitudes.v, b.latitudes.v, c.latitudes.v)) / total;
  result.latitudes.height = dot(g, vec3(a.latitudes.height, b.latitudes.height, c.latitudes.height)) / total;
  result.latitudes.below = dot(g, vec3(a.latitudes.below, b.latitudes.below, c.latitudes.below)) / total;

  vec3 centres = vec3(a.u, b.u, c.u) + 0.5 * du;
  vec3 h = g * vec3(lessThan(du, vec3(1.0)));  // a full ring has no centre
  bool centred = h.x + h.y + h.z > 0.0;
  float reference = h.x > 0.0 ? centres.x : h.y > 0.0 ? centres.y : centres.z;
  vec3 shift = centres - reference;
  shift -= floor(shift + 0.5);
  result.u = centred ? fract(reference + meanShift(shift, h) - 0.5 * result.du) : 0.0;

  result.energy = interpolateWeight
                      ? weight.x * boxWeight(a) + weight.y * boxWeight(b) + weight.z * boxWeight(c)
                      : weight.x * a.energy + weight.y * b.energy + weight.z * c.energy;
  return result;
}

/// view_sphere.h: raiseAboveHorizon, for directions that are not exactly opposite to the normal.
vec3 raiseAboveHorizon(vec3 direction, vec3 normal, float cosine) {
  float current = dot(direction, normal);
  if (current >= cosine) return direction;
  vec3 along = direction - current * normal;
  along /= max(length(along), 1e-6);
  return normalize(cosine * normal + sqrt(1.0 - cosine * cosine) * along);
}

#endif
