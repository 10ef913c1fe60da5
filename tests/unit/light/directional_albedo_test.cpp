// SPDX-License-Identifier: Apache-2.0
#include "common/light/directional_albedo.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boxlight {
namespace {

/// (A, B) by direct quadrature over all half vectors, in double precision and from the formulas of glTF's
/// appendix B rather than from ggx.h. Half vectors follow D n.h: tan^2(theta) = alpha^2 u / (1 - u).
glm::dvec2 quadrature(double alpha, double nDotV) {
  constexpr int kRings = 700, kSectors = 160;
  const double sine = std::sqrt(1.0 - nDotV * nDotV);
  auto root = [&](double cosine) {
    return std::sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
  };
  glm::dvec2 sum(0.0);
  for (int i = 0; i < kRings; ++i) {
    const double q = 1.0 - (i + 0.5) / kRings;  // 1 - u = q^2, to resolve the tail
    const double t = alpha * std::sqrt(1.0 - q * q) / q, z = 1.0 / std::sqrt(1.0 + t * t);
    for (int j = 0; j < kSectors; ++j) {
      const double vDotH = sine * t * z * std::cos(kPiDouble * (j + 0.5) / kSectors) + nDotV * z;
      const double nDotL = 2.0 * vDotH * z - nDotV;
      if (vDotH <= 0.0 || nDotL <= 0.0) continue;
      const double visibility = 0.5 / (nDotL * root(nDotV) + nDotV * root(nDotL));
      const double fresnel = std::pow(1.0 - vDotH, 5);
      sum += 2.0 * q * visibility * 4.0 * vDotH * nDotL / z * glm::dvec2(1.0 - fresnel, fresnel);
    }
  }
  return sum / double(kRings * kSectors);
}

TEST(DirectionalAlbedo, WithinTwoThousandthsOfTheIntegral) {
  const AlbedoTable& table = albedoTable();
  double worst = 0.0;
  for (const double alpha :
       {0.001, 0.0018, 0.0033, 0.0062, 0.0107, 0.02, 0.041, 0.08, 0.15, 0.27, 0.44, 0.71, 0.97, 1.0})
    for (const double nDotV : {0.02, 0.025, 0.033, 0.047, 0.07, 0.11, 0.19, 0.34, 0.57, 0.83, 1.0}) {
      const glm::dvec2 expected = quadrature(alpha, nDotV);
      const vec2 found = table.specular(float(std::sqrt(alpha)), float(nDotV));
      const double error = std::max(std::abs(found.x - expected.x), std::abs(found.y - expected.y));
      EXPECT_LT(error, 2e-3) << "alpha " << alpha << ", n.v " << nDotV;
      worst = std::max(worst, error);
    }
  RecordProperty("worst", std::to_string(worst));
}

TEST(DirectionalAlbedo, KnownValues) {
  const vec2 mirror = albedoTable().specular(0.0f, 1.0f);
  EXPECT_NEAR(mirror.x, 1.0f, 1e-3f);
  EXPECT_NEAR(mirror.y, 0.0f, 1e-3f);
  const vec2 oblique = albedoTable().specular(0.0f, 0.5f);  // a mirror is Schlick's term itself
  EXPECT_NEAR(oblique.x, 1.0f - 1.0f / 32.0f, 1e-3f);
  EXPECT_NEAR(oblique.y, 1.0f / 32.0f, 1e-3f);
  for (int i = 0; i <= 50; ++i)
    for (int j = 0; j <= 50; ++j) {
      const vec2 ab = albedoTable().specular(float(i) / 50.0f, float(j) / 50.0f);
      EXPECT_GE(std::min(ab.x, ab.y), 0.0f);
      EXPECT_LE(ab.x + ab.y, 1.0f + 1e-5f) << "single scattering never gains energy";
    }
}

TEST(DirectionalAlbedo, ArgumentsAreClamped) {
  EXPECT_EQ(albedoTable().specular(2.0f, 1.5f), albedoTable().specular(1.0f, 1.0f));
  EXPECT_EQ(albedoTable().specular(-1.0f, -1.0f), albedoTable().specular(0.0f, 0.0f));
  EXPECT_EQ(albedoTable().diffuseFresnel(2.0f), albedoTable().diffuseFresnel(1.0f));
}

/// S over the whole hemisphere in polar angles, the half vector normalised: nothing shared with the table's
/// quadrature.
double bruteForceFresnel(double nDotV) {
  constexpr int kRings = 400, kSectors = 400;
  const dvec3 view(std::sqrt(1.0 - nDotV * nDotV), 0.0, nDotV);
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSectors; ++j) {
      const double theta = 0.5 * kPiDouble * (i + 0.5) / kRings, phi = 2.0 * kPiDouble * (j + 0.5) / kSectors;
      const dvec3 light(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      sum += std::pow(1.0 - glm::dot(view, glm::normalize(view + light)), 5) * light.z * std::sin(theta);
    }
  return sum * (0.5 * kPiDouble / kRings) * (2.0 * kPiDouble / kSectors) / kPiDouble;
}

TEST(DirectionalAlbedo, MeanDiffuseFresnel) {
  for (const float nDotV : {0.02f, 0.1f, 0.3f, 0.7f, 1.0f})
    EXPECT_NEAR(albedoTable().diffuseFresnel(nDotV), bruteForceFresnel(nDotV), 5e-5) << nDotV;
  const float f0 = 0.04f, kd = 1.0f - (f0 + (1.0f - f0) * albedoTable().diffuseFresnel(0.3f));
  EXPECT_NEAR(kd, 0.95f, 0.005f) << "a usual dielectric at n.v .3";
}

}  // namespace
}  // namespace boxlight
