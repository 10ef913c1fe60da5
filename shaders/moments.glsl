// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_MOMENTS_GLSL
#define BOXLIGHT_MOMENTS_GLSL
// The evaluation of cosine boxes, for any renderer: docs/integration.md. It is included after boxlight.glsl and the constants of the
// moments in shared.h; these say where the moments lie (runtime/light/moment_pass.h):
//
//   BOXLIGHT_MOMENT(i)    uvec4, entry i of the moments
//   BOXLIGHT_MOMENT_UNIT  float, radiance times steradian of 1 in them

/// int L w dw of R, G and B, a component of w each.
struct Moment {
  vec3 x, y, z;
};

/// n.w in place of w.
vec3 along(Moment m, vec3 normal) { return normal.x * m.x + normal.y * m.y + normal.z * m.z; }

Moment scaled(vec3 factor, Moment m) { return Moment(factor * m.x, factor * m.y, factor * m.z); }

Moment plus(Moment a, Moment b) { return Moment(a.x + b.x, a.y + b.y, a.z + b.z); }

/// About +Y, by a small angle that phi grows by.
Moment turned(Moment m, float angle) {
  float c = 1.0 - 0.5 * angle * angle;
  return Moment(c * m.x - angle * m.z, m.y, c * m.z + angle * m.x);
}

/// A direction of the world as the light map has it, and back.
vec3 turnedToMap(vec3 d) {
  vec2 turn = sinCosTurn(BOXLIGHT_LIGHT_OFFSET - floor(BOXLIGHT_LIGHT_OFFSET + 0.5));
  return vec3(turn.y * d.x - turn.x * d.z, d.y, turn.x * d.x + turn.y * d.z);
}

Moment turnedToWorld(Moment m) {
  vec2 turn = sinCosTurn(BOXLIGHT_LIGHT_OFFSET - floor(BOXLIGHT_LIGHT_OFFSET + 0.5));
  return Moment(turn.y * m.x + turn.x * m.z, m.y, turn.y * m.z - turn.x * m.x);
}

/// Sums modulo 2^32.
struct MomentSum {
  uvec3 x, y, z;
};

MomentSum subtract(MomentSum a, MomentSum b) { return MomentSum(a.x - b.x, a.y - b.y, a.z - b.z); }

Moment toMoment(MomentSum s) { return Moment(vec3(ivec3(s.x)), vec3(ivec3(s.y)), vec3(ivec3(s.z))); }

MomentSum loadMoment(uint x, uint row) {
  uint i = 3 * (row * kMomentStride + x);
  return MomentSum(BOXLIGHT_MOMENT(i).xyz, BOXLIGHT_MOMENT(i + 1).xyz, BOXLIGHT_MOMENT(i + 2).xyz);
}

/// What lies left of lattice column x between two rows, x up to two periods.
MomentSum momentsLeftOf(uint x, uvec2 rows) {
  MomentSum sum = subtract(loadMoment(min(x, kMomentColumns), rows.y), loadMoment(min(x, kMomentColumns), rows.x));
  if (x <= kMomentColumns) return sum;
  uint rest = min(x - kMomentColumns, kMomentColumns);
  MomentSum more = subtract(loadMoment(rest, rows.y), loadMoment(rest, rows.x));
  return MomentSum(sum.x + more.x, sum.y + more.y, sum.z + more.z);
}

/// light_moments.h: integrate, in the light map's directions. Parts of a texel are turned to where they lie in it.
Moment integrateMoments(float u, float du, uvec2 rows) {
  const float kTexel = 2.0 * kPi / float(kMomentColumns);
  float start = fract(u + BOXLIGHT_LIGHT_OFFSET) * float(kMomentColumns);
  Span columns = makeSpan(start, du * float(kMomentColumns), kMomentColumns);
  uint edge = columns.first + 1 + columns.middle;
  MomentSum a = momentsLeftOf(columns.first, rows), b = momentsLeftOf(columns.first + 1, rows);
  MomentSum c = momentsLeftOf(edge, rows), d = momentsLeftOf(edge + 1, rows);
  float firstShift = start - float(columns.first) + 0.5 * columns.firstPart - 0.5;
  Moment first = turned(toMoment(subtract(b, a)), kTexel * firstShift);
  Moment last = turned(toMoment(subtract(d, c)), kTexel * (0.5 * columns.lastPart - 0.5));
  Moment sum = plus(toMoment(subtract(c, b)), scaled(vec3(columns.firstPart), first));
  return scaled(vec3(BOXLIGHT_MOMENT_UNIT), plus(sum, scaled(vec3(columns.lastPart), last)));
}

/// light_moments.h: Hemisphere, in the light map's directions.
struct Hemisphere {
  vec3 irradiance;
  Moment moment;
};

/// Of each channel, if it lies above the horizon.
Hemisphere partAbove(Moment moment, vec3 normal) {
  vec3 irradiance = along(moment, normal), above = vec3(greaterThan(irradiance, vec3(0.0)));
  return Hemisphere(above * irradiance, scaled(above, moment));
}

void addBrightTexels(vec3 normal, inout Hemisphere sum) {
  uint end = kMomentBright + 1 + 3 * BOXLIGHT_MOMENT(kMomentBright).x;
  for (uint i = kMomentBright + 1; i < end; i += 3) {
    MomentSum texel = MomentSum(BOXLIGHT_MOMENT(i).xyz, BOXLIGHT_MOMENT(i + 1).xyz, BOXLIGHT_MOMENT(i + 2).xyz);
    Hemisphere seen = partAbove(toMoment(texel), normal);
    sum.irradiance += seen.irradiance;
    sum.moment = plus(sum.moment, seen.moment);
  }
}

Hemisphere hemisphereAbove(vec3 normal) {
  float around = normal.xz == vec2(0.0) ? 0.0 : atan(normal.z, normal.x);
  vec2 at = vec2(0.5 + around / (2.0 * kPi), atan(length(normal.xz), normal.y) / kPi);
  vec2 cell = vec2(fract(at.x) * float(kHorizonColumns), at.y * float(kHorizonRows - 1));
  uvec2 first = min(uvec2(cell), uvec2(kHorizonColumns - 1, kHorizonRows - 2));
  vec2 part = cell - vec2(first);
  Hemisphere sum = Hemisphere(vec3(0.0), Moment(vec3(0.0), vec3(0.0), vec3(0.0)));
  float weight = 0.0;
  for (uint k = 0; k < 4; ++k) {
    uvec2 offset = uvec2(k & 1u, k >> 1);
    vec2 shares = mix(1.0 - part, part, vec2(offset));
    uvec2 node = uvec2((first.x + offset.x) % kHorizonColumns, first.y + offset.y);
    uint i = kMomentNodes + 3 * (node.y * kHorizonColumns + node.x);
    vec4 x = uintBitsToFloat(BOXLIGHT_MOMENT(i)), y = uintBitsToFloat(BOXLIGHT_MOMENT(i + 1));
    vec4 z = uintBitsToFloat(BOXLIGHT_MOMENT(i + 2));
    Moment moment = scaled(vec3(shares.x * shares.y), Moment(x.xyz, y.xyz, z.xyz));
    vec3 nodeNormal = vec3(x.w, y.w, z.w);
    sum.irradiance += along(moment, normal + nodeNormal);
    sum.moment = plus(sum.moment, moment);
    weight += shares.x * shares.y * (1.0 + dot(normal, nodeNormal));
  }
  sum.irradiance /= weight;
  addBrightTexels(normal, sum);
  return Hemisphere(BOXLIGHT_MOMENT_UNIT * sum.irradiance, scaled(vec3(BOXLIGHT_MOMENT_UNIT), sum.moment));
}

/// box.h: isCosineBox.
bool isCosineBox(uvec4 packed) { return packed.w >> 16 == 3; }

/// What cosine boxes return (relight.h: straightRadiance), times pi; its moment in the light map's directions.
struct StraightLight {
  vec3 irradiance;
  Moment moment;
};

/// `normal` as the light map has it.
void addCosineBox(uvec4 packed, vec3 normal, inout StraightLight sum) {
  float amplitude = unpackHalf2x16(packed.z).x;
  Hemisphere seen;
  if (packed.y == 0xFFFFFFFFu) {
    seen = hemisphereAbove(normal);
  } else {
    uvec2 corner = uvec2(packed.x & 0xFFFFu, packed.x >> 16), size = uvec2(packed.y & 0xFFFFu, packed.y >> 16) + 1;
    uvec2 rows = uvec2(corner.y, min(corner.y + size.y, 65536)) / (65536 / kMomentRows);
    seen = partAbove(integrateMoments(float(corner.x) / 65536.0, float(size.x) / 65536.0, rows), normal);
  }
  sum.irradiance += amplitude * seen.irradiance;
  sum.moment = plus(sum.moment, scaled(vec3(amplitude), seen.moment));
}

#endif
