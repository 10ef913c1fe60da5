// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_LAYERS_GLSL
#define BOXLIGHT_LAYERS_GLSL

#include "tile.glsl"

// The blended triangles between the eye and the opaque one of every sample, front to back. A sample's layers end with the first that
// has no triangle.

layout(constant_id = kConstantLayers) const uint kLayers = 0;
#ifndef LAYERS_ACCESS
#define LAYERS_ACCESS readonly
#endif
layout(std430, binding = kBindLayers) LAYERS_ACCESS buffer Layers {
  LayerHeader layerHeader;
  uvec2 layers[];
};

uint tileSamples() { return tile.size.x * tile.size.y * frame.samples * frame.samples; }

/// Triangle + 1, or 0, and the bits of its alpha.
uvec2 loadLayer(uint layer, uint sampleOfTile) { return layers[layer * tileSamples() + sampleOfTile]; }

/// Layers to look at, in a shader that is told how many there are.
uint layerCount() { return min(kLayers, layersDrawn); }

bool sameLayers(uint a, uint b) {
  for (uint layer = 0; layer < layerCount(); ++layer) {
    uint triangle = loadLayer(layer, a).x;
    if (triangle != loadLayer(layer, b).x) return false;
    if (triangle == 0) break;
  }
  return true;
}

#endif
