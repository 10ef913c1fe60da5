// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_FRAME_GLSL
#define BOXLIGHT_FRAME_GLSL

#include "shared.h"

layout(std430, binding = kBindFrame) readonly buffer Frame { FrameConstants frame; };
layout(std430, binding = kBindTables) readonly buffer Tables { float tables[]; };
layout(binding = kBindTableTexels) uniform samplerBuffer tableTexels;

layout(constant_id = kConstantTexelBuffers) const bool kTexelBuffers = true;
layout(constant_id = kConstantLevels) const bool kLevels = true;

float tableAt(uint i) { return kTexelBuffers ? texelFetch(tableTexels, int(i)).x : tables[i]; }

/// In the shaded records: channel c of a record's gradient.
uint gradientIndex(uint record, uint c) { return kShadedRadiances * frame.recordCount + kShadedGradients * record + c; }

#endif
