// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/light_size.h"

#include <algorithm>
#include <vector>

#include "common/light/box.h"
#include "common/light/ggx.h"

namespace boxlight::gpu {
namespace {

constexpr double kLeftOut = 0.05;  // of the energy
constexpr size_t kMostPages = 64;
constexpr double kTexelsPerBox = 2;

struct Extent {
  float size, energy;
};

/// The size that all have but the smallest with kLeftOut of the energy; 1 if there are none.
double percentile(std::vector<Extent>& extents) {
  std::sort(extents.begin(), extents.end(), [](Extent a, Extent b) { return a.size < b.size; });
  double total = 0, sum = 0;
  for (const Extent& e : extents) total += double(e.energy);
  for (const Extent& e : extents)
    if ((sum += double(e.energy)) > kLeftOut * total) return double(e.size);
  return 1;
}

struct Extents {
  std::vector<Extent> widths, heights;
  void add(float width, float height, float energy) {
    widths.push_back({width, energy});
    heights.push_back({height, energy});
  }
};

void addKernels(const asset::AssetReader& reader, Extents& extents) {
  const asset::Asset& asset = reader.asset();
  std::vector<std::pair<uint32_t, uint32_t>> pages;
  for (uint32_t stream = 0; stream < asset.streamCount(); ++stream)
    for (uint32_t tile = 0; tile < asset.tiles.size(); ++tile)
      if (asset.mask(stream, tile) != 0) pages.emplace_back(stream, tile);
  const size_t step = (pages.size() + kMostPages - 1) / kMostPages;
  for (size_t i = 0; i < pages.size(); i += step)
    for (const PackedBox& packed : reader.page(pages[i].first, pages[i].second))
      if (packed.kind == kLightBox) {
        const Box box = unpackBox(packed);
        extents.add(box.du, box.dv, luminance(box.energy));
      }
}

/// The core of 18 boxes of GGX seen from above: its rim is where the distribution of half vectors reaches
/// 1/18, tan = .243 alpha, reflections turn by twice that, and boxes are 1.1 times as wide
/// (common/light/lobe_boxes).
void addLobes(const asset::Asset& asset, Extents& extents) {
  constexpr float kCore = 4 * 0.243f * 1.1f;
  for (uint32_t r = 0; r < asset.records.size(); ++r) {
    if (!asset.isSplit(r)) continue;
    const float angle = std::min(kCore * ggx::alphaOf(asset.records[r].roughness), kPi);
    extents.add(angle / (2 * kPi), angle / kPi, 1);
  }
}

uint32_t texelsFor(double size, uint32_t least, uint32_t most, uint32_t image) {
  uint32_t texels = least;
  while (texels < most && 4 * texels <= image && double(texels) * size < kTexelsPerBox) texels *= 2;
  return texels;
}

}  // namespace

uvec2 chooseLightSize(const asset::AssetReader& reader, uvec2 image) {
  Extents kernels, lobes;
  addKernels(reader, kernels);
  addLobes(reader.asset(), lobes);
  const double width = std::min(percentile(kernels.widths), percentile(lobes.widths)),
               height = std::min(percentile(kernels.heights), percentile(lobes.heights));
  const uint32_t columns = texelsFor(width, kLeastLightSize.x, kMostLightSize.x, image.x),
                 rows = texelsFor(height, kLeastLightSize.y, kMostLightSize.y, image.y);
  return {columns, rows};
}

}  // namespace boxlight::gpu
