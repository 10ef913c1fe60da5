// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "bake/scene/material.h"
#include "bake/scene/scene.h"

namespace boxlight {

/// A triangle of surface inside one atlas texel: the part of a scene triangle that the texel's square cuts
/// out, as a fan.
struct FootprintPiece {
  uint32_t triangle;
  vec2 corner[3];  ///< barycentric coordinates (second, third vertex) in the scene triangle
  float area;      ///< world-space area up to and including this piece, running sum over the texel
};

/// One texel of the atlas and the surface it covers.
struct Texel {
  uint32_t x, y;
  uint32_t firstPiece, pieceCount;
};

/// The covered texels of an atlas, in blocks of 8x8 so that neighbours in the list are neighbours in the
/// atlas.
struct TexelMap {
  uint32_t width = 0, height = 0;
  std::vector<Texel> texels;
  std::vector<FootprintPiece> pieces;
  /// Per atlas texel, the index into `texels` of itself or, in the gutter, of the nearest covered texel;
  /// asset::kNone elsewhere.
  std::vector<uint32_t> nearest;
  /// Levels 1, 2, ... of the same surface, each of half the texels each way; they have none of their own.
  std::vector<TexelMap> coarser;

  const TexelMap& level(uint32_t level) const { return level == 0 ? *this : coarser[level - 1]; }
  std::span<const FootprintPiece> footprint(const Texel& texel) const {
    return std::span(pieces).subspan(texel.firstPiece, texel.pieceCount);
  }
};

inline constexpr int kGutterTexels = 4;  ///< how far coverage is dilated, in texels

/// Clips every triangle's atlas UVs (Vertex::atlasUv) to the texel grid. Atlas row 0 is v = 0, as in glTF's
/// images.
TexelMap makeTexels(const Scene& scene, uint32_t width, uint32_t height);

/// The point of the texel's surface at `sample` in [0,1)^2, uniform in world-space area: stratified samples
/// give stratified points.
SurfacePoint sampleFootprint(std::span<const FootprintPiece> footprint, vec2 sample);

}  // namespace boxlight
