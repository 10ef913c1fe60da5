// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "common/asset/asset_reader.h"
#include "common/light/box.h"
#include "runtime/app/frame.h"

namespace boxlight {

/// A box of one kernel: stream, record, slot.
using KernelSource = std::function<Box(uint32_t, uint32_t, uint32_t)>;

/// The same, for slots that are no boxes.
using PackedSource = std::function<PackedBox(uint32_t, uint32_t, uint32_t)>;

/// Written by the shipped writer and opened by the shipped reader.
asset::AssetReader writeSynthetic(const std::filesystem::path& path, const asset::Asset& asset,
                                  const PackedSource& kernel);

/// Puts all records into tiles whose kernels have that many boxes, gloss for the views of each record's
/// hemisphere (with direction cells: for all cells).
void tileRecords(asset::Asset& asset, uint32_t glossyBoxes, uint32_t diffuseBoxes);

/// The square [-1,1]^2 of the plane y = 0, front up, whose atlas covers it once: atlas texel (i, j) is the
/// part around x = (2 i + 1) / n - 1, z = (2 j + 1) / n - 1. Records are the front of every texel row by row,
/// then, if `twoSided`, the back.
struct Square {
  uint32_t atlasEdge = 8;
  bool twoSided = false;
  uint32_t diffuseBoxes = 1, glossyBoxes = 0;
  uint32_t viewFrequency = 3;
  asset::Material material;  ///< Lambert with factor 1 (specular 0) unless changed
  /// If not empty, the square is cut into cellEdge^2 cells, row by row of z, with these in place of
  /// `material`.
  std::vector<asset::Material> cells;
  uint32_t cellEdge = 1;
  std::vector<asset::MaterialExtension> extensions;
  std::vector<asset::TextureTransform> transforms;
  std::vector<asset::Texture> textures;
  std::vector<uint32_t> texels;
  /// If set, every record's lobe is split, with this map: slots of kernels are a hidden part, then boxes.
  std::function<VisibilityMap(uint32_t record)> visibility;
  /// If not 0, these records store their hidden parts in direction cells of a sphere of this frequency.
  uint32_t directionCells = 0;

  Square();
  asset::Asset makeAsset() const;
  asset::AssetReader write(const std::filesystem::path& path, const KernelSource& kernel) const;
};

/// A device with the validation layer on, for one test. finish() closes it and fails the test if the layer
/// said anything.
class GpuTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  std::filesystem::path file(const char* name) const;  ///< in this test's own folder

  std::unique_ptr<gpu::Device> device_;

 private:
  std::filesystem::path folder_;
};

Image constantEnvironment(uvec2 size, Rgb radiance);
/// Noise up to 2, and one texel of `sun`.
Image noisyMap(uvec2 size, float sun);
/// +X red, -X green, +Y blue, -Y yellow, +Z magenta, -Z cyan: each direction has the colour of its largest
/// component.
Image axesEnvironment(uvec2 size);
Rgb axesColor(vec3 direction);

/// Straight down at the square, which fills the picture exactly.
Camera cameraAbove(uint32_t edge);

}  // namespace boxlight
