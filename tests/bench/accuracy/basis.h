// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bake/transport/paths.h"
#include "tests/bench/accuracy/relative_error.h"

namespace boxlight::accuracy {

/// A way to represent one kernel in a number of bytes, made from its paths alone.
struct Basis {
  std::string name;
  uint32_t terms, bytes;
  /// What the representation returns under every probe light, at the texel's normal. Thread-safe.
  std::function<Radiances(const KernelPaths&, vec3 normal)> relight;
};

inline constexpr uint32_t kBytesOfBox = 12;  ///< 12-bit edges, three half floats

/// Boxes by BoxFitter, packed as in an asset.
Basis boxBasis(const std::vector<ProbeLight>& lights, uint32_t boxes);

/// Of a Lambert kernel: cosine boxes for what arrives straight, boxes for the rest, as a bake makes them.
Basis lambertBasis(const std::vector<ProbeLight>& lights, uint32_t boxes);

/// Real spherical harmonics of the first `bands` bands, half floats (6 bytes for three channels): the
/// projections of the deposits. Ramamoorthi and Hanrahan, SIGGRAPH 2001; Sloan et al., SIGGRAPH 2002.
Basis harmonicBasis(const std::vector<ProbeLight>& lights, uint32_t bands);

/// The largest Haar coefficients on a cube map, 2 bytes of index and 6 of value each, picked by size times
/// the side of the support: what natural lights weigh them by. Ng et al., "All-Frequency Shadows Using
/// Non-linear Wavelet Lighting Approximation", SIGGRAPH 2003.
Basis waveletBasis(std::shared_ptr<const class CubeHaar> haar, uint32_t coefficients);
std::shared_ptr<const class CubeHaar> makeCubeHaar(const std::vector<ProbeLight>& lights);

/// A mixture of spherical Gaussians (von Mises-Fisher lobes) fitted by expectation maximisation, 12 bytes
/// each: axis 4, sharpness 2, energies 6; integrated texel by texel. Banerjee et al., JMLR 6, 2005; Tsai and
/// Shih, SIGGRAPH 2006.
Basis gaussianBasis(const std::vector<ProbeLight>& lights, uint32_t gaussians);

}  // namespace boxlight::accuracy
