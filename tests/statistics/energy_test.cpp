// SPDX-License-Identifier: Apache-2.0
// What holds at every point of the parameter grid: nothing is negative or infinite, single lobes and layers
// never gain energy, and the parts that physics makes symmetric are.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/light/directional_albedo.h"
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
