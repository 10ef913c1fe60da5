// SPDX-License-Identifier: Apache-2.0
#pragma once

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

/// A square of split records against the oracle.
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

}  // namespace boxlight
