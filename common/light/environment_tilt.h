// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/image/image.h"

namespace CLI {
class App;
}

namespace boxlight {

/// Degrees by which the environment is rolled about +Z and then pitched about +X, both counter-clockwise seen
/// from the axis's tip; `--env-rotation` about +Y comes last, so that it stays an offset in u
/// (light_domain.h) whatever the tilt: R = Ry(rotation) Rx(pitch) Rz(roll).
struct EnvironmentTilt {
  float pitch = 0, roll = 0;
  bool operator==(const EnvironmentTilt&) const = default;
  bool isLevel() const { return pitch == 0.0f && roll == 0.0f; }
};

/// --env-rotation, --env-pitch, --env-roll.
void addTurnOptions(CLI::App& app, float& rotationDegrees, EnvironmentTilt& tilt);

/// From directions under the tilted environment to directions in the image: Rz(-roll) Rx(-pitch).
dmat3 untilt(EnvironmentTilt tilt);
/// From directions of the world: untilt(tilt) Ry(-rotation).
dmat3 worldToEnvironment(EnvironmentTilt tilt, float rotationDegrees);

/// Where a tilted map looks: each of its texels is `samplesPerAxis`^2 directions of equal solid angle, each
/// turned into the image and read in the texel that contains it. Tables hold all that is not a product or a
/// sum, so every device finds the same texels.
struct TiltTables {
  uint32_t samplesPerAxis = 1;
  std::vector<vec2> columns;      ///< cos, sin of phi of each sample column of the map
  std::vector<vec2> rows;         ///< cos, sin of theta of each sample row
  std::vector<vec2> columnEdges;  ///< cos, sin of phi of the left edges of the image's columns
  std::vector<float> rowEdges;    ///< cos theta of the upper edges of the image's rows, and of -Y
};
TiltTables makeTiltTables(uvec2 image, uvec2 map);

/// Radiance above the ceiling, spread over the texels of the tilted map.
struct Highlight {
  uint32_t texel;  ///< y * width + x
  float red, green, blue;
};
struct TiltedLight {
  Rgb ceiling{0.0f};  ///< what the samples read of a texel at most
  std::vector<Highlight> highlights;
};
/// A sun of few texels would keep its energy no better than samples happen to fall on it. What is above a
/// ceiling of 64 times the mean (of the rest) is therefore not sampled: it is cut into small pieces that are
/// put where they belong, with all their energy.
TiltedLight splitHighlights(const Image& environment, uvec2 map, EnvironmentTilt tilt);

/// makeLightMap of an environment that is tilted. A constant environment stays constant; energy is kept
/// exactly above the ceiling, and to the accuracy of samplesPerAxis^2 samples below it.
/// shaders/tilted_map.comp gives the same bits.
Image makeTiltedMap(const Image& environment, uvec2 size, EnvironmentTilt tilt);

}  // namespace boxlight
