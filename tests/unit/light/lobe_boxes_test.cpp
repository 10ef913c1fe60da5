// SPDX-License-Identifier: Apache-2.0
#include "common/light/lobe_boxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "common/light/ggx.h"
#include "common/light/light_domain.h"
#include "common/light/summed_area.h"

using namespace boxlight;

namespace {

GgxLobe lobeAt(vec3 normal, float cosine, float turn, vec2 alpha) {
  GgxLobe lobe;
  lobe.normal = glm::normalize(normal);
  orthonormalBasis(lobe.normal, lobe.tangent, lobe.bitangent);
  const float sine = std::sqrt(1 - cosine * cosine);
  lobe.view = cosine * lobe.normal + sine * (std::cos(turn) * lobe.tangent + std::sin(turn) * lobe.bitangent);
  lobe.alpha = alpha;
  return lobe;
}

/// Mean of `radiance` over the lobe, by stratified visible normals.
double exact(const GgxLobe& lobe, const std::function<double(vec3)>& radiance) {
  constexpr int kSide = 256;
  const vec3 view(dot(lobe.view, lobe.tangent), dot(lobe.view, lobe.bitangent), dot(lobe.view, lobe.normal));
  double sum = 0, weights = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const vec2 random((float(i % kSide) + 0.5f) / kSide, (float(i / kSide) + 0.5f) / kSide);
    const vec3 half = ggx::sampleVisibleNormal(view, lobe.alpha, random);
    const vec3 light = 2 * dot(view, half) * half - view;
    if (!(light.z > 0)) continue;
    const double weight = double(ggx::visibility(light, view, lobe.alpha)) * double(light.z);
    sum += weight * radiance(light.x * lobe.tangent + light.y * lobe.bitangent + light.z * lobe.normal);
    weights += weight;
  }
  return sum / weights;
}

/// Mean of F G2 / G1 over visible normals.
double exactAlbedo(const GgxLobe& lobe) {
  constexpr int kSide = 256;
  const vec3 view(dot(lobe.view, lobe.tangent), dot(lobe.view, lobe.bitangent), dot(lobe.view, lobe.normal));
  double sum = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const vec2 random((float(i % kSide) + 0.5f) / kSide, (float(i / kSide) + 0.5f) / kSide);
    const vec3 half = ggx::sampleVisibleNormal(view, lobe.alpha, random);
    const vec3 light = 2 * dot(view, half) * half - view;
    if (!(light.z > 0)) continue;
    const float fresnel = lobe.f0.x + (lobe.f90.x - lobe.f0.x) * ggx::schlickWeight(dot(view, half));
    sum += double(fresnel * ggx::visibility(light, view, lobe.alpha) * 4 * light.z * view.z /
                  ggx::masking(view, lobe.alpha));
  }
  return sum / kSide / kSide;
}

SummedArea tableOf(const std::function<double(vec3)>& radiance) {
  Image map = makeImage(512, 256, 3);
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 0; x < map.width; ++x)
      for (int c = 0; c < 3; ++c)
        map.at(x, y)[c] = float(radiance(uvToDirection((vec2(x, y) + 0.5f) / vec2(map.width, map.height))));
  return SummedArea(map);
}

double relight(const GgxLobe& lobe, const SummedArea& light) {
  double sum = 0;
  for (const Box& box : lobeBoxes(lobe))
    sum += double(box.energy.x) * light.integrate(box, 0).x / box.solidAngle();
  return sum;
}

const vec3 kNormals[] = {{0, 1, 0}, {0, -1, 0}, {-1, 0, 1e-4f}, {0.3f, 0.9f, -0.4f}, {1, -0.2f, 0.7f}};

}  // namespace

TEST(LobeBoxes, EnergiesSumToOneAndBoxesAreValid) {
  for (const vec3 normal : kNormals)
    for (const float cosine : {1e-3f, 0.05f, 0.5f, 1.0f})
      for (const vec2 alpha : {vec2(1e-4f), vec2(0.02f), vec2(0.3f), vec2(1), vec2(0.5f, 1e-3f)}) {
        GgxLobe lobe = lobeAt(normal, cosine, 1, alpha);
        lobe.f0 = {0.04f, 0.5f, 1};
        dvec3 sum(0.0);
        for (const Box& box : lobeBoxes(lobe)) {
          sum += dvec3(box.energy);
          EXPECT_TRUE(box.u0 >= 0 && box.u0 < 1 && box.du > 0 && box.du <= 1) << box.u0 << ' ' << box.du;
          EXPECT_TRUE(box.v0 >= 0 && box.dv > 0 && box.v0 + box.dv <= 1.000001f) << box.v0 << ' ' << box.dv;
        }
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1.0, 1e-6) << cosine << ' ' << alpha.x;
      }
}

TEST(LobeBoxes, SmoothLightIsIntegratedWell) {
  const auto light = [](vec3 d) { return 1 + 0.8 * double(d.y) + 0.6 * double(d.x * d.z); };
  const SummedArea table = tableOf(light);
  for (const vec3 normal : kNormals)
    for (const float cosine : {0.1f, 0.6f, 1.0f})
      for (const vec2 alpha : {vec2(0.01f), vec2(0.1f), vec2(0.25f), vec2(0.2f, 0.02f)}) {
        const GgxLobe lobe = lobeAt(normal, cosine, 2, alpha);
        EXPECT_NEAR(relight(lobe, table), exact(lobe, light), 0.04)
            << normal.y << ' ' << cosine << ' ' << alpha.x;
      }
}

TEST(LobeBoxes, AnEdgeAcrossTheLobeIsBlurredByIt) {
  // Light in front of a plane through the mirror direction turned by t: half at 0, and almost nothing at 3
  // alpha.
  for (const float alpha : {0.02f, 0.1f})
    for (const float turned : {-4.0f, -1.0f, 0.0f, 1.0f, 4.0f}) {
      const GgxLobe lobe = lobeAt({0.3f, 0.5f, -0.6f}, 0.8f, 0.4f, vec2(alpha));
      const vec3 mirror = 2 * dot(lobe.view, lobe.normal) * lobe.normal - lobe.view;
      const vec3 side = glm::normalize(glm::cross(mirror, vec3(0.2f, 1, 0.1f)));
      const vec3 edge = std::cos(turned * alpha) * side + std::sin(turned * alpha) * mirror;
      const auto light = [&](vec3 d) { return dot(d, edge) > 0 ? 1.0 : 0.0; };
      EXPECT_NEAR(relight(lobe, tableOf(light)), exact(lobe, light), 0.09) << alpha << ' ' << turned;
    }
}

TEST(LobeBoxes, AnisotropyStretchesThem) {
  const GgxLobe lobe = lobeAt({1, 0, 0}, 1, 0, {0.3f, 0.02f});
  const bool tangentIsUp = std::abs(lobe.tangent.y) > 0.5f;
  vec2 low(1), high(0);  // of the middle boxes
  for (size_t j = 4; j < kLobeBoxes - 4; ++j) {
    const Box box = lobeBoxes(lobe)[j];
    const vec2 middle(box.u0 + 0.5f * box.du, box.v0 + 0.5f * box.dv);
    low = glm::min(low, middle), high = glm::max(high, middle);
    EXPECT_LT(tangentIsUp ? 2 * box.du / box.dv : box.dv / (2 * box.du), 3) << "a piece of the streak";
  }
  const vec2 extent = (high - low) * vec2(2, 1);
  EXPECT_GT(tangentIsUp ? extent.y / extent.x : extent.x / extent.y, 10);
}

TEST(LobeBoxes, AlbedosAreAsExactAsTheDirections) {
  for (const float cosine : {0.1f, 0.4f, 0.9f})
    for (const float turn : {0.0f, 0.8f, 1.6f})
      for (const vec2 alpha : {vec2(0.3f), vec2(0.05f), vec2(0.6f, 0.03f), vec2(0.3f, 0.1f)}) {
        GgxLobe lobe = lobeAt({0, 1, 0}, cosine, turn, alpha);
        lobe.f0 = Rgb(0.5f);
        EXPECT_NEAR(double(lobeAlbedo(lobe).x), exactAlbedo(lobe), 0.02)
            << cosine << ' ' << turn << ' ' << alpha.x;
      }
}

TEST(LobeBoxes, NothingJumpsWhenTheViewTurns) {
  // Over the pole of the light domain and across its seam, in steps of a tenth of a degree.
  const SummedArea table =
      tableOf([](vec3 d) { return 1 + double(d.x) + 0.5 * std::sin(6.0 * double(d.z)); });
  for (const vec3 normal : kNormals) {
    double before = -1;
    for (float turn = -1; turn < 1; turn += 0.00175f) {
      GgxLobe lobe = lobeAt(normal, std::cos(turn), turn < 0 ? 0.7f + kPi : 0.7f, vec2(0.05f));
      const double value = relight(lobe, table);
      const double last = before >= 0 ? before : value;
      EXPECT_NEAR(value, last, 0.03) << normal.y << " at " << turn;
      before = value;
    }
  }
}

TEST(LobeBoxes, TheIsotropicTangentMovesReflectionsAlongU) {
  for (const vec3 normal : kNormals)
    for (const float cosine : {0.3f, 0.9f}) {
      const GgxLobe lobe = lobeAt(normal, cosine, 0.7f, vec2(0.1f));
      const vec3 along = lobeTangent(lobe.normal, lobe.view);
      EXPECT_NEAR(dot(along, along), 1, 1e-5);
      EXPECT_NEAR(dot(along, lobe.normal), 0, 1e-5);
      const auto reflected = [&](float step) {
        const vec3 half = glm::normalize(lobe.normal + step * along);
        return directionToUv(2 * dot(lobe.view, half) * half - lobe.view);
      };
      const vec2 moved = reflected(5e-3f) - reflected(-5e-3f);
      EXPECT_GT(std::abs(moved.x), 1e-3f);
      EXPECT_LT(std::abs(moved.y), 0.01f * std::abs(moved.x));
    }
  EXPECT_NEAR(glm::length(lobeTangent({0, 1, 0}, {0, 1, 0})), 1, 1e-5) << "at the pole any will do";
}

TEST(LobeBoxes, CellsFillTheSquareOfRandomNumbers) {
  for (const LobeCells* cells : {&roundCells(), &stripCells()}) {
    float area = 0;
    vec2 mean(0);
    for (const LobeCell& cell : *cells) {
      area += cell.area;
      for (const vec2 random : cell.random) mean += random * cell.area / float(kLobeSamples);
    }
    EXPECT_NEAR(area, 1, 1e-6);
    EXPECT_NEAR(mean.x, 0.5, 1e-6);
    EXPECT_NEAR(mean.y, 0.5, 0.07) << "strips are cut off";
  }
}

TEST(LobeBoxes, AStreakStaysNarrowWhateverItsDirection) {
  // A bright spot that the streak of brushed metal passes at a distance of a few times its width.
  for (const float turn : {0.0f, 0.8f, 1.6f, 2.4f})
    for (const float beside : {0.0f, 3.0f, 6.0f}) {
      GgxLobe lobe = lobeAt({0.2f, 0.1f, 1}, 0.7f, 0.5f, {0.6f, 0.03f});
      const vec3 along = std::cos(turn) * lobe.tangent + std::sin(turn) * lobe.bitangent;
      lobe.bitangent = glm::cross(lobe.normal, along);
      lobe.tangent = along;
      const vec3 half = glm::normalize(lobe.normal + 0.15f * along + beside * 0.03f * lobe.bitangent);
      const vec3 spot = 2 * dot(lobe.view, half) * half - lobe.view;
      const auto light = [&](vec3 d) { return dot(d, spot) > 0.998f ? 1.0 : 0.0; };
      EXPECT_NEAR(relight(lobe, tableOf(light)), exact(lobe, light), 0.02) << turn << ' ' << beside;
    }
}
