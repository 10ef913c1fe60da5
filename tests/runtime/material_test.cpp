// SPDX-License-Identifier: Apache-2.0
// Every term of the pixel: cells of one square, each with a material of its own, from both sides.
#include <cmath>

#include "tests/runtime/pixel_model.h"
#include "tests/runtime/synthetic.h"

namespace boxlight {
namespace {

// What the kernels return under a white light: the front and the back of the square.
const Rgb kLambert[2] = {{0.875f, 0.75f, 0.5f}, {0.25f, 0.5f, 0.375f}};
const Rgb kGloss[2] = {{0.625f, 0.4375f, 1.0f}, {0.5f, 0.75f, 0.25f}};

// Texture values, beside a white texel that nothing should show.
constexpr uint32_t kCodes[4] = {51, 102, 153, 204};
constexpr uint32_t kWhite = 0xFFFFFFFFu, kTexel = 51 | 102 << 8 | 153 << 16 | 204u << 24;
constexpr uint32_t kBentCodes[3] = {128, 204, 230};  // a normal bent towards the bitangent
constexpr uint32_t kBent = 128 | 204 << 8 | 230 << 16 | 0xFFu << 24;
enum : uint32_t { kLinear, kSrgb, kNormalMap };  // textures
enum : uint16_t { kNoTransform, kToTexel };      // transforms

struct Case {
  asset::Material material;
  asset::MaterialExtension extension;
  asset::Material seen;  // with its textures multiplied in
  asset::MaterialExtension seenExtension;
  bool bentNormal = false;
  float bentCoat = 0;  // the scale of its normal map
};

Case plainCase() {
  Case c;
  c.material.metallic = 0;
  c.material.roughness = 0.4f;
  c.material.baseColor[1] = 0.5f;
  c.material.baseColor[2] = 0.25f;
  c.material.flags = asset::kDoubleSided;
  return c;
}

template <class Change>
Case with(Change&& change) {
  Case c = plainCase();
  change(c.material, c.extension);
  c.seen = c.material;
  c.seenExtension = c.extension;
  return c;
}

void everything(asset::Material& m, asset::MaterialExtension& x) {
  m.metallic = 0.3f, m.specular = 0.8f, m.specularColor[2] = 0.5f;
  m.flags |= asset::kMultipleScattering;
  x.ior = 1.8f, x.anisotropy = 0.6f, x.clearcoat = 0.7f, x.clearcoatRoughness = 0.3f;
  x.sheenColor[0] = 0.9f, x.sheenColor[2] = 0.3f, x.sheenRoughness = 0.5f;
  x.transmission = 0.4f, x.diffuseTransmission = 0.5f, x.diffuseTransmissionColor[1] = 0.5f;
  x.iridescence = 0.6f;
  x.emissive[0] = 2.0f, x.emissive[2] = 0.25f;
}

asset::TextureRef transformed(uint32_t texture) { return {texture, 1, kToTexel}; }

/// Everything, every factor with its texture.
Case texturedCase() {
  Case c = with(everything);
  const auto linear = [](int channel) { return float(kCodes[channel]) / 255.0f; };
  auto& m = c.material;
  auto& x = c.extension;
  for (auto* ref : {&m.metallicRoughnessTexture, &m.specularTexture, &x.anisotropyTexture,
                    &x.clearcoatTexture, &x.clearcoatRoughnessTexture, &x.sheenRoughnessTexture,
                    &x.transmissionTexture, &x.diffuseTransmissionTexture})
    *ref = transformed(kLinear);
  for (auto* ref : {&m.baseColorTexture, &m.specularColorTexture, &x.sheenColorTexture,
                    &x.diffuseTransmissionColorTexture, &x.emissiveTexture})
    *ref = transformed(kSrgb);
  auto& n = c.seen;
  auto& y = c.seenExtension;
  n.roughness *= linear(1), n.metallic *= linear(2), n.specular *= linear(3);
  y.anisotropy *= linear(2), y.clearcoat *= linear(0), y.clearcoatRoughness *= linear(1);
  y.sheenRoughness *= linear(3), y.transmission *= linear(0), y.diffuseTransmission *= linear(3);
  for (int i = 0; i < 3; ++i)
    for (float* color : {n.baseColor, n.specularColor, y.sheenColor, y.diffuseTransmissionColor, y.emissive})
      color[i] *= decodeSrgb(linear(i));
  return c;
}

std::vector<Case> makeCases() {
  using asset::Material;
  using Extension = asset::MaterialExtension;
  std::vector<Case> cases = {
      with([](Material&, Extension&) {}),
      with([](Material&, Extension& x) { x.ior = 2; }),
      with([](Material& m, Extension& x) { x.ior = 0, m.specularColor[0] = 0.5f; }),
      with([](Material& m, Extension& x) { m.metallic = 1, x.anisotropy = 0.8f; }),
      with([](Material&, Extension& x) { x.clearcoat = 1, x.clearcoatRoughness = 0.2f; }),
      with([](Material& m, Extension& x) {
        x.clearcoat = 0.5f, m.normalTexture = {kNormalMap, 0, 0};
      }),
      with([](Material&, Extension& x) {
        x.clearcoat = 1, x.clearcoatNormalTexture = {kNormalMap, 0, 0}, x.clearcoatNormalScale = 0.5f;
      }),
      with([](Material&, Extension& x) { x.sheenColor[0] = 0.75f, x.sheenRoughness = 0.6f; }),
      with([](Material&, Extension& x) { x.transmission = 0.7f; }),
      with([](Material&, Extension& x) {
        x.diffuseTransmission = 0.6f, x.diffuseTransmissionColor[0] = 0.5f;
      }),
      with([](Material&, Extension& x) { x.emissive[0] = 3, x.emissive[1] = 0.5f, x.clearcoat = 0.8f; }),
      with([](Material& m, Extension& x) { m.flags |= asset::kUnlit, x.diffuseTransmission = 0.5f; }),
      with([](Material& m, Extension&) {
        m.metallic = 1, m.roughness = 0.9f, m.flags |= asset::kMultipleScattering;
      }),
      with([](Material&, Extension& x) { x.iridescence = 1, x.iridescenceThickness[1] = 350; }),
      with([](Material& m, Extension& x) {
        m.metallic = 0.6f, x.iridescence = 0.7f, x.iridescenceIor = 1.8f, x.iridescenceThickness[1] = 500;
      }),
      with(everything),
      texturedCase(),
      with([](Material& m, Extension& x) {
        m.metallic = 0.5f, m.specular = 0.6f, x.sheenColor[1] = 1, x.diffuseTransmission = 0.25f;
      })};
  cases[5].bentNormal = true;
  cases[6].bentCoat = 0.5f;
  return cases;
}

Square makeSquare(const std::vector<Case>& cases) {
  Square square;
  square.twoSided = true;
  square.glossyBoxes = 1;
  square.cellEdge = 4;
  for (const Case& c : cases) {
    square.cells.push_back(c.material);
    square.extensions.push_back(c.extension);
  }
  square.texels = {kWhite, kTexel, kBent};
  const auto clamp = asset::Wrap::clampToEdge;
  square.textures = {
      {2, 1, 0, clamp, clamp, 0, 1, 0}, {2, 1, 0, clamp, clamp, 1, 1, 0}, {1, 1, 2, clamp, clamp, 0, 1, 0}};
  square.transforms = {{{{0, 0, 0.75f}, {0, 0, 0.5f}}}};
  return square;
}

class MaterialTest : public GpuTest {
 protected:
  /// A far camera to which the whole square lies at one angle.
  Camera farCamera(float nDotV, bool below) {
    const float sine = std::sqrt(1 - nDotV * nDotV), y = below ? -nDotV : nDotV;
    Camera camera;
    camera.eye = 4000.0f * vec3(0, y, sine);
    camera.forward = -vec3(0, y, sine);
    camera.up = {0, sine, -y};
    camera.right = glm::cross(camera.forward, camera.up);
    camera.size = {16, uint32_t(16 * nDotV)};
    camera.tanHalfFov = nDotV / 4000;
    return camera;
  }
  static double bentCosine(vec3 toEye, float scale) {
    const auto decode = [](uint32_t code) { return 2 * float(code) / 255 - 1; };
    vec3 bent(decode(kBentCodes[0]) * scale, decode(kBentCodes[1]) * scale, decode(kBentCodes[2]));
    bent = glm::normalize(bent);
    // tangent +X, bitangent +Z, normal +Y; the seen side's normal is turned to the eye
    return std::max(double(glm::dot(vec3(bent.x, bent.z, bent.y), toEye)) * (toEye.y < 0 ? -1 : 1), 1e-3);
  }
  static vec3 expected(const Case& c, vec3 toEye) {
    const bool back = toEye.y < 0;
    const double plain = std::abs(double(toEye.y));
    const double nDotV = c.bentNormal ? bentCosine(toEye, 1) : plain;
    const double coat = c.bentCoat > 0 ? bentCosine(toEye, c.bentCoat) : plain;
    const PixelFactors f = pixelFactors(c.seen, c.seenExtension, nDotV, coat);
    return f.diffuse * dvec3(kLambert[back]) + f.transmitted * dvec3(kLambert[!back]) +
           f.glossy * dvec3(kGloss[back]) + f.emission;
  }
  void expectPicture(const asset::AssetReader& reader, const std::vector<Case>& cases, float nDotV,
                     bool below) {
    gpu::FrameSettings settings;
    settings.camera = farCamera(nDotV, below);
    settings.samples = 1;
    gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({64, 32}, Rgb(1)), settings);
    for (uint32_t y = 0; y < settings.camera.size.y; ++y)
      for (uint32_t x = 0; x < settings.camera.size.x; ++x) {
        const vec3 d = settings.camera.direction(vec2(x, y) + 0.5f);
        const vec3 hit = settings.camera.eye - d * (settings.camera.eye.y / d.y);
        const auto cell = uint32_t(2 * (hit.x + 1)) + 4 * uint32_t(2 * (hit.z + 1));
        const vec3 exact = expected(cases[cell], -settings.camera.forward);
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(renderer.picture().at(x, y)[c], exact[c], 5e-4f * std::max(1.0f, exact[c]))
              << "case " << cell << ", channel " << c << ", n.v " << nDotV << (below ? " below" : "");
      }
  }
};

TEST_F(MaterialTest, EveryTermFromBothSides) {
  const auto cases = makeCases();
  const Square square = makeSquare(cases);
  const uint32_t fronts = square.atlasEdge * square.atlasEdge;
  const KernelSource kernel = [&](uint32_t stream, uint32_t record, uint32_t) {
    const bool lambert = stream == 10 * square.viewFrequency * square.viewFrequency + 2;
    return Box{0, 0, 1, 1, (lambert ? kLambert : kGloss)[record >= fronts]};
  };
  const auto reader = square.write(file("cells.ptb"), kernel);
  expectPicture(reader, cases, 0.75f, false);
  expectPicture(reader, cases, 0.25f, false);
  expectPicture(reader, cases, 0.75f, true);
}

TEST_F(MaterialTest, TheOtherSideNeedsNoGloss) {
  Square square;
  square.twoSided = true;
  square.glossyBoxes = 3;
  square.diffuseBoxes = 2;
  square.extensions.resize(1);
  square.extensions[0].diffuseTransmission = 1;
  const auto reader = square.write(file("leaf.ptb"), [](uint32_t, uint32_t, uint32_t) {
    return Box{0, 0, 1, 1, Rgb(0.5f)};
  });
  gpu::FrameSettings settings;
  settings.camera = cameraAbove(16);
  gpu::FrameRenderer leaf(*device_, reader, constantEnvironment({64, 32}, Rgb(1)), settings);
  const auto visible = leaf.readVisible();
  ASSERT_EQ(visible.size(), 128u);
  for (const auto& [record, glossy] : visible) EXPECT_EQ(glossy, record < 64) << record;
  EXPECT_EQ(leaf.counts().boxes, 64u * (2 + 3) + 64u * 2);
  square.extensions[0].diffuseTransmission = 0;
  const auto opaque = square.write(file("card.ptb"), [](uint32_t, uint32_t, uint32_t) {
    return Box{0, 0, 1, 1, Rgb(0.5f)};
  });
  gpu::FrameRenderer card(*device_, opaque, constantEnvironment({64, 32}, Rgb(1)), settings);
  EXPECT_EQ(card.readVisible().size(), 64u);
  EXPECT_EQ(leaf.counts().pages, card.counts().pages + 1);  // the back's Lambert page alone
}

TEST_F(MaterialTest, ATransformedTextureIsMinified) {
  Square square;  // a checker of four texels, 64 times each way, on four pixels
  square.texels = {0xFFFFFFFFu, 0xFF000000u, 0xFF000000u, 0xFFFFFFFFu};
  square.textures = {{2, 2, 0, asset::Wrap::repeat, asset::Wrap::repeat, 0, 0, 2}};
  square.material.baseColorTexture = {0, 0, 1};
  square.transforms = {{{{0, -64, 0.1f}, {64, 0, 0.3f}}}};
  const auto reader = square.write(file("checker.ptb"), [](uint32_t, uint32_t, uint32_t) {
    return Box{0, 0, 1, 1, Rgb(1)};
  });
  gpu::FrameSettings settings;
  settings.camera = cameraAbove(4);
  gpu::FrameRenderer renderer(*device_, reader, constantEnvironment({64, 32}, Rgb(1)), settings);
  for (uint32_t i = 0; i < 16; ++i) EXPECT_NEAR(renderer.picture().at(i % 4, i / 4)[0], 0.5f, 5e-3f) << i;
}

}  // namespace
}  // namespace boxlight
