// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "common/base/math.h"

namespace boxlight {

/// One box of Equation 2: constant inside a phi-theta rectangle of the light domain, zero outside.
struct Box {
  float u0 = 0;  ///< left edge, [0,1); the box may wrap over u = 1
  float v0 = 0;  ///< upper edge, [0,1]
  float du = 0;  ///< width in u, (0,1]; 1 is a full ring
  float dv = 0;  ///< height in v, (0,1]; v0 + dv <= 1
  Rgb energy{
      0.0f};  ///< w * Omega per channel: what the box returns under a constant environment of radiance 1

  double solidAngle() const;  ///< steradians, by rectangleSolidAngle
  Rgb weight() const;         ///< w = energy / solidAngle; 0 for an empty box
};

/// PackedBox::kind.
inline constexpr uint16_t kLightBox = 0;
inline constexpr uint16_t kEmittedRadiance = 1;  ///< not a box: radiance that does not depend on the light
inline constexpr uint16_t kHiddenPart = 2;  ///< not a box: how much of a split lobe the kernel stands for
inline constexpr uint16_t kCosineBox = 3;   ///< of light that reaches a Lambert surface straight

/// A box as it stands in decoded asset pages and in storage buffers: 16 bytes, four little-endian 32-bit
/// words in GLSL. Normative in docs/format.md, section "Box".
struct PackedBox {
  uint16_t u0 = 0, v0 = 0;  ///< edge = code / 65536
  uint16_t du = 0,
           dv = 0;  ///< size = (code + 1) / 65536: never zero, and 65535 reaches a full ring or both poles
  uint16_t energy[3] = {0, 0, 0};  ///< IEEE half floats; all zero in an empty box
  uint16_t kind = 0;               ///< kLightBox, kEmittedRadiance, kHiddenPart or kCosineBox
};
static_assert(sizeof(PackedBox) == 16);

/// Rounds the edges to the nearest code and the energy to nine significant bits, as RGB9E5 gives its largest
/// channel. A moved edge costs no energy (Omega compensation).
PackedBox packBox(const Box& box);
Box unpackBox(const PackedBox& packed);

/// Radiance that a kernel returns whatever the light is: what emitters of the scene send by way of the texel.
/// A kernel with such a slot has it first. radiance = energy * 2^(du - 32768): half floats alone end at
/// 65504.
PackedBox packEmission(Rgb radiance);
Rgb unpackEmission(const PackedBox& packed);
inline bool isEmission(const PackedBox& packed) { return packed.kind == kEmittedRadiance; }

/// The part of a lobe's energy that points at other surfaces, [0,1] but for noise; the kernel's boxes are
/// what arrives from there. Kernels of records with asset::kSplitLobe have such a slot before their boxes.
PackedBox packHiddenPart(float part);
float unpackHiddenPart(const PackedBox& packed);
inline bool isHiddenPart(const PackedBox& packed) { return packed.kind == kHiddenPart; }

/// A part of the light that reaches a Lambert surface of unit normal n straight, for kernels that do not
/// depend on the view: amplitude * max(n.w, 0) / pi inside the box, zero outside. The whole sphere is the
/// hemisphere above the surface, what amplitude 1 returns 1 for under a constant light.
struct CosineBox {
  Box box;              ///< edges in v are multiples of 1/128; its energy means nothing
  float amplitude = 0;  ///< of either sign: a box may take away what another has

  bool isWhole() const { return box.du >= 1.0f && box.dv >= 1.0f; }
};

inline constexpr uint32_t kCosineRaster = 512;  ///< of 65536: what v0 and v0 + dv are multiples of

PackedBox packCosineBox(const CosineBox& box);
CosineBox unpackCosineBox(const PackedBox& packed);
inline bool isCosineBox(const PackedBox& packed) { return packed.kind == kCosineBox; }

}  // namespace boxlight
