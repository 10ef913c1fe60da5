// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_SAT_GLSL
#define BOXLIGHT_SAT_GLSL
// The light's summed-area table: 64-bit sums along each row, then down each column. Integers make the result the same on every
// device, whatever the order; the one float operation before them is a correctly rounded product.

#include "light_source.glsl"

/// Three numbers modulo 2^64.
struct Sum {
  uvec3 low, high;
};

Sum zeroSum() { return Sum(uvec3(0), uvec3(0)); }

Sum add(Sum a, Sum b) {
  uvec3 low = a.low + b.low;
  return Sum(low, a.high + b.high + uvec3(lessThan(low, b.low)));
}

/// Radiance times solid angle in whole units.
Sum toUnits(vec3 radiance, float rowFactor) {
  precise vec3 value = radiance * rowFactor;
  precise vec3 top = floor(value * (1.0 / 4294967296.0));
  precise vec3 rest = value - top * 4294967296.0;
  return Sum(uvec3(rest), uvec3(top));
}

RowSum packSum(Sum s) { return RowSum(uint[3](s.low.x, s.low.y, s.low.z), uint[3](s.high.x, s.high.y, s.high.z)); }
Sum unpackSum(RowSum s) { return Sum(uvec3(s.low[0], s.low[1], s.low[2]), uvec3(s.high[0], s.high[1], s.high[2])); }

#endif
