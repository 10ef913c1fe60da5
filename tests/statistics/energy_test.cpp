// SPDX-License-Identifier: Apache-2.0
// What holds at every point of the parameter grid: nothing is negative or infinite, single lobes and layers
// never gain energy, and the parts that physics makes symmetric are.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/light/directional_albedo.h"
#include "common/light/ggx.h"
#include "common/light/sheen.h"
#include "tests/support/bsdf_lab.h"
#include "tests/support/material_cases.h"

using namespace boxlight;

namespace {

/// Materials at random, each number often at one of its ends.
class RandomMaterials {
 public:
  test::MaterialCase next() {
    test::MaterialCase c{"random", {}};
    MaterialSample& m = c.material;
    m.baseColor = color();
    m.metallic = number(), m.roughness = number(), m.specular = number(), m.specularColor = color();
    m.ior = number() == 0 ? 0 : 1 + 1.5f * number();
    m.anisotropy = number(), m.clearcoat = number(), m.clearcoatRoughness = number();
    m.sheenColor = color(), m.sheenRoughness = number(), m.transmission = number();
    m.diffuseTransmission = number(), m.diffuseTransmissionColor = color();
    m.multipleScattering = number() > 0.5f;
    m.iridescence = number(), m.iridescenceThickness = 1000 * number();
    m.volume = number() > 0.5f;
    if (m.volume) c.interface = {m.ior, false};
    if (m.volume && number() > 0.5f) c.interface = {m.ior > 0 ? 1 / m.ior : 0, true};
    c.coatNormal = test::directionAt(1 - 0.5f * number(), 6 * number());
    return c;
  }
  vec3 view() {
    const float cosines[] = {1e-3f, 0.02f, 0.2f, 0.6f, 1, number()};
    return test::directionAt(std::max(cosines[engine_() % 6], 1e-3f), 6 * number());
  }
  float number() {
    const uint64_t end = engine_() % 4;
    return end < 2 ? float(end) : float(engine_() >> 40) * 0x1p-24f;
  }

 private:
  Rgb color() { return {number(), number(), number()}; }
  std::mt19937_64 engine_{7};
};

bool isGood(float x) { return std::isfinite(x) && x >= 0; }
bool isGood(Rgb x) { return isGood(x.x) && isGood(x.y) && isGood(x.z); }

constexpr float kRandomEnds[] = {0, 0x1p-24f, 0.5f, 1 - 0x1p-24f};

}  // namespace

TEST(Energy, NothingIsNegativeOrInfinite) {
  RandomMaterials random;
  for (int i = 0; i < 3000; ++i) {
    const test::MaterialCase c = random.next();
    const Bsdf bsdf = c.bsdf(random.view());
    ASSERT_TRUE(isGood(bsdf.viewDependentAlbedo())) << i;
    for (const float choice : kRandomEnds)
      for (const float u : kRandomEnds)
        for (const float v : kRandomEnds) {
          const LobeSample drawn = bsdf.sample(choice, {u, v});
          ASSERT_TRUE(std::isfinite(glm::length(drawn.wi)) && isGood(drawn.weight))
              << i << ", random " << choice << " " << u << " " << v;
          const LobeValue lobe = bsdf.evaluate(drawn.wi);
          ASSERT_TRUE(isGood(lobe.value) && isGood(lobe.density))
              << i << ", random " << choice << " " << u << " " << v;
        }
  }
}

TEST(Energy, NoLobeAndNoLayeringGains) {
  RandomMaterials random;
  for (int i = 0; i < 250; ++i) {
    test::MaterialCase c = random.next();
    // Charlie's sheen as published gains light at grazing views of smooth cloth.
    if (c.material.sheenRoughness < 0.5f) c.material.sheenColor = Rgb(0);
    const Bsdf bsdf = c.bsdf(random.view());
    // An isotropic table stands in for the albedo that compensates an anisotropic lobe.
    const float bound = c.material.multipleScattering && c.material.anisotropy > 0 ? 1.06f : 1.01f;
    for (const uint32_t lobes : {uint32_t(kSpecular), uint32_t(kSheen), uint32_t(kCoat),
                                 uint32_t(kViewDependent), uint32_t(kDiffuse | kDiffuseTransmit | kCoat)})
      ASSERT_LE(maxComponent(test::sampledAlbedo(bsdf, lobes, 16, 64)), bound) << i << " lobes " << lobes;
    if (c.material.specular == 0 || c.material.metallic == 1) {
      ASSERT_LE(maxComponent(test::sampledAlbedo(bsdf, kAllLobes, 16, 64)), bound) << i;
    }
  }
}

// glTF's fresnel_mix takes 1 - F at the half vector of each light direction from the diffuse base, not what
// the glossy lobe reflects in all: a white dielectric returns more than it gets towards grazing angles.
TEST(Energy, GltfsDiffuseBaseUnderASmoothDielectricExceedsOne) {
  for (const float cosine : {0.05f, 0.2f, 0.5f, 1.0f}) {
    const Bsdf bsdf(MaterialSample{.roughness = 0.2f}, test::directionAt(cosine));
    const vec2 ab = albedoTable().specular(0.2f, cosine);
    const float base = 0.96f * (1 - albedoTable().diffuseFresnel(cosine));
    EXPECT_NEAR(test::sampledAlbedo(bsdf, kAllLobes, 64, 32).x, 0.04f * ab.x + ab.y + base, 0.02f) << cosine;
    EXPECT_EQ(0.04f * ab.x + ab.y + base > 1.01f, cosine < 1) << cosine;
  }
}

// Reciprocal: f of the base lobes, without coat and sheen; refraction as value / (cos n^2), n the relative
// index, of the value that carries basic radiance L / n^2.
TEST(Reciprocity, BaseLobesAreSymmetric) {
  for (const test::MaterialCase& c : test::materialCases()) {
    const MaterialSample& m = c.material;
    if (m.clearcoat > 0 || maxComponent(m.sheenColor) > 0 || m.multipleScattering || m.roughness < 0.05f)
      continue;
    std::mt19937_64 engine(11);
    const auto number = [&] { return float(engine() >> 40) * 0x1p-24f; };
    for (int i = 0; i < 200; ++i) {
      const vec3 a = test::directionAt(0.05f + 0.9f * number(), 6 * number());
      vec3 b = test::directionAt(0.05f + 0.9f * number(), 6 * number());
      const bool crosses = i % 2;
      if (crosses && m.roughness < 0.3f)
        continue;  // f of the far skirt is below the rounding of half vectors
      test::MaterialCase other = c;
      if (crosses && c.interface.ior > 0) other.interface = {1 / c.interface.ior, !c.interface.inside};
      // From below, z is turned down: a half turn about x keeps the frame right-handed.
      const auto turned = [&](vec3 w) { return crosses ? vec3(w.x, w.y, -w.z) : w; };
      const vec3 wi = crosses ? b * vec3(1, 1, -1) : b;
      const float n2 = crosses && c.interface.ior > 0 ? c.interface.ior * c.interface.ior : 1;
      const Rgb forward = c.bsdf(a).evaluate(wi).value / (b.z * n2);
      const Rgb backward = other.bsdf(turned(wi)).evaluate(turned(a)).value / a.z;
      for (int k = 0; k < 3; ++k)
        ASSERT_NEAR(forward[k], backward[k], 2e-3f * std::max(forward[k], 1e-2f))
            << c.name << (crosses ? " through" : " above") << ", " << a.z << " " << b.z;
    }
  }
}

// The weights of coat and sheen depend on wo alone (docs/theory.md, section 3).
TEST(Reciprocity, CoatAndSheenAreNotSymmetric) {
  for (const char* name : {"coat", "smooth sheen on metal"})
    for (const test::MaterialCase& c : test::materialCases())
      if (c.name == name) {
        const vec3 a = test::directionAt(0.9f), b = test::directionAt(0.1f, 2);
        const float forward = c.bsdf(a).evaluate(b).value.x / b.z,
                    backward = c.bsdf(b).evaluate(a).value.x / a.z;
        EXPECT_GT(std::abs(forward / backward - 1), 0.02f) << name;
      }
}

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
      {.baseColor = {0.9f, 0.5f, 0.2f}, .roughness = 0.3f, .transmission = 0.6f},
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
      const Rgb expected =
          (1 - coat) * (under * (reflected + passed + scattered) + m.sheenColor * sheenAlbedo) +
          coat * (coatAb.x + coatAb.y);
      const Bsdf bsdf(m, test::directionAt(cosine));
      const Rgb found = test::sampledAlbedo(bsdf, kAllLobes, 24, 256);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[c], expected[c], 8e-3f) << &m - stacks << ", n.v " << cosine << ", channel " << c;
        EXPECT_FLOAT_EQ(bsdf.emission()[c], (1 - coat) * m.emission[c]);
      }
    }
}
