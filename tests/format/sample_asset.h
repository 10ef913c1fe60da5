// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "common/asset/asset_writer.h"

namespace boxlight::asset {

/// A small valid asset in which every field has a value of its own, made without a bake.
struct Sample {
  Asset asset;
  std::vector<std::vector<PackedBox>> pages;  ///< [stream * tileCount + tile]

  PageSource source() const;
  void write(const std::filesystem::path& path) const { writeAsset(path, asset, source()); }
};

struct SampleSize {
  uint32_t viewFrequency = 1;
  uint32_t records = 5;
  uint32_t recordsPerTile = 3;
  bool extensions = true;  ///< what format 1.1 added; without, the content is that of version-1.0.ptb
  bool split = false;      ///< what format 1.2 added: of three records, the first and the third are split
  bool cells = false;      ///< what format 1.3 added, with `split`: the first of three has direction cells
  bool cosine = false;     ///< what format 1.4 added: one slot in two of Lambert kernels is a cosine box
  bool coarse = false;  ///< what format 1.6 added, of frequency 3: record n has views of sphere n mod 3, and
                        ///< the last records are those of a coarser level of the atlas
};

Sample makeSample(SampleSize size = {});

}  // namespace boxlight::asset
