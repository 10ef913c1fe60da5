// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "bake/scene/material.h"
#include "gltf_builder.h"

namespace boxlight::test {
namespace {

constexpr float kEps = 1e-6f;

uint32_t rgba(uint32_t r, uint32_t g, uint32_t b, uint32_t a) { return r | g << 8 | b << 16 | a << 24; }

// Four texels in a row: 0, 51, 102, 255 (as linear values 0, .2, .4, 1) in red.
Scene rowOfFour(asset::Wrap wrap, bool nearest = false, bool srgb = false) {
  Scene scene;
  scene.texels = {7, rgba(0, 0, 0, 255), rgba(51, 0, 0, 255), rgba(102, 0, 0, 255), rgba(255, 0, 0, 255)};
  scene.textures.push_back({4, 1, 1, wrap, wrap, srgb, nearest, 2});
  return scene;
}
float red(const Scene& scene, float u) { return sampleTexture(scene, 0, {u, .5f}).x; }

TEST(SampleTexture, BilinearBetweenCentres) {
  const Scene scene = rowOfFour(asset::Wrap::clampToEdge);
  EXPECT_NEAR(red(scene, .125f), 0.0f, kEps);
  EXPECT_NEAR(red(scene, .375f), .2f, kEps);
  EXPECT_NEAR(red(scene, .25f), .1f, kEps);
  EXPECT_NEAR(red(scene, .375f + .25f * .75f), .35f, kEps);
}

TEST(SampleTexture, WrapModes) {
  const Scene clamp = rowOfFour(asset::Wrap::clampToEdge);
  EXPECT_NEAR(red(clamp, -5.0f), 0.0f, kEps);
  EXPECT_NEAR(red(clamp, 1.0f), 1.0f, kEps);
  EXPECT_NEAR(red(clamp, 3.0f), 1.0f, kEps);
  const Scene repeat = rowOfFour(asset::Wrap::repeat);
  EXPECT_NEAR(red(repeat, 0.0f), .5f, kEps) << "half way between the last and the first";
  EXPECT_NEAR(red(repeat, 1.0f), .5f, kEps);
  EXPECT_NEAR(red(repeat, -.625f), .2f, kEps);
  EXPECT_NEAR(red(repeat, 2.375f), .2f, kEps);
  const Scene mirror = rowOfFour(asset::Wrap::mirroredRepeat);
  EXPECT_NEAR(red(mirror, 1.0f), 1.0f, kEps);
  EXPECT_NEAR(red(mirror, 1.625f), .2f, kEps);
  EXPECT_NEAR(red(mirror, -.375f), .2f, kEps);
  EXPECT_NEAR(red(mirror, -.875f), 1.0f, kEps);
  EXPECT_NEAR(red(mirror, 2.375f), .2f, kEps);
}

TEST(SampleTexture, Nearest) {
  const Scene scene = rowOfFour(asset::Wrap::repeat, true);
  EXPECT_NEAR(red(scene, .49f), .2f, kEps);
  EXPECT_NEAR(red(scene, .51f), .4f, kEps);
  EXPECT_NEAR(red(scene, -.01f), 1.0f, kEps);
  EXPECT_NEAR(red(rowOfFour(asset::Wrap::clampToEdge, true), 1.0f), 1.0f, kEps);
}

TEST(SampleTexture, DecodesBeforeItFilters) {
  const Scene scene = rowOfFour(asset::Wrap::clampToEdge, false, true);
  const float dark = std::pow((.2f + .055f) / 1.055f, 2.4f);
  EXPECT_NEAR(red(scene, .375f), dark, 1e-5f);
  EXPECT_NEAR(red(scene, .25f), .5f * dark, 1e-5f);
  EXPECT_EQ(red(scene, .875f), 1.0f);
  EXPECT_EQ(sampleTexture(scene, 0, {.25f, .5f}).w, 1.0f);
}

TEST(SampleTexture, StaysInsideForAnyCoordinate) {
  for (const auto wrap : {asset::Wrap::repeat, asset::Wrap::clampToEdge, asset::Wrap::mirroredRepeat}) {
    for (const bool nearest : {false, true}) {
      const Scene scene = rowOfFour(wrap, nearest);
      for (const float u : {-1e-30f, -1e-8f, 1.0f - 6e-8f, -3.4e38f, 3.4e38f, 16777215.0f, -16777217.5f}) {
        const float value = red(scene, u);
        EXPECT_TRUE(value >= 0.0f && value <= 1.0f) << u;
      }
    }
  }
}

// The square of gltf_builder.h; its second triangle has the corners lower left, upper right, upper left.
const SurfacePoint kCentre = {0, {0.0f, .5f}};

TEST(SampleMaterial, FactorsTimesTexturesTimesColours) {
  GltfBuilder builder = texturedSquare({{"pbrMetallicRoughness",
                                         {{"baseColorFactor", {.5, .5, .5, .5}},
                                          {"metallicFactor", .5},
                                          {"roughnessFactor", .5},
                                          {"baseColorTexture", {{"index", 0}}},
                                          {"metallicRoughnessTexture", {{"index", 1}}}}},
                                        {"alphaMode", "MASK"},
                                        {"extensions",
                                         {{"KHR_materials_specular",
                                           {{"specularFactor", .5},
                                            {"specularTexture", {{"index", 1}}},
                                            {"specularColorFactor", {.5, 1, 2}},
                                            {"specularColorTexture", {{"index", 0}}}}}}}});
  builder.addTexture(png(1, 1, {255, 188, 0, 51}));
  builder.addTexture(png(1, 1, {9, 102, 204, 51}));
  builder.primitive()["attributes"]["COLOR_0"] =
      builder.addFloats("VEC4", {.5f, 1, 1, .5f, .5f, 1, 1, .5f, .5f, 1, 1, .5f, .5f, 1, 1, .5f});
  const Scene scene = builder.load();
  const MaterialSample m = sampleMaterial(scene, kCentre);
  const float half = std::pow((188 / 255.0f + .055f) / 1.055f, 2.4f);
  EXPECT_NEAR(m.baseColor.x, .25f, kEps);
  EXPECT_NEAR(m.baseColor.y, .5f * half, kEps);
  EXPECT_NEAR(m.baseColor.z, 0.0f, kEps);
  EXPECT_NEAR(m.alpha, .5f * .5f * .2f, kEps);
  EXPECT_NEAR(m.roughness, .5f * .4f, kEps);
  EXPECT_NEAR(m.metallic, .5f * .8f, kEps);
  EXPECT_NEAR(m.specular, .5f * .2f, kEps);
  EXPECT_NEAR(m.specularColor.x, .5f, kEps);
  EXPECT_NEAR(m.specularColor.y, half, kEps);
  EXPECT_EQ(m.tangentNormal, vec3(0, 0, 1));
  EXPECT_EQ(sampleAlpha(scene, kCentre), m.alpha);
}

TEST(SampleMaterial, OpaqueIgnoresAlpha) {
  GltfBuilder builder = texturedSquare({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, .1}}}}});
  const Scene scene = builder.load();
  EXPECT_EQ(sampleAlpha(scene, kCentre), 1.0f);
  EXPECT_EQ(sampleMaterial(scene, kCentre).alpha, 1.0f);
}

TEST(SampleMaterial, MaskFollowsTheImage) {
  GltfBuilder builder = texturedSquare(
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"alphaMode", "MASK"}});
  // Upright: left column opaque, right column clear.
  builder.addTexture(png(2, 1, {0, 0, 0, 255, 0, 0, 0, 0}), {{"wrapS", 33071}, {"magFilter", 9728}});
  const Scene scene = builder.load();
  EXPECT_EQ(sampleAlpha(scene, {0, {.9f, .05f}}), 0.0f) << "near the lower right corner";
  EXPECT_EQ(sampleAlpha(scene, {1, {.05f, .9f}}), 1.0f) << "near the upper left corner";
}

TEST(SampleMaterial, EmissionIsFactorTimesImage) {
  GltfBuilder builder =
      texturedSquare({{"emissiveTexture", {{"index", 0}}}, {"emissiveFactor", {1, .5, .25}}});
  builder.addTexture(png(1, 1, {255, 255, 0, 255}));
  EXPECT_EQ(sampleMaterial(builder.load(), kCentre).emission, Rgb(1, .5f, 0));
}

TEST(ShadingNormal, LeansWithTheNormalMap) {
  // Texel (1, .5, .5) * 2 - 1 is +X of the image, (.5, 1, .5) is up in the image.
  for (const bool up : {false, true}) {
    GltfBuilder builder = texturedSquare({{"normalTexture", {{"index", 0}}}});
    builder.addTexture(up ? png(1, 1, {128, 255, 128, 255}) : png(1, 1, {255, 128, 128, 255}));
    const Scene scene = builder.load();
    const vec3 n = shadingNormal(surfaceFrame(scene, kCentre), sampleMaterial(scene, kCentre));
    EXPECT_GT(up ? n.y : n.x, .99f) << n.x << ' ' << n.y << ' ' << n.z;
    EXPECT_NEAR(glm::length(n), 1.0f, kEps);
  }
}

TEST(ShadingNormal, ScaleFlattensIt) {
  GltfBuilder builder = texturedSquare({{"normalTexture", {{"index", 0}, {"scale", .5}}}});
  builder.addTexture(png(1, 1, {255, 128, 255, 255}));
  const Scene scene = builder.load();
  const vec3 n = sampleMaterial(scene, kCentre).tangentNormal;
  const float y = (128 / 255.0f * 2 - 1) * .5f;
  EXPECT_LT(glm::length(n - glm::normalize(vec3(.5f, y, 1.0f))), kEps);
}

TEST(SurfaceFrame, Interpolates) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["attributes"]["NORMAL"] = builder.addFloats("VEC3", {0, 0, 1, 1, 0, 0, 0, 1, 0});
  const Scene scene = builder.load();
  const SurfaceFrame frame = surfaceFrame(scene, {0, {.25f, .25f}});
  EXPECT_LT(glm::length(frame.position - vec3(.25f, .25f, 0)), kEps);
  EXPECT_LT(glm::length(frame.geometricNormal - vec3(0, 0, 1)), kEps);
  EXPECT_LT(glm::length(frame.normal - glm::normalize(vec3(1, 1, 2))), kEps);
  EXPECT_NEAR(glm::dot(vec3(frame.tangent), frame.normal), 0.0f, kEps);
  EXPECT_NEAR(glm::length(vec3(frame.tangent)), 1.0f, kEps);
}

TEST(SurfaceFrame, TinyTrianglesAndOpposedNormalsStayFinite) {
  GltfBuilder builder = oneTriangle();
  builder.primitive()["attributes"]["NORMAL"] = builder.addFloats("VEC3", {1, 0, 0, -1, 0, 0, 0, 0, 1});
  builder.json["nodes"][0]["scale"] = {1e-25, 1e-25, 1e-25};
  const SurfaceFrame frame = surfaceFrame(builder.load(), {0, {.5f, 0.0f}});
  EXPECT_EQ(frame.geometricNormal, vec3(0, 0, 1));
  EXPECT_EQ(frame.normal, vec3(0, 0, 1));
  EXPECT_NEAR(glm::length(vec3(frame.tangent)), 1.0f, kEps);
}

}  // namespace
}  // namespace boxlight::test
