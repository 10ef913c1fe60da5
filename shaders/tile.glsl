// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_TILE_GLSL
#define BOXLIGHT_TILE_GLSL

#include "frame.glsl"

/// TilePush.
layout(push_constant) uniform Push {
  ImageTile tile;
  uint layersDrawn;
  uint firstRow;
};

#endif
