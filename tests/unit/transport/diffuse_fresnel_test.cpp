// SPDX-License-Identifier: Apache-2.0
// What the tabled mean k_d(n.v) of the diffuse Fresnel factor costs (docs/theory.md, section 7): the truth's
// factor 1 - F(v.h) depends on the light's direction, the pixel multiplies by its mean.
#include <gtest/gtest.h>

#include <cmath>

#include "bake/transport/bsdf.h"
#include "common/light/directional_albedo.h"

using namespace boxlight;

namespace {

/// Lambert radiance per unit albedo of a dielectric under radiance 1 from one side: +1 is the half of the sky
/// opposite to the viewer (where mirror directions are), -1 the viewer's half, 0 both.
double exactDiffuse(float nDotV, int side) {
  MaterialSample material;
  material.baseColor = Rgb(1);
  const Bsdf bsdf(material, {-std::sqrt(1 - nDotV * nDotV), 0, nDotV});
  constexpr int kRings = 400, kSectors = 800;
  double sum = 0;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSectors; ++j) {
      const double z = (i + 0.5) / kRings, phi = 2 * kPiDouble * (j + 0.5) / kSectors,
                   ring = std::sqrt(1 - z * z);
      const vec3 wi(float(ring * std::cos(phi)), float(ring * std::sin(phi)), float(z));
      if (side * wi.x >= 0)
        sum += double(bsdf.evaluate(wi, kDiffuse).value.x) * 2 * kPiDouble / (kRings * kSectors);
    }
  return sum;
}

double tabledFactor(float nDotV) { return 1 - (0.04 + 0.96 * double(albedoTable().diffuseFresnel(nDotV))); }

struct Case {
  float nDotV;
  double towardsMirror,
      behindViewer;  ///< relative error of the tabled mean under light from one half of the sky
};

class DiffuseFresnel : public ::testing::TestWithParam<Case> {};

}  // namespace

TEST_P(DiffuseFresnel, TheMeanIsExactUnderAConstantSky) {
  EXPECT_NEAR(tabledFactor(GetParam().nDotV) / exactDiffuse(GetParam().nDotV, 0), 1, 1e-3);
}

TEST_P(DiffuseFresnel, HalfASkyIsOffByTheDocumentedAmount) {
  const Case& c = GetParam();
  EXPECT_NEAR(0.5 * tabledFactor(c.nDotV) / exactDiffuse(c.nDotV, 1) - 1, c.towardsMirror, 1e-3);
  EXPECT_NEAR(0.5 * tabledFactor(c.nDotV) / exactDiffuse(c.nDotV, -1) - 1, c.behindViewer, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(, DiffuseFresnel,
                         ::testing::Values(Case{0.1f, 0.0217, -0.0208}, Case{0.3f, 0.0111, -0.0108},
                                           Case{0.7f, 0.0018, -0.0018}),
                         [](const auto& c) {
                           return "nv" + std::to_string(int(std::lround(100 * c.param.nDotV)));
                         });
