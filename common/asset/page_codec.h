// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "common/asset/frame_codec.h"
#include "common/light/box.h"

// How the boxes of a page are laid out before they are compressed (docs/format.md, "Planes"): byte by byte
// instead of box by box, each byte of all boxes of a slot in a row, edges and energies turned so that the
// zeros of a raster and of rounding come together. Lossless for any box.

namespace boxlight::asset {

/// `boxes`: whole kernels of `slots` > 0 boxes, one after another. 16 planes of boxes.size() bytes.
std::vector<std::byte> boxesToPlanes(std::span<const PackedBox> boxes, uint32_t slots);

/// The inverse; planes.size() = 16 boxes.size(). With `slots` that do not divide boxes.size(): unspecified
/// boxes, nothing else.
void planesToBoxes(std::span<const std::byte> planes, uint32_t slots, std::span<PackedBox> boxes);

/// The page as it stands in a file, Codec::planes. Valid until the next call of the same compressor. Planes
/// that are alike share a block of the frame, so that each kind has Huffman codes of its own. Bytes a box on
/// baked pages (the demo, 1024 paths): 7.4; in one block 7.5, box by box 9.5.
std::span<const std::byte> compressPage(FrameCompressor& compressor, std::span<const PackedBox> boxes,
                                        uint32_t slots);

}  // namespace boxlight::asset
