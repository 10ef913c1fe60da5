// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Second half, kSegments threads a column: each sums its segment, then goes through it once more from the sum of those above.
#include "sat_columns.glsl"

const uint kColumns = kGroupSize / kSegments;
layout(local_size_x = kColumns, local_size_y = kSegments) in;
shared Sum totals[kSegments][kColumns];

void main() {
  uint x = gl_GlobalInvocationID.x, segment = gl_LocalInvocationID.y;
  uint rows = (source.mapSize.y + kSegments - 1) / kSegments;
  uint first = min(segment * rows, source.mapSize.y), end = min(first + rows, source.mapSize.y);
  bool inside = x <= source.mapSize.x;
  Sum sum = zeroSum();
  if (inside)
    for (uint y = first; y < end; ++y) sum = add(sum, rowSum(x, y));
  totals[segment][gl_LocalInvocationID.x] = sum;
  barrier();
  if (!inside) return;
  sum = zeroSum();
  for (uint above = 0; above < segment; ++above) sum = add(sum, totals[above][gl_LocalInvocationID.x]);
  if (segment == 0) store(x, 0, sum);
  for (uint y = first; y < end; ++y) {
    sum = add(sum, rowSum(x, y));
    store(x, y + 1, sum);
  }
}
