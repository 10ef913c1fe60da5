// SPDX-License-Identifier: Apache-2.0
// Pictures whose every pixel is known beforehand.
#include <array>
#include <cmath>

#include "common/light/directional_albedo.h"
#include "common/light/environment.h"
#include "common/light/light_domain.h"
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

const Box kSphere{0, 0, 1, 1, Rgb(1)};  // a kernel that sees the whole sphere, energy 1

KernelSource everywhere(const Box& box) {
  return [box](uint32_t, uint32_t, uint32_t) { return box; };
}

uint32_t rgba(uint32_t r, uint32_t g, uint32_t b, uint32_t a) { return r | g << 8 | b << 16 | a << 24; }

class PictureTest : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    settings_.camera = cameraAbove(16);
  }
  Image render(const asset::AssetReader& reader, const Image& environment) {
    gpu::FrameRenderer renderer(*device_, reader, environment, settings_);
    return renderer.picture();
  }
  void expectPixel(const Image& image, uint32_t x, uint32_t y, vec4 expected, float tolerance = 2e-5f) {
    const vec4 pixel(image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2], image.at(x, y)[3]);
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(pixel[c], expected[c], tolerance * std::max(1.0f, expected[c]))
          << x << "," << y << " channel " << c;
  }
  void expectEverywhere(const Image& image, vec4 expected, float tolerance = 2e-5f) {
    for (uint32_t y = 0; y < image.height; ++y)
      for (uint32_t x = 0; x < image.width; ++x) expectPixel(image, x, y, expected, tolerance);
  }

  gpu::FrameSettings settings_;
};

TEST_F(PictureTest, LambertIsAlbedoTimesLight) {
  Square square;
  square.material.baseColor[0] = 0.8f;
  square.material.baseColor[1] = 0.4f;
  const auto reader = square.write(file("lambert.ptb"), everywhere(kSphere));
  expectEverywhere(render(reader, constantEnvironment({64, 32}, Rgb(1, 2, 3))), vec4(0.8f, 0.8f, 3.0f, 1.0f));
}

TEST_F(PictureTest, ALimitedBoxSeesTheRightDirection) {
  // One column of the atlas each: a thirty-second of the sphere around the axes of the horizon, and both
  // caps.
  const float size = 1.0f / 32, middle = 0.5f - size / 2;
  const std::array<std::pair<Box, vec3>, 6> cases = {{
      {{0.5f - size / 2, middle, size, size, Rgb(1)}, {1, 0, 0}},
      {{1.0f - size / 2, middle, size, size, Rgb(1)}, {-1, 0, 0}},  // across the seam
      {{0.75f - size / 2, middle, size, size, Rgb(1)}, {0, 0, 1}},
      {{0.25f - size / 2, middle, size, size, Rgb(1)}, {0, 0, -1}},
      {{0, 0, 1, size, Rgb(1)}, {0, 1, 0}},
      {{0, 1 - size, 1, size, Rgb(1)}, {0, -1, 0}},
  }};
  Square square;
  square.atlasEdge = 6;
  const KernelSource columns = [&](uint32_t, uint32_t record, uint32_t) { return cases[record % 6].first; };
  const auto reader = square.write(file("axis.ptb"), columns);
  settings_.camera = cameraAbove(6);
  settings_.samples = 1;  // every pixel is one texel's centre
  const Image still = render(reader, axesEnvironment({256, 128}));
  settings_.environmentDegrees = 90;
  const Image turned = render(reader, axesEnvironment({256, 128}));
  for (uint32_t x = 0; x < 6; ++x) {
    const vec3 d = cases[x].second, source(-d.z, d.y, d.x);  // Ry(-90) d
    expectPixel(still, x, 3, vec4(axesColor(d), 1));
    expectPixel(turned, x, 3, vec4(axesColor(source), 1));
  }
}

TEST_F(PictureTest, MetalIsItsDirectionalAlbedo) {
  Square square;
  square.glossyBoxes = 1;
  square.diffuseBoxes = 0;
  square.material.metallic = 1;
  square.material.roughness = 0.6f;
  square.material.baseColor[2] = 0.25f;
  const auto reader = square.write(file("metal.ptb"), everywhere(kSphere));
  settings_.camera.eye = {0, 1000, 0};  // n.v = 1 everywhere
  settings_.camera.tanHalfFov = 0.001f;
  const vec2 albedo = albedoTable().specular(0.6f, 1.0f);
  expectEverywhere(render(reader, constantEnvironment({64, 32}, Rgb(2))),
                   vec4(2.0f * (Rgb(1, 1, 0.25f) * albedo.x + albedo.y), 1), 1e-4f);
}

TEST_F(PictureTest, DielectricKeepsTheMeanFresnelFactor) {
  Square square;
  square.glossyBoxes = 1;
  square.material.specular = 0.7f;
  square.material.specularColor[1] = 30.0f;  // .04 * 30 is more than 1: clamped
  square.material.baseColor[0] = 0.5f;
  square.material.roughness = 0.3f;
  const auto reader = square.write(file("dielectric.ptb"), everywhere(kSphere));
  const float slope = 0.75f;  // a far camera that sees the square at n.v = .8
  settings_.camera.eye = 4000.0f * vec3(0, 0.8f, 0.6f);
  settings_.camera.forward = {0, -0.8f, -0.6f};
  settings_.camera.up = {0, 0.6f, -0.8f};
  settings_.camera.tanHalfFov = slope / 4000;
  const Rgb f0 = Rgb(0.04f, 1.0f, 0.04f);
  const float share = 1 - 0.7f;  // green's F0 is 1, so S has no room
  const vec2 albedo = albedoTable().specular(0.3f, 0.8f);
  const Rgb expected = Rgb(0.5f, 1, 1) * share + 0.7f * f0 * albedo.x + 0.7f * albedo.y;
  const Image light = constantEnvironment({64, 32}, Rgb(1));
  expectEverywhere(render(reader, light), vec4(expected, 1), 3e-4f);

  square.material.specularColor[1] = 1.0f;
  const float usualShare = 1 - 0.7f * (0.04f + 0.96f * albedoTable().diffuseFresnel(0.8f));
  const Rgb usual = Rgb(0.5f, 1, 1) * usualShare + 0.7f * 0.04f * albedo.x + 0.7f * albedo.y;
  expectEverywhere(render(square.write(file("usual.ptb"), everywhere(kSphere)), light), vec4(usual, 1),
                   3e-4f);
}

/// Light from 45 degrees towards +X, on a flat texel whose normal map bends towards and away from it.
TEST_F(PictureTest, NormalMapsBendDiffuseLight) {
  Square square;
  const float size = 1.0f / 64;
  const Box light{0.5f - size / 2, 0.25f - size / 2, size, size, Rgb(1, 0.5f, 0.25f)};
  square.atlasEdge = 1;
  square.texels = {rgba(166, 128, 248, 255), rgba(90, 128, 248, 255)};
  square.textures = {{2, 1, 0, asset::Wrap::clampToEdge, asset::Wrap::clampToEdge, 0, 1, 0}};
  square.material.normalTexture = {0, 0};
  const auto reader = square.write(file("bumps.ptb"), everywhere(light));
  settings_.samples = 1;
  const Image image = render(reader, constantEnvironment({64, 32}, Rgb(2)));
  for (const auto& [x, code] : {std::pair(3u, 166), std::pair(12u, 90)}) {
    const double tangent = 2.0 * code / 255 - 1, up = 2.0 * 248 / 255 - 1, side = 2.0 * 128 / 255 - 1;
    const double tilt = tangent / std::sqrt(tangent * tangent + up * up + side * side);
    expectPixel(image, x, 7, vec4(Rgb(2, 1, 0.5f) * float(1 + tilt), 1), 3e-3f);  // d = (1, 1, 0) / sqrt(2)
  }
}

TEST_F(PictureTest, TexturesAndTheirMask) {
  Square square;
  // Four quarters in sRGB, one transparent; nearest, so that every pixel is one texel.
  square.texels = {rgba(255, 0, 0, 255), rgba(0, 188, 0, 255), rgba(0, 0, 255, 255),
                   rgba(255, 255, 255, 100)};
  square.textures = {{2, 2, 0, asset::Wrap::repeat, asset::Wrap::clampToEdge, 1, 1, 0}};
  square.material.baseColorTexture = {0, 0};
  square.material.flags = asset::kAlphaMask;
  const auto reader = square.write(file("mask.ptb"), everywhere(kSphere));
  const Image light = constantEnvironment({64, 32}, Rgb(1));
  settings_.background = false;
  const Image image = render(reader, light);
  expectPixel(image, 3, 3, {1, 0, 0, 1});
  expectPixel(image, 12, 3, {0, decodeSrgb(188.0f / 255), 0, 1});
  expectPixel(image, 3, 12, {0, 0, 1, 1});
  expectPixel(image, 12, 12, {0, 0, 0, 0});
  settings_.background = true;
  expectPixel(render(reader, light), 12, 12, {1, 1, 1, 1});
}

TEST_F(PictureTest, MinifiedTexturesKeepTheirMean) {
  Square square;  // a checker of black and white texels, 64 to a pixel
  for (uint32_t i = 0; i < 64 * 64; ++i)
    square.texels.push_back((i + i / 64) % 2 ? rgba(255, 255, 255, 255) : rgba(0, 0, 0, 255));
  square.textures = {{64, 64, 0, asset::Wrap::repeat, asset::Wrap::repeat, 1, 0, 2}};
  square.material.baseColorTexture = {0, 0};
  const auto reader = square.write(file("checker.ptb"), everywhere(kSphere));
  settings_.camera = cameraAbove(4);
  expectEverywhere(render(reader, constantEnvironment({64, 32}, Rgb(1))), vec4(0.5f, 0.5f, 0.5f, 1), 5e-3f);
}

TEST_F(PictureTest, SidesAreTheirOwn) {
  Square square;
  square.twoSided = true;
  const uint32_t fronts = square.atlasEdge * square.atlasEdge;
  const KernelSource sides = [&](uint32_t, uint32_t record, uint32_t) {
    Box box = kSphere;
    box.energy = record < fronts ? Rgb(1, 0, 0) : Rgb(0, 1, 0);
    return box;
  };
  const Image light = constantEnvironment({64, 32}, Rgb(1));
  settings_.background = false;
  for (const bool doubleSided : {false, true}) {
    square.material.flags = doubleSided ? asset::kDoubleSided : 0u;
    const auto reader = square.write(file("sides.ptb"), sides);
    settings_.camera = cameraAbove(8);
    expectEverywhere(render(reader, light), vec4(1, 0, 0, 1));
    settings_.camera.eye.y = -10;
    settings_.camera.forward.y = 1;
    settings_.camera.right.x = -1;
    expectEverywhere(render(reader, light), doubleSided ? vec4(0, 1, 0, 1) : vec4(0));
  }
}

TEST_F(PictureTest, RecordsAreFilteredBetweenTexelCentres) {
  Square square;
  const KernelSource ramp = [&](uint32_t, uint32_t record, uint32_t) {
    Box box = kSphere;
    box.energy = Rgb(float(record % square.atlasEdge));
    return box;
  };
  const auto reader = square.write(file("ramp.ptb"), ramp);
  settings_.samples = 1;
  const Image image = render(reader, constantEnvironment({64, 32}, Rgb(1)));
  for (uint32_t x = 0; x < 16; ++x) {  // a pixel is half a texel
    const float position = std::clamp((float(x) + 0.5f) / 2 - 0.5f, 0.0f, 7.0f);
    expectPixel(image, x, 7, vec4(Rgb(position), 1), 1e-4f);
  }
}

TEST_F(PictureTest, BackgroundIsTheEnvironment) {
  const auto reader = Square().write(file("background.ptb"), everywhere(kSphere));
  const Image environment = axesEnvironment({64, 32});
  Camera& camera = settings_.camera;
  camera.eye = {0, 100, 0};
  camera.up = {0, 1, 0};
  camera.tanHalfFov = 1;
  settings_.samples = 1;
  const std::pair<float, vec3> views[] = {{0.0f, {1, 0, 0}}, {30.0f, {0, 0, 1}}, {270.0f, {-1, 0, 0}}};
  for (const auto& [degrees, forward] : views) {
    settings_.environmentDegrees = degrees;
    camera.forward = forward;
    camera.right = glm::cross(forward, vec3(0, 1, 0));
    const Image image = render(reader, environment);
    for (const uvec2 at : {uvec2(8, 8), uvec2(1, 3), uvec2(14, 2)}) {
      const vec3 d = camera.direction(vec2(at) + 0.5f);
      const double a = -double(degrees) * kPiDouble / 180;
      const vec3 source(float(d.x * std::cos(a) + d.z * std::sin(a)), d.y,
                        float(-d.x * std::sin(a) + d.z * std::cos(a)));
      expectPixel(image, at.x, at.y, vec4(sampleEnvironment(environment, directionToUv(source)), 1), 1e-3f);
    }
  }
}

TEST_F(PictureTest, CoverageAtEdges) {
  const auto reader = Square().write(file("edge.ptb"), everywhere(kSphere));
  settings_.camera.tanHalfFov = 0.2f;  // the square covers the middle half
  settings_.camera.size = uvec2(10);   // its edges cut pixels in half
  settings_.background = false;
  const Image image = render(reader, constantEnvironment({64, 32}, Rgb(2)));
  expectPixel(image, 5, 5, {2, 2, 2, 1});
  expectPixel(image, 2, 5, {1, 1, 1, 0.5f});  // premultiplied
  expectPixel(image, 2, 2, {0.5f, 0.5f, 0.5f, 0.25f});
  expectPixel(image, 0, 0, {0, 0, 0, 0});
}

TEST_F(PictureTest, ImageTilesJoinWithoutATrace) {
  Square square;
  square.glossyBoxes = 2;
  square.texels = {rgba(255, 0, 0, 255), rgba(0, 188, 0, 255), rgba(0, 0, 255, 255), rgba(90, 255, 255, 255)};
  square.textures = {{2, 2, 0, asset::Wrap::repeat, asset::Wrap::mirroredRepeat, 1, 0, 2}};
  square.material.baseColorTexture = {0, 0};
  square.material.specular = 1;
  const auto reader = square.write(file("tiles.ptb"), everywhere({0.3f, 0.1f, 0.5f, 0.4f, Rgb(0.7f)}));
  settings_.camera.eye = {0.5f, 3, 1};
  settings_.camera.tanHalfFov = 0.4f;
  settings_.camera.size = {50, 41};
  const Image light = axesEnvironment({64, 32});
  const Image whole = render(reader, light);
  settings_.tileEdge = 17;
  EXPECT_EQ(render(reader, light).pixels, whole.pixels);
}

}  // namespace
}  // namespace boxlight
