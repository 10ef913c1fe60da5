// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "common/base/math.h"

namespace boxlight {

/// From linear radiance after exposure to linear display light in [0,1], which encodeSrgb then encodes.
/// shaders/tone_map.glsl has the same curves under the same numbers.
///
///   none      clamped to 1: a pixel below white can be read back
///   reinhard  c / (1 + c) of each channel: Reinhard et al., "Photographic Tone Reproduction for Digital
///             Images", SIGGRAPH 2002, Equation 3
///   aces      c (2.51 c + .03) / (c (2.43 c + .59) + .14) of each channel: K. Narkowicz's fit of the ACES
///             reference curve, "ACES Filmic Tone Mapping Curve", 2015
///   neutral   colours below .8 stay but for the dielectric's own reflection, brighter ones run to white
///             within their hue: Khronos, "PBR Neutral Tone Mapper", 2024
enum class ToneMap : unsigned { none, reinhard, aces, neutral };

/// By number: what options and files call them.
inline constexpr std::array<const char*, 4> kToneMapNames = {"none", "reinhard", "aces", "neutral"};

/// NaN and negative channels become 0, infinite ones white.
Rgb applyToneMap(ToneMap map, Rgb radiance);

}  // namespace boxlight
