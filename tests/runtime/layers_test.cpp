// SPDX-License-Identifier: Apache-2.0
// Blended layers against compositing by hand. Quads are unlit, so a quad's colour is known, unless a test
// says otherwise.
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

/// A rectangle over x, z in [-1,1]; its height runs from `left` at x = -1 to `right` at x = 1. Front up.
struct Quad {
  float left, right;
  vec4 color;  // alpha 1 with `opaque`
  bool opaque = false;
};

const Rgb kLight(0.5f, 1.0f, 0.25f);

Square unlitSquare(const std::vector<Quad>& quads) {
  Square square;
  square.cells.clear();
  for (const Quad& quad : quads) {
    asset::Material material = square.material;
    for (int c = 0; c < 4; ++c) material.baseColor[c] = quad.color[c];
    material.flags = asset::kUnlit | (quad.opaque ? 0u : uint32_t(asset::kAlphaBlend));
    square.cells.push_back(material);
  }
  square.extensions.resize(quads.size());
  return square;
}

/// The square's cell once for each quad, drawn in their order.
asset::Asset stack(const Square& square, const std::vector<Quad>& quads) {
  asset::Asset asset = square.makeAsset();
  const auto corners = asset.vertices;
  asset.vertices.clear();
  asset.triangles.clear();
  for (uint32_t q = 0; q < quads.size(); ++q) {
    for (asset::Vertex vertex : corners) {
      vertex.position[1] = vertex.position[0] < 0 ? quads[q].left : quads[q].right;
      asset.vertices.push_back(vertex);
    }
    asset.triangles.push_back({{4 * q, 4 * q + 2, 4 * q + 1}, q});
    asset.triangles.push_back({{4 * q, 4 * q + 3, 4 * q + 2}, q});
  }
  asset.info.boundsMin[1] = -1;
  asset.info.boundsMax[1] = 1;
  return asset;
}

PackedBox wholeSphere(uint32_t, uint32_t, uint32_t) { return packBox({0, 0, 1, 1, Rgb(1)}); }

/// Front to back over what lies behind, premultiplied.
vec4 composite(const std::vector<vec4>& layers, vec4 behind) {
  glm::dvec4 sum(0.0);
  double left = 1;
  for (const vec4 layer : layers) {
    sum += left * double(layer.a) * glm::dvec4(dvec3(layer), 1.0);
    left *= 1.0 - double(layer.a);
  }
  return sum + left * glm::dvec4(behind);
}

const vec4 kRed(1, 0, 0, 0.5f), kGreen(0, 1, 0, 0.25f), kBlue(0, 0, 1, 0.75f), kGrey(0.5f, 0.5f, 0.5f, 1);

class LayersTest : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    settings_.camera = cameraAbove(4);
    settings_.background = false;
  }
  asset::AssetReader write(const std::vector<Quad>& quads) {
    return writeSynthetic(file("layers.ptb"), stack(unlitSquare(quads), quads), wholeSphere);
  }
  Image render(const asset::AssetReader& reader) {
    gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({64, 32}, kLight), settings_);
    counts_ = renderer.counts();
    return renderer.picture();
  }
  static void expectPixel(const Image& image, uint32_t x, uint32_t y, vec4 expected) {
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(image.at(x, y)[c], expected[c], 2e-5f) << x << "," << y << " channel " << c;
  }
  static void expectEverywhere(const Image& image, vec4 expected) {
    for (uint32_t i = 0; i < image.width * image.height; ++i)
      expectPixel(image, i % image.width, i / image.width, expected);
  }

  gpu::FrameSettings settings_;
  gpu::FrameCounts counts_;
};

TEST_F(LayersTest, ThreeQuadsInWrongOrder) {
  const auto reader = write({{0.2f, 0.2f, kGreen}, {0.1f, 0.1f, kBlue}, {0.3f, 0.3f, kRed}});
  expectEverywhere(render(reader), composite({kRed, kGreen, kBlue}, vec4(0)));
  EXPECT_EQ(counts_.layers, 3u);
  EXPECT_EQ(counts_.cutLayerSamples, 0u);
  settings_.background = true;
  expectEverywhere(render(reader), composite({kRed, kGreen, kBlue}, vec4(kLight, 1)));
}

TEST_F(LayersTest, BeforeAndBehindAnOpaqueOne) {
  const auto reader =
      write({{0.3f, 0.3f, kRed}, {0.1f, 0.1f, kBlue}, {0.2f, 0.2f, kGrey, true}, {0.25f, 0.25f, kGreen}});
  expectEverywhere(render(reader), composite({kRed, kGreen}, kGrey));
  EXPECT_EQ(counts_.layers, 2u);
}

TEST_F(LayersTest, QuadsThatIntersect) {
  const Image image = render(write({{-0.4f, 0.4f, kRed}, {0.4f, -0.4f, kGreen}, {0, 0, kBlue}}));
  for (uint32_t y = 0; y < 4; ++y) {
    expectPixel(image, 0, y, composite({kGreen, kBlue, kRed}, vec4(0)));
    expectPixel(image, 3, y, composite({kRed, kBlue, kGreen}, vec4(0)));
  }
}

TEST_F(LayersTest, AtTheSameDepthTheLaterOneLiesInFront) {
  expectEverywhere(render(write({{0, 0, kRed}, {0, 0, kGreen}, {0, 0, kBlue}})),
                   composite({kBlue, kGreen, kRed}, vec4(0)));
  expectEverywhere(render(write({{0, 0, kRed}, {0, 0, kGrey, true}})), composite({kRed}, kGrey));
}

TEST_F(LayersTest, WhatIsBeyondTheLimitIsLeftOutAndCounted) {
  settings_.layerLimit = 2;
  const auto reader =
      write({{0, 0, kGrey, true}, {0.1f, 0.1f, kBlue}, {0.2f, 0.2f, kGreen}, {0.3f, 0.3f, kRed}});
  expectEverywhere(render(reader), composite({kRed, kGreen}, kGrey));
  EXPECT_EQ(counts_.layers, 2u);
  EXPECT_EQ(counts_.cutLayerSamples, 4u * 4 * 4);
  settings_.layerLimit = 3;
  expectEverywhere(render(reader), composite({kRed, kGreen, kBlue}, kGrey));
  EXPECT_EQ(counts_.cutLayerSamples, 0u);
}

TEST_F(LayersTest, NothingBehindAlphaOneAndNothingAtAlphaZero) {
  const vec4 solid(1, 1, 0, 1), none(1, 1, 1, 0);
  expectEverywhere(
      render(write({{0, 0, kRed}, {0.1f, 0.1f, solid}, {0.2f, 0.2f, none}, {0.3f, 0.3f, kGreen}})),
      composite({kGreen, solid}, vec4(0)));
  EXPECT_EQ(counts_.layers, 2u);
}

TEST_F(LayersTest, TheBackOfASingleSidedOneIsNotThere) {
  const std::vector<Quad> quads = {{0, 0, kRed}, {0.1f, 0.1f, kGreen}};
  Square square = unlitSquare(quads);
  square.cells[1].flags |= asset::kDoubleSided;
  const auto reader = writeSynthetic(file("sides.ptb"), stack(square, quads), wholeSphere);
  settings_.camera.eye.y = -10;
  settings_.camera.forward.y = 1;
  settings_.camera.right.x = -1;
  expectEverywhere(render(reader), composite({kGreen}, vec4(0)));
}

TEST_F(LayersTest, AlphaOfATextureAtFullResolution) {
  const std::vector<Quad> quads = {{0, 0, kGrey, true}, {0.1f, 0.1f, vec4(1, 0, 0, 0.8f)}};
  Square square = unlitSquare(quads);
  square.texels = {0x40FFFFFFu, 0xFFFFFFFFu, 0x00FFFFFFu, 0x80FFFFFFu};
  square.textures = {{2, 2, 0, asset::Wrap::repeat, asset::Wrap::repeat, 0, 1, 2}};
  square.cells[1].baseColorTexture = {0, 0, 1};
  square.transforms = {{{{1, 0, 0.5f}, {0, 1, 0}}}};  // the left column on the right
  const Image image = render(writeSynthetic(file("texture.ptb"), stack(square, quads), wholeSphere));
  const float alphas[4] = {1.0f, 64.0f / 255, 128.0f / 255, 0};
  for (uint32_t i = 0; i < 4; ++i)
    for (uint32_t k = 0; k < 4; ++k)
      expectPixel(image, 2 * (i % 2) + k % 2, 2 * (i / 2) + k / 2,
                  composite({vec4(1, 0, 0, 0.8f * alphas[i])}, kGrey));
  settings_.camera = cameraAbove(1);  // all four in one pixel, one sample each
  vec4 mean(0);
  for (const float alpha : alphas) mean += 0.25f * composite({vec4(1, 0, 0, 0.8f * alpha)}, kGrey);
  expectPixel(render(writeSynthetic(file("texture.ptb"), stack(square, quads), wholeSphere)), 0, 0, mean);
}

// Lit quads, each from texels of its own, which nothing shows but the layers.
TEST_F(LayersTest, EachLayerIsShadedAtItsOwnRecords) {
  const std::vector<Quad> quads = {
      {0, 0, vec4(1), true}, {0.1f, 0.1f, vec4(1, 1, 1, 0.5f)}, {0.2f, 0.2f, vec4(1, 1, 1, 0.25f)}};
  Square square = unlitSquare(quads);
  for (auto& material : square.cells) material.flags &= ~uint32_t(asset::kUnlit);
  asset::Asset asset = stack(square, quads);
  for (size_t v = 0; v < asset.vertices.size(); ++v)
    asset.vertices[v].atlasUv[0] = 0.125f + 0.25f * float(v / 4);
  const Rgb radiance[3] = {{1, 0.5f, 0.25f}, {0.25f, 2, 1}, {4, 1, 0.5f}};
  const auto kernel = [&](uint32_t, uint32_t record, uint32_t) {
    return packBox({0, 0, 1, 1, radiance[std::min(record % square.atlasEdge / 2, 2u)]});
  };
  const auto reader = writeSynthetic(file("lit.ptb"), asset, kernel);
  gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({64, 32}, Rgb(1)), settings_);
  expectEverywhere(renderer.picture(),
                   composite({vec4(radiance[2], 0.25f), vec4(radiance[1], 0.5f)}, vec4(radiance[0], 1)));
  EXPECT_EQ(renderer.readVisible().size(), 3u * 2 * 8);
}

TEST_F(LayersTest, ImageTilesJoinWithoutATrace) {
  const auto reader =
      write({{-0.4f, 0.4f, kRed}, {0.4f, -0.4f, kGreen}, {-0.2f, -0.2f, kGrey, true}, {0, 0, kBlue}});
  settings_.camera.eye = {0.5f, 3, 1};
  settings_.camera.tanHalfFov = 0.6f;
  settings_.camera.size = {50, 41};
  settings_.samples = 3;
  settings_.background = true;
  const Image whole = render(reader);
  settings_.tileEdge = 17;
  const Image joined = render(reader);
  for (uint32_t i = 0; i < 50 * 41; ++i)
    for (int c = 0; c < 4; ++c)
      ASSERT_EQ(joined.at(i % 50, i / 50)[c], whole.at(i % 50, i / 50)[c]) << i % 50 << "," << i / 50;
  EXPECT_EQ(counts_.layers, 3u);
}

}  // namespace
}  // namespace boxlight
