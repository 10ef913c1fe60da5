// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "common/image/image.h"

namespace boxlight {

/// How far a picture x is from its reference r. Measured over the object pixels: those with alpha above .5 in
/// the reference or, if it has no alpha, all. Means run over pixels and R, G, B; values are linear radiance
/// unless said otherwise.
struct ImageMetrics {
  double rmse = 0;         ///< sqrt(mean (x - r)^2)
  double relMse = 0;       ///< mean (x - r)^2 / (r^2 + .01), as in Rousselle et al. 2011
  double trimmedRmse = 0;  ///< rmse without the worst .1 % of the pixels (rounded down)
  double rmse8 = 0;  ///< rmse in 8-bit steps: both clamped to [0,1], sRGB-encoded, times 255 (not rounded)
  double psnr = 0;   ///< dB, 20 log10(255 / rmse8); infinite if equal
  double flip = 0;   ///< mean of flipMap (flip.h) over the measured pixels, 0 to 1
  double bias = 0;   ///< mean(x - r) / mean(r); 0 if both are black
  double alphaRmse = 0;  ///< of coverage, over all pixels; an image without alpha covers everything
  double mean = 0, referenceMean = 0;
  uint64_t pixels = 0;     ///< measured
  uint64_t allPixels = 0;  ///< of the picture
  bool byAlpha = false;    ///< were pixels chosen by the reference's alpha?
};

/// Errors: ExitCode::invalidInput if the sizes differ, if a measured pixel of either is NaN or Inf (named),
/// if none is measured.
ImageMetrics compareImages(const Image& image, const Image& reference);

/// The largest difference of the three channels in 8-bit steps s (as for rmse8), drawn as log2(1 + s) / 6:
/// black is equal, each sixth of the way to white doubles the difference, white is 63 steps or more. Colours
/// are those of Green's cubehelix, whose brightness rises steadily. Pixels that are not measured are
/// transparent. The result is display-encoded, ready for a PNG.
Image falseColourDifference(const Image& image, const Image& reference);

/// Point t of [0,1] of the colour map, display-encoded. D. A. Green, "A colour scheme for the display of
/// astronomical intensity images", Bull. Astr. Soc. India 39, 2011: start .5, rotations -1.5, hue 1, gamma 1.
Rgb cubehelix(float t);

}  // namespace boxlight
