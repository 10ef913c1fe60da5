// SPDX-License-Identifier: Apache-2.0
// One kernel looked at alone is the one that a bake of the whole scene stores, and its figures are true.
#include "bake/study/kernel_study.h"

#include <gtest/gtest.h>

#include "bake/kernels/scene_bake.h"
#include "bake/study/kernel_drawing.h"
#include "bake/study/kernel_report.h"
#include "common/base/error.h"
#include "tests/support/scenes.h"

using namespace boxlight;

namespace {

constexpr uint32_t kSize = 8;

/// A shiny floor with a wall: most texels see both light and surface.
class KernelStudyTest : public ::testing::TestWithParam<asset::Scheme> {
 protected:
  KernelStudyTest() : scene_(test::makeScene(test::metal(hasCells() ? 0.3f : 0.5f))) {
    test::addQuad(scene_, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, {0, 0}, {0.45f, 1});
    test::addQuad(scene_, {-1, 0, -1}, {2, 0, 0}, {0, 2, 0}, {0.55f, 0}, {1, 1});
    scene_.materials[0].metallic = 0.5f;
    test::finish(scene_);
    world_.emplace(scene_);
    map_ = makeTexels(scene_, kSize, kSize);
    records_ = planRecords(*world_, map_, GetParam());
  }

  static bool hasCells() { return GetParam() == asset::Scheme::cells; }

  KernelStudy study(KernelQuery query) const {
    return studyKernel(*world_, map_, records_, sphere_, options_, query);
  }

  uint32_t recordAt(uvec2 texel) const {
    uint32_t r = 0;
    while (records_[r].record.atlasX != texel.x || records_[r].record.atlasY != texel.y) ++r;
    return r;
  }

  /// The slots of a record in the pages of a whole bake.
  std::vector<PackedBox> stored(const BakedScene& baked, uint32_t stream, uint32_t record) const {
    const uint32_t tile = record / asset::kTileRecords, slot = record % asset::kTileRecords;
    const uint64_t mask = baked.asset.mask(stream, tile);
    if (!(mask >> slot & 1)) return {};
    const auto before = uint32_t(__builtin_popcountll(mask & ((uint64_t(1) << slot) - 1)));
    const uint32_t boxes = baked.asset.boxesPerKernel(stream, tile);
    const auto& page = baked.pages[stream * baked.asset.tiles.size() + tile];
    return {page.begin() + before * boxes, page.begin() + (before + 1) * boxes};
  }

  Scene scene_;
  std::optional<Intersector> world_;
  TexelMap map_;
  std::vector<RecordPlan> records_;
  ViewSphere sphere_{2};
  KernelOptions options_{64, 8, {}, 7, 2};
};

TEST_P(KernelStudyTest, BoxesAreThoseOfTheWholeBake) {
  const BakedScene baked = bakeScene(*world_, map_, records_, sphere_, options_, ProgressStyle::none);
  const uvec2 texel{1, 5};
  const uint32_t record = recordAt(texel);
  size_t compared = 0;
  for (uint32_t stream = 0; stream <= sphere_.viewCount(); ++stream) {
    const bool lambert = stream == sphere_.viewCount();
    const uint32_t first = hasCells() ? baked.asset.firstCellStream() : 0;
    const auto slots = stored(baked, lambert ? baked.asset.diffuseStream() : first + stream, record);
    if (slots.empty()) continue;
    const KernelStudy found = study({texel, false, lambert ? std::nullopt : std::optional(stream)});
    size_t next = 0, nextCosine = 0;
    for (const PackedBox& slot : slots) {
      const Box box = unpackBox(slot);
      if (isHiddenPart(slot)) {
        EXPECT_EQ(found.hiddenPart, unpackHiddenPart(slot));
      } else if (isCosineBox(slot)) {
        ASSERT_LT(nextCosine, found.cosineBoxes.size());
        EXPECT_EQ(found.cosineBoxes[nextCosine++].amplitude, unpackCosineBox(slot).amplitude);
      } else if (maxComponent(box.energy) > 0.0f) {
        ASSERT_LT(next, found.boxes.size());
        EXPECT_EQ(found.boxes[next].u0, box.u0);
        EXPECT_EQ(found.boxes[next++].energy, box.energy);
      }
    }
    EXPECT_EQ(next, found.boxes.size());
    EXPECT_EQ(nextCosine, found.cosineBoxes.size());
    compared += next + nextCosine;
  }
  EXPECT_GT(compared, 50u);
}

TEST_P(KernelStudyTest, DepositsAreWhatTheBoxesWereFittedTo) {
  const KernelStudy found = study({{1, 5}, false, std::nullopt});
  ASSERT_GT(found.cosineBoxes.size(), 1u);
  std::vector<Deposit> bounced = found.deposits;
  std::erase_if(bounced, [](const Deposit& deposit) { return deposit.straight; });
  BoxFitter fitter({.boxes = 64});
  const auto again =
      fitter.fit(bounced, found.traced, int(options_.lambertBoxes() - found.cosineBoxes.size()));
  ASSERT_EQ(again.size(), found.boxes.size());
  for (size_t j = 0; j < again.size(); ++j)
    EXPECT_EQ(unpackBox(packBox(again[j])).energy, found.boxes[j].energy) << j;
  const auto answers = probeKernel(found);
  ASSERT_EQ(answers.size(), 13u);
  EXPECT_LT(answers[0].error(), 2e-3);  // energy is kept, but for half floats
  EXPECT_GT(answers[3].paths.y, answers[4].paths.y);
  // A Lambert floor has half of its cosine-weighted sky on either side, less what the wall takes of -Z.
  EXPECT_NEAR(answers[1].paths.y, answers[2].paths.y, 0.2 * answers[1].paths.y);
  EXPECT_GT(answers[5].paths.y, answers[6].paths.y);
  for (size_t i = 1; i < 7; ++i) EXPECT_LT(answers[i].error(), 0.2) << answers[i].light;
}

TEST_P(KernelStudyTest, DrawsAndPrintsEveryBox) {
  const KernelStudy found = study({{1, 5}, false, std::nullopt});
  const auto count = [](const std::string& text, const std::string& part) {
    size_t n = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
  };
  const std::string svg = drawKernel(found);
  EXPECT_EQ(count(svg, "<circle"), found.deposits.size());
  EXPECT_GE(count(svg, "<rect"), found.boxes.size() + found.cosineBoxes.size() + 1);
  EXPECT_EQ(count(svg, "id=\"hidden\""), found.visibility ? 1u : 0u);
  const auto json = kernelToJson(found);
  EXPECT_EQ(json["boxes"].size(), found.boxes.size());
  EXPECT_EQ(json["cosineBoxes"].size(), found.cosineBoxes.size());
  EXPECT_EQ(json["record"]["split"], GetParam() != asset::Scheme::sketch);
  EXPECT_EQ(json["record"]["cells"], hasCells());
  EXPECT_EQ(count(kernelToText(found), "\n"), 7 + found.cosineBoxes.size() + found.boxes.size() + 14);
}

TEST_P(KernelStudyTest, SaysWhatThereIsInstead) {
  const auto message = [&](const KernelQuery& query) -> std::string {
    try {
      study(query);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::usage);
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(message({{8, 0}, false, {}}).find("8x8 texels"), std::string::npos);
  EXPECT_NE(message({{1, 5}, true, {}}).find("back is never seen"), std::string::npos);
  EXPECT_NE(
      message({{1, 5}, false, 42}).find(hasCells() ? "there are 42 direction cells" : "there are 42 views"),
      std::string::npos);
  uint32_t below = 0;
  while (sphere_.directions()[below].y > -0.9f) ++below;
  EXPECT_NE(message({{1, 5}, false, below}).find("below the horizon"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Schemes, KernelStudyTest,
                         ::testing::Values(asset::Scheme::sketch, asset::Scheme::split, asset::Scheme::cells),
                         [](const auto& test) { return std::string(asset::schemeName(test.param)); });

}  // namespace
