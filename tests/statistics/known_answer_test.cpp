// SPDX-License-Identifier: Apache-2.0
// The BSDF against its published formulas, written out again, and against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/light/directional_albedo.h"
#include "common/light/ggx.h"
#include "common/light/sheen.h"
#include "common/light/thin_film.h"
#include "tests/support/bsdf_lab.h"

using namespace boxlight;

TEST(KnownAnswer, CompensatedWhiteMetalReturnsEverything) {
  for (const float roughness : {0.1f, 0.3f, 0.6f, 0.8f, 1.0f})
    for (const float cosine : {0.05f, 0.3f, 0.8f, 1.0f}) {
      MaterialSample m{.metallic = 1, .roughness = roughness, .multipleScattering = true};
      const Bsdf bsdf(m, test::directionAt(cosine));
      EXPECT_NEAR(test::sampledAlbedo(bsdf, kSpecular, 128).x, 1, 5e-3f) << roughness << " " << cosine;
    }
}

TEST(KnownAnswer, SheenAlbedoIsItsIntegral) {
  for (const float roughness : {0.2f, 0.5f, 0.8f, 1.0f})
    for (const float cosine : {0.05f, 0.2f, 0.5f, 1.0f}) {
      MaterialSample m{.specular = 0, .sheenColor = Rgb(1), .sheenRoughness = roughness};
      const Bsdf bsdf(m, test::directionAt(cosine));
      constexpr int kRings = 600, kSectors = 400;
      double sum = 0;  // polar angles: nothing shared with the table
      for (int i = 0; i < kRings; ++i)
        for (int j = 0; j < kSectors; ++j) {
          const double theta = 0.5 * kPiDouble * (i + 0.5) / kRings,
                       phi = 2 * kPiDouble * (j + 0.5) / kSectors;
          const vec3 wi(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
          sum += double(bsdf.evaluate(wi, kSheen).value.x) * std::sin(theta);
        }
      sum *= 0.5 * kPiDouble / kRings * 2 * kPiDouble / kSectors;
      EXPECT_NEAR(sheen::albedo(roughness, cosine), sum, 4e-3) << roughness << " " << cosine;
    }
}

// Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF", 2017, equations 2 and 3 and table 1,
// written out again.
TEST(KnownAnswer, SheenIsCharlies) {
  constexpr double kAlpha0[] = {25.3245, 3.32435, 0.16801, -1.27393, -4.85967},
                   kAlpha1[] = {21.5473, 3.82987, 0.19823, -1.97760, -4.32054};
  for (const double alpha : {0.04, 0.25, 0.6, 1.0}) {
    const double smooth = (1 - alpha) * (1 - alpha);
    const auto p = [&](int i) { return smooth * kAlpha0[i] + (1 - smooth) * kAlpha1[i]; };
    const auto l = [&](double x) { return p(0) / (1 + p(1) * std::pow(x, p(2))) + p(3) * x + p(4); };
    const auto lambda = [&](double cosine) {
      return std::exp(cosine < 0.5 ? l(cosine) : 2 * l(0.5) - l(1 - cosine));
    };
    for (const double a : {0.1, 0.45, 0.55, 0.95})
      for (const double b : {0.2, 0.8}) {
        const double v = 1 / ((1 + lambda(a) + lambda(b)) * 4 * a * b);
        EXPECT_NEAR(sheen::visibility(float(a), float(b), float(alpha)) / v, 1, 1e-3);
        const double d = (2 + 1 / alpha) * std::pow(std::sqrt(1 - a * a), 1 / alpha) / (2 * kPiDouble);
        EXPECT_NEAR(sheen::distribution(test::directionAt(float(a), 1), float(alpha)) / d, 1, 1e-3);
      }
  }
}

// KHR_materials_anisotropy, D and V written out again: x is the rough axis.
TEST(KnownAnswer, AnisotropicLobesAreWideAlongTheirDirection) {
  for (const float strength : {0.3f, 0.7f, 1.0f})
    for (const float turn : {0.0f, 0.8f, 1.6f}) {
      const MaterialSample m{.metallic = 1, .roughness = 0.5f, .anisotropy = strength};
      const vec3 view = test::directionAt(0.8f, turn + 3), light = test::directionAt(0.5f, turn);
      const dvec3 v(view), l(light), h = glm::normalize(v + l);
      const double b = 0.25, t = b + (1 - b) * double(strength) * double(strength);
      const double slope = h.x * h.x / (t * t) + h.y * h.y / (b * b) + h.z * h.z;
      const double d = 1 / (kPiDouble * t * b * slope * slope);
      const auto length = [&](dvec3 w) { return glm::length(dvec3(t * w.x, b * w.y, w.z)); };
      const double visibility = 0.5 / (l.z * length(v) + v.z * length(l));
      EXPECT_NEAR(Bsdf(m, view).evaluate(light).value.x / (d * visibility * l.z), 1, 1e-3)
          << strength << " " << turn;
    }
}

// The coat's own normal decides its microfacets and its Fresnel term.
TEST(KnownAnswer, ACoatFollowsItsOwnNormal) {
  const MaterialSample m{.baseColor = Rgb(0), .specular = 0, .clearcoat = 0.7f, .clearcoatRoughness = 0.5f};
  const dvec3 n = glm::normalize(dvec3(0.4, 0.2, 1));
  const vec3 view = test::directionAt(0.6f, 0.4f);
  for (const float turn : {0.0f, 2.0f, 4.0f}) {
    const vec3 light = test::directionAt(0.7f, turn);
    const dvec3 v(view), l(light), h = glm::normalize(v + l);
    const double a2 = 0.0625, nl = glm::dot(n, l), nv = glm::dot(n, v), nh = glm::dot(n, h);
    const double d = a2 / (kPiDouble * std::pow(nh * nh * (a2 - 1) + 1, 2));
    const auto stretched = [&](double cosine) { return std::sqrt(a2 + (1 - a2) * cosine * cosine); };
    const double visibility = 0.5 / (nl * stretched(nv) + nv * stretched(nl));
    const double fresnel = 0.04 + 0.96 * std::pow(1 - nv, 5);
    const Rgb found = Bsdf(m, view, {}, vec3(n)).evaluate(light).value;
    EXPECT_NEAR(found.x / (0.7 * fresnel * d * visibility * nl), 1, 1e-3) << turn;
  }
}

TEST(KnownAnswer, AFilmTakesThePlaceOfFresnelsTermByItsWeight) {
  const MaterialSample m{.baseColor = {0.9f, 0.5f, 0.2f},
                         .metallic = 0.3f,
                         .ior = 2,
                         .iridescence = 0.6f,
                         .iridescenceIor = 1.7f,
                         .iridescenceThickness = 350};
  const Rgb glass(1 / 9.0f);
  const auto filmed = [&](Rgb f0, float cosine) { return thinFilmReflectance(cosine, 1.7f, 350, f0); };
  const Fresnel fresnel(m, {}, 0.7f);
  for (const float cosine : {0.2f, 0.6f, 1.0f}) {
    const auto layer = [&](Rgb f0) {
      return glm::mix(glm::mix(f0, Rgb(1), std::pow(1 - cosine, 5.0f)), filmed(f0, cosine), 0.6f);
    };
    const Rgb expected = glm::mix(layer(glass), layer(m.baseColor), 0.3f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(fresnel.reflected(cosine)[c], expected[c], 1e-5f) << cosine;
    EXPECT_NEAR(fresnel.dielectric(cosine), maxComponent(layer(glass)), 1e-5f);
  }
  const auto atNormal = [&](Rgb f0) { return glm::mix(f0, schlickF0(filmed(f0, 0.7f), 0.7f), 0.6f); };
  const Rgb f0 = glm::mix(atNormal(glass), atNormal(m.baseColor), 0.3f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(fresnel.f0()[c], f0[c], 1e-5f);
}

TEST(KnownAnswer, EqualAlphasAreIsotropic) {
  for (const float alpha : {1e-3f, 0.05f, 0.3f, 1.0f})
    for (const float cosine : {0.05f, 0.6f, 1.0f}) {
      const vec3 view = test::directionAt(cosine, 0.3f), light = test::directionAt(0.4f, 2),
                 half = test::directionAt(1 - 0.5f * alpha * alpha, 1);
      EXPECT_NEAR(ggx::distribution(half, vec2(alpha)) / ggx::distribution(half, alpha), 1, 1e-4f);
      EXPECT_NEAR(ggx::visibility(light, view, vec2(alpha)) / ggx::visibility(light.z, view.z, alpha), 1,
                  1e-4f);
      EXPECT_NEAR(ggx::masking(view, vec2(alpha)) / ggx::masking(view.z, alpha), 1, 1e-4f);
    }
}

TEST(KnownAnswer, SmoothThinGlassReflectsFresnelAndPassesTheRest) {
  for (const float cosine : {1.0f, 0.6f, 0.25f}) {
    MaterialSample m{.baseColor = {0.9f, 0.5f, 0.2f}, .roughness = 0, .transmission = 1};
    const vec3 wo = test::directionAt(cosine, 0.4f);
    const Bsdf bsdf(m, wo);
    const float fresnel = 0.04f + 0.96f * std::pow(1 - cosine, 5.0f);
    double reflected = 0, passed = 0;
    constexpr int kDraws = 1 << 14;
    std::mt19937_64 engine(5);
    const auto number = [&] { return float(engine() >> 40) * 0x1p-24f; };
    for (int i = 0; i < kDraws; ++i) {
      const float choice = (float(i) + 0.5f) / kDraws, u = number();
      const LobeSample drawn =
          bsdf.sample(choice, {u, 0.9f * number()});  // not the skirt: 2e-3 of the lobe's width
      const LobeValue lobe = bsdf.evaluate(drawn.wi);
      ASSERT_GT(lobe.density, 0);
      const vec3 exact = drawn.wi.z > 0 ? vec3(-wo.x, -wo.y, wo.z) : -wo;
      ASSERT_LT(glm::length(drawn.wi - exact), 1e-3f);
      (drawn.wi.z > 0 ? reflected : passed) += double(lobe.value.x / lobe.density) / kDraws;
    }
    EXPECT_NEAR(reflected, fresnel, 2e-3f) << cosine;
    EXPECT_NEAR(passed, 0.9f * (1 - fresnel), 2e-3f) << cosine;
  }
}

// A matched index passes light as a delta, drawn beside the other lobes.
TEST(KnownAnswer, MatchedMediaPassLightStraightOn) {
  MaterialSample m{.roughness = 0, .specular = 0, .transmission = 0.25f, .volume = true};
  const vec3 wo = test::directionAt(0.25f);
  const Interface matched{1, false};
  EXPECT_NEAR(test::sampledAlbedo(Bsdf(m, wo, matched), kAllLobes, 16, 256).x, 1, 1e-3f);
  m.specular = 1, m.transmission = 0.5f;
  const float fresnel = std::pow(0.75f, 5.0f);
  EXPECT_NEAR(test::sampledAlbedo(Bsdf(m, wo, matched), kSpecular, 64, 64).x, fresnel + 0.5f * (1 - fresnel),
              5e-3f);
}

TEST(KnownAnswer, BeyondTheCriticalAngleEverythingIsReflected) {
  MaterialSample m{.roughness = 0.1f, .transmission = 1, .volume = true};
  const Interface leaving{1 / 1.5f, true};
  const float critical = std::sqrt(1 - 1 / 2.25f);
  EXPECT_EQ(Fresnel(m, leaving, 1).dielectric(critical - 1e-3f), 1);
  EXPECT_EQ(Fresnel(m, leaving, 1).reflected(0.2f), Rgb(1));
  EXPECT_LT(Fresnel(m, leaving, 1).dielectric(critical + 0.05f), 0.6f);
  EXPECT_NEAR(Fresnel(m, leaving, 1).dielectric(1), 0.04f, 1e-6f);
  // Snell: the same reflectance from both sides of the same ray.
  const float outside = 0.3f, inside = std::sqrt(1 - (1 - outside * outside) / 2.25f);
  EXPECT_NEAR(Fresnel(m, leaving, 1).dielectric(inside), Fresnel(m, {1.5f, false}, 1).dielectric(outside),
              1e-5f);
  // By the indices, whatever the material's weight.
  m.specular = 0;
  EXPECT_EQ(Fresnel(m, leaving, 1).reflected(0.2f), Rgb(1));
  // Water in glass: F0 is that of the relative index.
  m.specular = 1, m.ior = 1.33f;
  EXPECT_NEAR(Fresnel(m, {1.33f / 1.5f, false}, 1).dielectric(1), 0.0036085f, 1e-6f);
}

// Coat, sheen and film lie on the outside of a volume: from within there are none.
TEST(KnownAnswer, LayersOfAVolumeAreOutsideAlone) {
  const MaterialSample bare{.roughness = 0.4f, .transmission = 1, .volume = true};
  MaterialSample layered = bare;
  layered.clearcoat = 1, layered.sheenColor = Rgb(1), layered.sheenRoughness = 0.5f, layered.iridescence = 1;
  const Interface entering{1.5f, false}, leaving{1 / 1.5f, true};
  const vec3 wo = test::directionAt(0.9f);
  for (const vec3 wi : {test::directionAt(0.7f, 3), test::directionAt(0.9f, 2) * vec3(1, 1, -1)}) {
    EXPECT_EQ(Bsdf(layered, wo, leaving).evaluate(wi).value, Bsdf(bare, wo, leaving).evaluate(wi).value);
    EXPECT_NE(Bsdf(layered, wo, entering).evaluate(wi).value, Bsdf(bare, wo, entering).evaluate(wi).value);
  }
}

// The whole stack against the pixel's own formula (docs/theory.md, section 7), written out again: every
// weight, tint and layer.
TEST(KnownAnswer, LayersAddUpAsThePixelTakesThem) {
  const MaterialSample stacks[] = {
      {.baseColor = {0.9f, 0.5f, 0.2f}, .roughness = 0.5f},
      {.baseColor = {0.9f, 0.5f, 0.2f}, .metallic = 0.4f, .roughness = 0.8f, .multipleScattering = true},
      {.baseColor = {0.9f, 0.5f, 0.2f}, .specular = 0.6f, .specularColor = {0.2f, 1, 3}, .ior = 2},
      {.baseColor = {0.9f, 0.5f, 0.2f}, .roughness = 0.6f, .clearcoat = 0.7f, .clearcoatRoughness = 0.3f},
      {.baseColor = {0.9f, 0.5f, 0.2f}, .sheenColor = {0.9f, 0.3f, 0.1f}, .sheenRoughness = 0.7f},
      {.baseColor = {0.9f, 0.5f, 0.2f},
       .diffuseTransmission = 0.3f,
       .diffuseTransmissionColor = {0.1f, 0.8f, 1}},
      {.baseColor = {0.9f, 0.5f, 0.2f}, .metallic = 0.3f, .roughness = 0.3f, .transmission = 0.6f},
      {.baseColor = {0.9f, 0.5f, 0.2f},
       .metallic = 0.2f,
       .roughness = 0.4f,
       .clearcoat = 1,
       .clearcoatRoughness = 0.5f,
       .sheenColor = {0.5f, 0.3f, 0.8f},
       .sheenRoughness = 0.5f,
       .diffuseTransmission = 0.5f,
       .emission = {1, 2, 3}},
  };
  for (const MaterialSample& m : stacks)
    for (const float cosine : {0.3f, 0.7f, 1.0f}) {
      const float d0 = (m.ior - 1) * (m.ior - 1) / ((m.ior + 1) * (m.ior + 1));
      const Rgb dielectric = glm::min(d0 * m.specularColor, Rgb(1));
      const float strongest = maxComponent(dielectric);
      const Rgb f0 = glm::mix(m.specular * dielectric, m.baseColor, m.metallic);
      const vec2 ab = albedoTable().specular(m.roughness, cosine);
      const float f90 = glm::mix(m.specular, 1.0f, m.metallic);
      Rgb reflected = f0 * ab.x + f90 * ab.y;
      if (m.multipleScattering) reflected *= Rgb(1) + f0 * (1 / (ab.x + ab.y) - 1);
      const Rgb passed = m.transmission * (1 - m.metallic) * m.baseColor *
                         (ab.x * (1 - m.specular * strongest) + ab.y * (1 - m.specular));
      const float kd = 1 - m.specular * (strongest + (1 - strongest) * albedoTable().diffuseFresnel(cosine));
      const Rgb scattered = kd * (1 - m.metallic) * (1 - m.transmission) *
                            glm::mix(m.baseColor, m.diffuseTransmissionColor, m.diffuseTransmission);
      const float sheenAlbedo = sheen::albedo(m.sheenRoughness, cosine);
      const float coat = m.clearcoat * (0.04f + 0.96f * std::pow(1 - cosine, 5.0f));
      const vec2 coatAb = albedoTable().specular(m.clearcoatRoughness, cosine);
      const float under = 1 - maxComponent(m.sheenColor) * sheenAlbedo;
      const Rgb viewDependent = (1 - coat) * (under * (reflected + passed) + m.sheenColor * sheenAlbedo) +
                                coat * (coatAb.x + coatAb.y);
      const Rgb expected = viewDependent + (1 - coat) * under * scattered;
      const Bsdf bsdf(m, test::directionAt(cosine));
      const Rgb found = test::sampledAlbedo(bsdf, kAllLobes, 24, 256);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[c], expected[c], 8e-3f) << &m - stacks << ", n.v " << cosine << ", channel " << c;
        EXPECT_NEAR(bsdf.viewDependentAlbedo()[c], viewDependent[c], 1e-4f) << &m - stacks;
        EXPECT_FLOAT_EQ(bsdf.emission()[c], (1 - coat) * m.emission[c]);
      }
    }
}
