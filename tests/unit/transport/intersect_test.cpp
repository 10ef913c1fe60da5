// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/intersect.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bake/transport/sampler.h"
#include "bake/transport/surface.h"
#include "tests/support/scenes.h"

using namespace boxlight;

TEST(Intersector, FindsTheNearestSurfaceFromBothSides) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  const Intersector world(scene);
  const auto above = world.intersect({{0.25f, 3, 0.25f}, {0, -1, 0}});
  ASSERT_TRUE(above);
  EXPECT_NEAR(surfaceFrame(scene, *above).position.x, 0.25f, 1e-6f);
  EXPECT_NEAR(surfaceFrame(scene, *above).geometricNormal.y, 1, 1e-6f);
  EXPECT_TRUE(world.intersect({{0, -3, 0}, {0, 1, 0}}));
  EXPECT_FALSE(world.intersect({{3, 3, 0}, {0, -1, 0}}));
  EXPECT_TRUE(world.occluded({{0, 3, 0}, {0, -1, 0}}));
  EXPECT_FALSE(world.occluded({{0, 3, 0}, {0, 1, 0}}));
}

TEST(Intersector, MaskedSurfacesAreNotThereBelowTheCutoff) {
  asset::Material material = test::lambert();
  material.flags = asset::kAlphaMask;
  material.baseColor[3] = 0.4f;
  for (float cutoff : {0.3f, 0.5f}) {
    material.alphaCutoff = cutoff;
    Scene scene = test::makeScene(material);
    test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    const Intersector world(scene);
    EXPECT_EQ(world.intersect({{0, 1, 0}, {0, -1, 0}}).has_value(), cutoff < 0.4f);
    EXPECT_EQ(world.occluded({{0, 1, 0}, {0, -1, 0}}), cutoff < 0.4f);
  }
}

// From any point of a sphere no ray into the outer hemisphere of its triangle meets the sphere again, at any
// scale and anywhere.
TEST(Intersector, OffsetsAvoidSelfShadowsAtEveryScale) {
  for (float scale : {1e-4f, 1.0f, 1e6f})
    for (float distance : {0.0f, 100.0f}) {
      Scene scene = test::makeScene(test::lambert());
      test::addSphere(scene, vec3(distance * scale, 0, 0), scale, 96);
      const Intersector world(scene);
      int shadowed = 0;
      for (uint32_t i = 0; i < 4000; ++i) {
        Sampler sampler({1, 0, 0}, i);
        const vec2 b = sampler.next2();
        const SurfacePoint point{uint32_t(sampler.next() * float(scene.triangles.size())),
                                 {b.x * 0.5f, b.y * 0.5f}};
        const SurfaceFrame frame = surfaceFrame(scene, point);
        const SurfaceView surface = viewSurface(scene, point, frame.geometricNormal);
        vec3 t, s;
        orthonormalBasis(frame.geometricNormal, t, s);
        const vec3 wi = glm::normalize(0.02f * frame.geometricNormal + t);
        shadowed += world.occluded(leaveSurface(scene, surface, wi));
      }
      EXPECT_EQ(shadowed, 0) << "scale " << scale << ", distance " << distance;
    }
}

// Where floats are as coarse as the triangles themselves: a ray may meet a neighbour, never its own triangle.
TEST(Intersector, NoRayMeetsTheTriangleItLeaves) {
  for (float scale : {1e-4f, 1.0f, 1e6f})
    for (float distance : {0.0f, 3.0f, 1e5f}) {
      Scene scene = test::makeScene(test::lambert());
      test::addSphere(scene, scale * vec3(distance, 0.3f * distance, 0), scale, 96);
      const Intersector world(scene);
      int met = 0;
      for (uint32_t i = 0; i < 10000; ++i) {
        Sampler sampler({1, 0, 0}, i);
        const vec2 b = 0.5f * sampler.next2();
        const SurfacePoint point{uint32_t(sampler.next() * float(scene.triangles.size())), b};
        const vec3 normal = surfaceFrame(scene, point).geometricNormal;
        if (!(glm::length(normal) > 0.5f)) continue;  // rounded to a line
        vec3 t, s;
        orthonormalBasis(normal, t, s);
        const float cosine = std::pow(10.0f, -4 * sampler.next()), phi = 2 * kPi * sampler.next();
        const vec3 along = std::cos(phi) * t + std::sin(phi) * s;
        const auto hit =
            world.intersect({offsetOrigin(scene, point, normal), glm::normalize(cosine * normal + along)});
        met += hit && hit->triangle == point.triangle;
      }
      EXPECT_EQ(met, 0) << "scale " << scale << ", distance " << distance;
    }
}

TEST(SurfaceView, TurnsToTheSideOfTheViewAndBendsItsNormal) {
  Scene scene = test::makeScene(test::lambert());
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  const SurfacePoint point{0, {0.25f, 0.25f}};
  EXPECT_FALSE(viewSurface(scene, point, {0, 1, 0}).back);
  const SurfaceView back = viewSurface(scene, point, {0, -1, 0});
  EXPECT_TRUE(back.back);
  EXPECT_NEAR(back.geometricNormal.y, -1, 1e-6f);
  EXPECT_NEAR(back.normal.y, -1, 1e-6f);
  for (asset::Vertex& v : scene.vertices) v.normal[0] = 0.9f, v.normal[1] = std::sqrt(1 - 0.81f);
  const vec3 wo = glm::normalize(vec3(-1, 0.1f, 0));
  EXPECT_NEAR(glm::dot(viewSurface(scene, point, wo).normal, wo), kMinimumCosine, 1e-4f);
}

// The quad's tangent is X, its front Y: the bitangent is -Z times the handedness.
TEST(SurfaceView, TurnsAnisotropyAndNormalMapsWithTheTangentFrame) {
  Scene scene = test::makeScene(test::metal(0.3f));
  asset::MaterialExtension& x = scene.materialExtensions.emplace_back();
  x.anisotropy = 1, x.anisotropyRotation = 0.5f, x.clearcoat = 1;
  scene.texels = {0xFFDA80DA,
                  0xFFDADA80};  // normals that lean by 45 degrees along the tangent, the bitangent
  for (uint32_t i : {0u, 1u})
    scene.textures.push_back({1, 1, i, asset::Wrap::repeat, asset::Wrap::repeat, 0, 0, 1});
  scene.materials[0].normalTexture.texture = 0;
  x.clearcoatNormalTexture.texture = 1;
  test::addQuad(scene, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  for (const float handedness : {1.0f, -1.0f}) {
    for (asset::Vertex& v : scene.vertices)
      v.tangent[0] = 1, v.tangent[1] = v.tangent[2] = 0, v.tangent[3] = handedness;
    const vec3 bitangent(0, 0, -handedness),
        along = std::cos(0.5f) * vec3(1, 0, 0) + std::sin(0.5f) * bitangent;
    for (const float side : {1.0f, -1.0f}) {
      const SurfaceView surface = viewSurface(scene, {0, {0.25f, 0.25f}}, {0, side, 0});
      const vec3 normal = side * glm::normalize(vec3(1, 1, 0)),
                 coat = side * glm::normalize(vec3(0, 1, 0) + bitangent);
      const vec3 inPlane = glm::normalize(along - glm::dot(along, normal) * normal);
      EXPECT_GT(glm::dot(surface.normal, normal), 0.9999f) << handedness << " " << side;
      EXPECT_GT(glm::dot(surface.toWorld(surface.coatNormal), coat), 0.9999f) << handedness << " " << side;
      EXPECT_GT(std::abs(glm::dot(surface.tangent, inPlane)), 0.9999f) << handedness << " " << side;
    }
  }
}
