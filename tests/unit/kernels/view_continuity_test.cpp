// SPDX-License-Identifier: Apache-2.0
// No popping: what a baked texel sends is continuous in the direction that it is seen from (with direction
// cells: in the direction that its pixels' hidden parts point to), along great circles that run over those
// that kernels are for and across the edges between them.
#include <gtest/gtest.h>

#include <cmath>

#include "bake/kernels/scene_bake.h"
#include "common/light/relight.h"
#include "tests/support/kernel_lab.h"
#include "tests/support/scenes.h"

using namespace boxlight;

namespace {

constexpr uint32_t kSize = 8;

/// A shiny floor between a wall and a ball.
class ViewContinuityTest : public ::testing::TestWithParam<asset::Scheme> {
 protected:
  ViewContinuityTest()
      : scene_(test::makeScene(test::metal(hasCells() ? 0.3f : 0.4f, Rgb(0.9f, 0.7f, 0.5f)))),
        light_(lab::tableOf(lab::makeLight(5, true))) {
    test::addQuad(scene_, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, {0, 0}, {0.45f, 1});
    test::addQuad(scene_, {-1, 0, -1}, {2, 0, 0}, {0, 2, 0}, {0.55f, 0}, {1, 1});
    test::addSphere(scene_, {0.2f, 0.4f, 0}, 0.35f, 24);
    for (size_t v = 8; v < scene_.vertices.size(); ++v) scene_.vertices[v].atlasUv[0] = 0.5f;  // not baked
    test::finish(scene_);
    const Intersector world(scene_);
    const TexelMap map = makeTexels(scene_, kSize, kSize);
    baked_ = bakeScene(world, map, planRecords(world, map, GetParam()), sphere_,
                       {128, 8, {}, 7, sphere_.frequency()}, ProgressStyle::none);
  }

  static bool hasCells() { return GetParam() == asset::Scheme::cells; }

  Relighter relighter() const {
    return Relighter(baked_.asset, [this](uint32_t stream, uint32_t tile) {
      return baked_.pages[stream * baked_.asset.tiles.size() + tile];
    });
  }

  Scene scene_;
  ViewSphere sphere_{3};
  SummedArea light_;
  BakedScene baked_;
};

/// The great circle from one view over another and on across the edge behind it.
struct Arc {
  vec3 from, to;
  vec3 at(double t) const { return glm::normalize(glm::mix(from, to, float(t))); }
};

/// One record's radiance along an arc.
class Sweep {
 public:
  Sweep(Relighter& relighter, const SummedArea& light, uint32_t index, const asset::TexelRecord& record,
        Arc arc)
      : relighter_(relighter),
        light_(light),
        record_(index),
        hasCells_((record.flags & asset::kDirectionCells) != 0),
        position_(record.position[0], record.position[1], record.position[2]),
        arc_(arc) {}

  dvec3 radiance(double t) {
    if (hasCells_) return relighter_.arriving(record_, arc_.at(t), light_).glossy;
    return relighter_.relight(record_, position_ + 1e5f * arc_.at(t), light_).glossy;
  }

  /// What is left of the largest change of kSteps steps when it is halved, kHalvings times, keeping the half
  /// with the larger change; and the mean radiance.
  void find() {
    constexpr int kSteps = 200, kHalvings = 9;
    double from = 0, largest = 0;
    dvec3 before = radiance(0);
    for (int i = 1; i <= kSteps; ++i) {
      const dvec3 next = radiance(double(i) / kSteps);
      if (glm::length(next - before) > largest)
        largest = glm::length(next - before), from = double(i - 1) / kSteps;
      mean += glm::length(next) / kSteps;
      before = next;
    }
    double to = from + 1.0 / kSteps;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (from + to);
      const dvec3 a = radiance(from), m = radiance(middle), b = radiance(to);
      (glm::length(m - a) > glm::length(b - m) ? to : from) = middle;
    }
    jump = glm::length(radiance(to) - radiance(from));
  }

  double jump = 0, mean = 0;

 private:
  Relighter& relighter_;
  const SummedArea& light_;
  uint32_t record_;
  bool hasCells_;
  vec3 position_;
  Arc arc_;
};

TEST_P(ViewContinuityTest, AcrossEdgesAndOverVertices) {
  Relighter lights = relighter();
  int lit = 0;
  for (uint32_t r = 0; r < baked_.asset.records.size(); r += 3)
    for (uint32_t v = 0; v < sphere_.viewCount(); v += 7)
      for (const uint32_t w : sphere_.adjacent(v)) {
        const asset::TexelRecord& record = baked_.asset.records[r];
        const vec3 a = sphere_.directions()[w], over = sphere_.directions()[v];
        const vec3 b = glm::normalize(2.0f * glm::dot(a, over) * over - a + 0.05f * glm::cross(a, over));
        const vec3 normal(record.normal[0], record.normal[1], record.normal[2]);
        if (glm::dot(a, normal) < 0.1f || glm::dot(b, normal) < 0.1f) continue;
        Sweep sweep(lights, light_, r, record, {a, b});
        sweep.find();
        // A quarter of a thousandth of a degree is left of the step. An arc may have light at one end alone:
        // the slope there is no matter of the mean.
        EXPECT_LT(sweep.jump, 0.005 * (sweep.mean + 1e-3))
            << "record " << r << ", from view " << w << " over " << v;
        lit += sweep.mean > 1e-3;
      }
  EXPECT_GT(lit, 150);
  EXPECT_EQ(baked_.asset.scheme, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Schemes, ViewContinuityTest,
                         ::testing::Values(asset::Scheme::sketch, asset::Scheme::split, asset::Scheme::cells),
                         [](const auto& test) { return std::string(asset::schemeName(test.param)); });

}  // namespace
