// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_LIGHT_GLSL
#define BOXLIGHT_LIGHT_GLSL

#include "frame.glsl"

// The table of the light, one of two kinds.
layout(constant_id = kConstantExactSums) const bool kExactSums = false;
layout(std430, binding = kBindSummedArea) readonly buffer CompactTable { uvec4 compactTable[]; };
layout(std430, binding = kBindSummedArea) readonly buffer ExactTable { uvec2 exactTable[]; };
layout(binding = kBindLightTexels) uniform usamplerBuffer lightTexels;  // of a compact one

#define BOXLIGHT_LIGHT_SIZE frame.lightSize
#define BOXLIGHT_LIGHT_UNIT frame.lightUnit
#define BOXLIGHT_LIGHT_OFFSET frame.lightOffset
#define BOXLIGHT_COMPACT_ENTRY(i) (kTexelBuffers ? texelFetch(lightTexels, int(i)) : compactTable[i])
#define BOXLIGHT_EXACT_ENTRY(i, c) exactTable[3 * (i) + (c)]
#define BOXLIGHT_EXACT kExactSums
#include "boxlight.glsl"

layout(std430, binding = kBindMoments) readonly buffer Moments { uvec4 moments[]; };
layout(binding = kBindMomentTexels) uniform usamplerBuffer momentTexels;

#define BOXLIGHT_MOMENT(i) (kTexelBuffers ? texelFetch(momentTexels, int(i)) : moments[i])
#define BOXLIGHT_MOMENT_UNIT frame.momentUnit
#include "moments.glsl"

#endif
