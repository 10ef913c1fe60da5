// SPDX-License-Identifier: Apache-2.0
// Split lobes, pixel by pixel: the lobe behind the maps of the texels around it against lobe_clip.h, and what
// takes the place of its hidden part.
#include <cmath>

#include "common/light/film_lobe.h"
#include "common/light/light_domain.h"
#include "common/light/light_map.h"
#include "common/light/lobe_boxes.h"
#include "common/light/relight.h"
#include "common/light/wide_lobe.h"
#include "shaders/shared.h"
#include "tests/runtime/pixel_model.h"
#include "tests/runtime/split_scene.h"
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

class SplitTest : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    settings_.camera = cameraAbove(32);
    settings_.camera.eye = {0.4f, 1.2f, 0.9f};
    settings_.camera.tanHalfFov = 1.0f;
    settings_.samples = 1;
    square_.atlasEdge = kEdge;
    square_.glossyBoxes = 2;
    square_.extensions.resize(1);
  }

  void use(const Finish& finish) {
    square_.material = finish.material;
    square_.extensions = {finish.extension};
    square_.textures.clear();
    square_.texels = {0xFFFFE040u};  // read where a finish refers to it
    if (finish.extension.anisotropyTexture.texture == 0)
      square_.textures = {{1, 1, 0, asset::Wrap::repeat, asset::Wrap::repeat, 0, 1, 0}};
    else
      square_.texels.clear();
  }

  bool isSplit(uint32_t record) const { return !half_ || record % 2 == 1; }

  /// What is left is a split record with a kernel for every view.
  static void takeCells(asset::Asset& asset, uint32_t record) {
    asset.records[record].flags &= ~uint32_t(asset::kDirectionCells);
    for (uint32_t s = 0; s < asset.streamCount(); ++s) {
      const uint64_t bit = uint64_t(1) << record % asset::kTileRecords;
      uint64_t& mask = asset.streamMasks[s * asset.tiles.size() + record / asset::kTileRecords];
      if (s < asset.diffuseStream()) mask |= bit;
      if (s >= asset.firstCellStream()) mask &= ~bit;
    }
  }

  static void makeWhole(asset::Asset& asset, uint32_t record) {
    asset.records[record].flags &= ~uint32_t(asset::kSplitLobe | asset::kDirectionCells);
    for (uint32_t s = asset.firstCellStream(); s < asset.streamCount(); ++s)
      asset.streamMasks[s * asset.tiles.size() + record / asset::kTileRecords] &=
          ~(uint64_t(1) << record % asset::kTileRecords);
  }

  /// Each direction cell of each record sends another colour.
  Rgb colour(vec3 direction, uint32_t record, Rgb radiance) const {
    return one_ ? radiance : radiance * (1.5f + direction) * float(1 + record % 3);
  }

  /// No light but from split lobes: kernels of a hidden part alone, or none where it is 0.
  asset::AssetReader write(float hiddenPart, Rgb hiddenRadiance) const {
    asset::Asset asset = square_.makeAsset();
    if (hiddenPart == 0)
      for (uint32_t s = 0; s < asset.diffuseStream(); ++s)
        for (size_t t = 0; t < asset.tiles.size(); ++t) asset.streamMasks[s * asset.tiles.size() + t] = 0;
    asset.visibilityMaps.clear();
    for (uint32_t r = 0; r < asset.records.size(); ++r)
      if (isSplit(r)) {
        asset.visibilityMaps.push_back(square_.visibility(r));
        if (mixed_ && r % 2 == 1) takeCells(asset, r);
      } else
        makeWhole(asset, r);
    const ViewSphere cells(std::max(square_.directionCells, 1u));
    return writeSynthetic(file("split.ptb"), asset, [&](uint32_t stream, uint32_t record, uint32_t slot) {
      if (stream == asset.diffuseStream() || !isSplit(record)) return packBox({0, 0, 1, 1, Rgb(0.0f)});
      const Rgb radiance =
          stream < asset.firstCellStream()
              ? hiddenRadiance
              : colour(cells.directions()[stream - asset.firstCellStream()], record, hiddenRadiance);
      if (maxComponent(emitted_) > 0 && slot == 0) return packEmission(emitted_);
      return slot == square_.glossyBoxes - 2 ? packHiddenPart(hiddenPart)
                                             : packBox({0, 0, 1, 1, hiddenPart * radiance});
    });
  }

  /// Where the ray through the middle of a pixel meets the square, if it does.
  std::optional<vec3> hit(uint32_t x, uint32_t y) const {
    const vec3 d = settings_.camera.direction(vec2(x, y) + 0.5f);
    const vec3 point = settings_.camera.eye - d * (settings_.camera.eye.y / d.y);
    if (!(d.y < 0) || std::max(std::abs(point.x), std::abs(point.z)) > 0.99f) return std::nullopt;
    return point;
  }

  /// `part`: of the filter, what split records have.
  FilteredVisibility mapsAround(const std::vector<VisibilityMap>& maps, vec3 point, double& part) const {
    const vec2 at = 0.5f * (vec2(point.x, point.z) + 1.0f) * float(kEdge) - 0.5f;
    const glm::ivec2 corner(glm::floor(at));
    const vec2 f = at - vec2(corner);
    FilteredVisibility filtered;
    part = 0;
    for (int k = 0; k < 4; ++k) {
      const glm::ivec2 texel = glm::clamp(corner + glm::ivec2(k & 1, k >> 1), 0, int(kEdge) - 1);
      const auto record = uint32_t(texel.y) * kEdge + uint32_t(texel.x);
      if (!isSplit(record)) continue;
      filtered.map[size_t(k)] = &maps[record];
      filtered.weight[size_t(k)] = (k & 1 ? f.x : 1 - f.x) * (k >> 1 ? f.y : 1 - f.y);
      part += double(filtered.weight[size_t(k)]);
    }
    for (float& weight : filtered.weight) weight /= float(part);
    return filtered;
  }

  /// What kernels send and the part that it stands for, where the hidden parts of a pixel's lobes point if
  /// they have any.
  using Stored = std::function<TexelRadiance(const FilteredVisibility& around, vec3 direction, bool hides)>;

  /// Of the base, by the pixel's own lobe.
  static dvec3 ownBase(const Finish& finish, const GgxLobe& lobe, const PixelFactors& f) {
    if (finish.extension.anisotropy > 0) return dvec3(lobeAlbedo(lobe));
    if (lobe.filmed) return f.base * dvec3(filmedAlbedo(lobe, vec2(f.albedo))) / f.reflected;
    return f.base;
  }

  /// Of all lobes, those of the pixel's own behind the maps.
  dvec3 gloss(const Finish& finish, vec3 view, const FilteredVisibility& around, const SummedArea& lights,
              const Stored& stored) const {
    const PixelFactors f = pixelFactors(finish.material, finish.extension, double(view.y), double(view.y));
    dvec3 total = f.glossy - f.base - f.coat, direct(0.0);
    double hidden = double(luminance(Rgb(total)));
    ClippedLobe all;
    const auto add = [&](const GgxLobe& lobe, dvec3 factor) {
      const SeenLobe seen =
          seeLobe(lobe, around, lights, double(environmentOffset(settings_.environmentDegrees)));
      direct += factor * seen.radiance;
      hidden += double(luminance(Rgb(factor))) * seen.hidden;
      all.towards += double(luminance(Rgb(factor))) * seen.towards;
      total += factor;
    };
    const GgxLobe base = lobeOf(finish, view);
    add(base, ownBase(finish, base, f));
    if (finish.extension.clearcoat > 0) add(coatOf(finish, view), f.coat);
    const double part = hidden / double(luminance(Rgb(total)));
    const TexelRadiance sent = stored(around, all.hiddenDirection(), glm::length(all.towards) > 0);
    if (!base.filmed) return total * splitRadiance(direct / total, part, sent.glossy, sent.hidden);
    return underFilm(f.glossy, total, direct, part, sent);
  }

  /// Kernels of views are divided by another colour than that of the pixel's lobes; what arrives by direction
  /// cells has none.
  dvec3 underFilm(dvec3 glossy, dvec3 total, dvec3 direct, double part, TexelRadiance sent) const {
    const dvec3 divisor = glm::max(glossy, 0.75 * total);
    const dvec3 quotient = total / divisor;
    const double own = double(luminance(Rgb(quotient)));
    if (square_.directionCells > 0) sent.glossy *= quotient, sent.hidden *= own;
    return divisor * splitRadiance(direct / divisor, part, sent.glossy, sent.hidden, own);
  }

  /// By a kernel of a view.
  static TexelRadiance sent(float hiddenPart, Rgb radiance, const SummedArea& lights) {
    return {.glossy = double(hiddenPart) * dvec3(radiance) * lights.integrate({0, 0, 1, 1}) / (4 * kPiDouble),
            .hidden = double(hiddenPart)};
  }

  /// Root of the mean square of the relative difference between the picture and lobe_clip.h.
  double compare(const Finish& finish, float hiddenPart, Rgb hiddenRadiance) {
    use(finish);
    std::vector<VisibilityMap> maps;
    for (uint32_t r = 0; r < kEdge * kEdge; ++r) maps.push_back(square_.visibility(r));
    const Image environment = skyEnvironment();
    const auto reader = write(hiddenPart, hiddenRadiance);
    gpu::FrameRenderer renderer(*device_, reader, environment, settings_);
    const SummedArea lights(makeLightMap(environment, settings_.lightSize));
    Relighter relighter(reader);
    const Stored stored = [&](const FilteredVisibility& around, vec3 direction, bool hides) {
      if (square_.directionCells == 0) return sent(hiddenPart, hiddenRadiance, lights);
      TexelRadiance mean;
      for (size_t k = 0; k < around.map.size(); ++k) {
        if (!around.map[k]) continue;
        const auto record = uint32_t(around.map[k] - maps.data());
        const bool ofViews = mixed_ && record % 2 == 1;
        const auto one = ofViews ? sent(hiddenPart, hiddenRadiance, lights)
                                 : relighter.arriving(record, direction, lights);
        if (!ofViews && !hides) continue;
        mean.glossy += double(around.weight[k]) * one.glossy;
        mean.hidden += double(around.weight[k]) * one.hidden;
      }
      return mean;
    };
    double sum = 0;
    int count = 0;
    for (uint32_t y = 0; y < settings_.camera.size.y; ++y)
      for (uint32_t x = 0; x < settings_.camera.size.x; ++x) {
        const auto point = hit(x, y);
        if (!point) continue;
        const vec3 view = glm::normalize(settings_.camera.eye - *point);
        double part = 0;
        const FilteredVisibility around = mapsAround(maps, *point, part);
        const dvec3 exact = part * gloss(finish, view, around, lights, stored);
        const float* pixel = renderer.picture().at(x, y);
        sum += std::pow(glm::length(dvec3(pixel[0], pixel[1], pixel[2]) - exact) / glm::length(exact), 2);
        ++count;
      }
    EXPECT_GT(count, 400);
    return std::sqrt(sum / count);
  }

  void expectConstant(const Finish& finish, float hiddenPart) {
    use(finish);
    const Rgb light(1, 2, 3);
    gpu::FrameRenderer renderer(*device_, write(hiddenPart, Rgb(1)), constantEnvironment({64, 32}, light),
                                settings_);
    for (uint32_t y = 0; y < settings_.camera.size.y; ++y)
      for (uint32_t x = 0; x < settings_.camera.size.x; ++x) {
        const auto point = hit(x, y);
        if (!point) continue;
        const vec3 view = glm::normalize(settings_.camera.eye - *point);
        const double cosine = double(view.y);
        PixelFactors f = pixelFactors(finish.material, finish.extension, cosine, cosine);
        if (finish.extension.iridescence > 0) f.glossy += ownBase(finish, lobeOf(finish, view), f) - f.base;
        const dvec3 exact = f.glossy * dvec3(light);
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(renderer.picture().at(x, y)[c], exact[c], 5e-4 * exact[c]) << x << ' ' << y;
      }
  }

  gpu::FrameSettings settings_;
  Square square_;
  bool half_ = false;   // are records of every second column whole, and dark?
  bool mixed_ = false;  // have records of every second column kernels of views instead of direction cells?
  Rgb emitted_{0.0f};   // radiance that every hidden kernel has before its hidden part
  bool one_ = false;    // do all direction cells send the same?
};

TEST_F(SplitTest, InTheOpenAPixelIsItsLobeUnderTheLight) {
  square_.visibility = [](uint32_t) { return openMap(); };
  for (const Finish& finish :
       {metal(0.05f), metal(0.3f), metal(0.6f), metal(1.0f), varnish(0.2f), metal(0.3f, 0.8f, 0.6f)})
    EXPECT_LT(compare(finish, 0, Rgb(0)), 2e-3) << finish.material.roughness;
}

TEST_F(SplitTest, MapsClipTheLobeAndKernelsFillTheRest) {
  square_.visibility = spottedMap;
  for (const Finish& finish :
       {metal(0.05f), metal(0.3f), metal(0.6f), varnish(0.4f), metal(0.2f, 0.5f, 2.0f), brushed()})
    EXPECT_LT(compare(finish, 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2) << finish.material.roughness;
}

TEST_F(SplitTest, MapsStandStillUnderALightThatTurns) {
  // Quarters of the maps' blocks count as even where the light's cells cut them.
  square_.visibility = spottedMap;
  for (const float degrees : {17.3f, 123.4f, 300.0f}) {
    settings_.environmentDegrees = degrees;
    for (const Finish& finish : {metal(0.05f), metal(0.2f), metal(0.6f), metal(1.0f)})
      EXPECT_LT(compare(finish, 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1.5e-2)
          << degrees << ' ' << finish.material.roughness;
  }
}

TEST_F(SplitTest, ManySamplesOfACoatedStreakEndNoLoop) {
  // Mesa 22.3's lavapipe ends the loops of a lane after 65535 rounds of all of them.
  square_.visibility = spottedMap;
  Finish finish = brushed();
  finish.material.roughness = 0.15f;
  finish.material.normalTexture = {0, 0, 0};  // samples of bumpy surfaces are shaded one by one
  finish.extension.clearcoat = 1;
  finish.extension.clearcoatRoughness = 0.2f;
  use(finish);
  const auto reader = write(0.4f, Rgb(0.2f, 0.1f, 0.4f));
  settings_.camera = cameraAbove(8);
  const Image one = gpu::FrameRenderer(*device_, reader, skyEnvironment(), settings_).picture();
  settings_.samples = 8;
  const Image many = gpu::FrameRenderer(*device_, reader, skyEnvironment(), settings_).picture();
  for (uint32_t i = 0; i < one.pixels.size(); ++i)
    EXPECT_NEAR(many.pixels[i], one.pixels[i], 0.15f * one.pixels[i] + 0.05f) << i / 4;
}

TEST_F(SplitTest, CoatsAreLobesOfTheirOwnAndOthersComeFromKernels) {
  square_.visibility = spottedMap;
  for (const Finish& finish : {coated(0.5f), velvet(), frosted()})
    EXPECT_LT(compare(finish, 0.4f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2) << finish.material.roughness;
}

TEST_F(SplitTest, AConstantLightIsConstantWhateverIsHidden) {
  square_.visibility = spottedMap;
  for (Finish finish : {metal(0.5f), coated(0.4f), frosted()})
    for (const float hiddenPart : {0.0f, 0.25f}) {
      // Grey: what is hidden is one number for all colours.
      std::fill_n(finish.material.baseColor, 3, 0.8f);
      expectConstant(finish, hiddenPart);
    }
}

TEST_F(SplitTest, UnderAFilmPixelsAreTheirOwnLobesAndKernelsFillTheRest) {
  square_.visibility = spottedMap;
  for (const Finish& finish : {filmedMetal(0.1f), filmedMetal(0.4f), filmedVarnish(0.3f), filmedMetal(0.25f)})
    for (const uint32_t frequency : {0u, 3u}) {
      square_.directionCells = frequency;
      EXPECT_LT(compare(finish, 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2)
          << frequency << ' ' << finish.material.roughness;
    }
}

TEST_F(SplitTest, UnderAFilmAConstantLightIsItsReflectanceWhateverIsHidden) {
  square_.visibility = spottedMap;
  one_ = true;
  Finish finish = filmedMetal(0.4f);
  finish.extension.iridescenceThickness[1] = 1e5f;  // grey: without interference
  for (const uint32_t frequency : {0u, 2u})
    for (const float hiddenPart : {0.0f, 0.25f}) {
      square_.directionCells = frequency;
      expectConstant(finish, hiddenPart);
    }
}

/// A mirror in the open has no kernel at all: its pools are empty.
TEST_F(SplitTest, WithoutAnyKernelsAPixelIsItsLobe) {
  square_.visibility = [](uint32_t) { return openMap(); };
  square_.diffuseBoxes = 0;
  Finish finish = metal(0.3f);
  std::fill_n(finish.material.baseColor, 3, 0.8f);
  expectConstant(finish, 0);
}

TEST_F(SplitTest, BesideWholeLobesSplitOnesHaveTheirPart) {
  square_.visibility = spottedMap;
  half_ = true;
  EXPECT_LT(compare(metal(0.4f), 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2);
}

TEST_F(SplitTest, DirectionCellsAreReadWhereTheHiddenPartPoints) {
  square_.visibility = spottedMap;
  for (const uint32_t frequency : {1u, 3u, 8u}) {
    square_.directionCells = frequency;
    for (const Finish& finish : {metal(0.05f), metal(0.3f), coated(0.3f)})
      EXPECT_LT(compare(finish, 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2)
          << frequency << ' ' << finish.material.roughness;
  }
}

TEST_F(SplitTest, DirectionCellsThatSendOneLightAreAViewsKernel) {
  square_.visibility = spottedMap;
  square_.directionCells = 2;
  Finish finish = metal(0.3f);
  std::fill_n(finish.material.baseColor, 3, 0.8f);
  one_ = true;
  expectConstant(finish, 0.25f);
}

TEST_F(SplitTest, DirectionCellsSendWhatEmittersSend) {
  square_.visibility = spottedMap;
  square_.directionCells = 3;
  square_.glossyBoxes = 3;
  emitted_ = Rgb(0.5f, 2.0f, 0.1f);
  EXPECT_LT(compare(metal(0.3f), 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2);
}

TEST_F(SplitTest, BesideOtherRecordsDirectionCellsHaveTheirPart) {
  square_.visibility = spottedMap;
  square_.directionCells = 3;
  mixed_ = true;
  EXPECT_LT(compare(metal(0.3f), 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2) << "beside kernels of views";
  mixed_ = false, half_ = true;
  EXPECT_LT(compare(metal(0.4f), 0.25f, Rgb(0.2f, 0.1f, 0.4f)), 1e-2) << "beside whole lobes";
}

TEST_F(SplitTest, SmallTexelBuffersLeaveThePictureAsItIs) {
  square_.visibility = spottedMap;
  use(coated(0.4f));
  const auto reader = write(0.4f, Rgb(0.2f, 0.1f, 0.4f));
  ASSERT_TRUE(device_->limits().texelBuffers);
  const Image large = gpu::FrameRenderer(*device_, reader, skyEnvironment(), settings_).picture();
  device_ = std::make_unique<gpu::Device>(gpu::DeviceOptions{"", true, false});
  ASSERT_FALSE(device_->limits().texelBuffers);
  const Image small = gpu::FrameRenderer(*device_, reader, skyEnvironment(), settings_).picture();
  EXPECT_EQ(large.pixels, small.pixels);
}

TEST_F(SplitTest, ThePictureOfAnAssetWithoutSplitLobesNeedsNoMaps) {
  settings_.camera = cameraAbove(16);
  const auto whole = square_.write(file("whole.ptb"), [](uint32_t, uint32_t, uint32_t) {
    return Box{0, 0, 1, 1, Rgb(0.5f)};
  });
  square_.visibility = [](uint32_t) { return openMap(); };
  gpu::FrameRenderer plain(*device_, whole, skyEnvironment(), settings_);
  gpu::FrameRenderer split(*device_, write(0.5f, Rgb(0)), skyEnvironment(), settings_);
  EXPECT_EQ(
      split.counts().sceneBytes - plain.counts().sceneBytes,
      kEdge * kEdge *
          (sizeof(uint32_t) * (1 + gpu::kMapBlockWords + gpu::kMapQuarterWords) + sizeof(VisibilityMap)));
}

}  // namespace
}  // namespace boxlight
