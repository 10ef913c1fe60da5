// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// Sixth pass: the moments of the hemispheres above a grid of normals (light_moments.h: makeNodes). The normals stand in the table
// already, as each node's w.
#include "moment_source.glsl"

layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMomentCells) readonly buffer Cells { vec4 cells[]; };
layout(std430, binding = kMomentTable) buffer Table { uvec4 table[]; };

const float kPi = 3.14159265358979;

const float kHorizonBand = 0.2;  // moment_cover.h

void main() {
  uint node = gl_GlobalInvocationID.x, place = kMomentNodes + 3 * node;
  if (node >= kHorizonNodeCount) return;
  vec3 normal = uintBitsToFloat(uvec3(table[place].w, table[place + 1].w, table[place + 2].w));
  vec3 x = vec3(0.0), y = vec3(0.0), z = vec3(0.0);
  vec3 missing = kPi * normal, radiance = vec3(0.0);  // the first of a light of 1
  float weights = 0.0;
  for (uint cell = 0; cell < 3 * kHorizonCellCount; cell += 3) {
    vec4 cx = cells[cell], cy = cells[cell + 1], cz = cells[cell + 2];
    vec4 cosines = normal.x * cx + normal.y * cy + normal.z * cz;
    vec3 seen = vec3(greaterThan(cosines.xyz, vec3(0.0))), one = vec3(cx.w, cy.w, cz.w);
    x += seen * cx.xyz;
    y += seen * cy.xyz;
    z += seen * cz.xyz;
    missing -= cosines.w > 0.0 ? one : vec3(0.0);
    float square = dot(one, one), weight = max(1.0 - cosines.w * cosines.w / (kHorizonBand * kHorizonBand * square), 0.0);
    radiance += weight * inversesqrt(square) * (one.x * cx.xyz + one.y * cy.xyz + one.z * cz.xyz);
    weights += weight * sqrt(square);
  }
  radiance /= weights;
  table[place].xyz = floatBitsToUint(x + missing.x * radiance);
  table[place + 1].xyz = floatBitsToUint(y + missing.y * radiance);
  table[place + 2].xyz = floatBitsToUint(z + missing.z * radiance);
}
