// SPDX-License-Identifier: Apache-2.0
// Cameras inside the object: a closed cube around the eye, whose walls are seen from within.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "tests/extremes/extreme_maps.h"
#include "tests/extremes/view_extremes.h"

namespace boxlight::test {
namespace {

constexpr uint32_t kEdge = 8;  // texels of a wall, each way
constexpr std::array<vec3, 6> kNormals = {vec3(1, 0, 0),  vec3(-1, 0, 0), vec3(0, 1, 0),
                                          vec3(0, -1, 0), vec3(0, 0, 1),  vec3(0, 0, -1)};

/// The square's frame, turned so that its front looks along `normal` and moved by `place`.
struct Wall {
  vec3 tangent, normal, bitangent, place;
  Wall(vec3 n, vec3 p) : tangent(n.y, n.z, n.x), normal(n), bitangent(glm::cross(tangent, n)), place(p) {}

  void turn(float* v, vec3 offset) const {
    const vec3 turned = v[0] * tangent + v[1] * normal + v[2] * bitangent + offset;
    for (int k = 0; k < 3; ++k) v[k] = turned[k];
  }
};

enum class Front { inwards, outwards };

void addWall(asset::Asset& room, const asset::Asset& square, const Wall& wall, uint32_t index) {
  const auto firstVertex = uint32_t(room.vertices.size()), firstRecord = uint32_t(room.records.size());
  for (asset::Vertex vertex : square.vertices) {
    wall.turn(vertex.position, wall.place);
    wall.turn(vertex.normal, {});
    wall.turn(vertex.tangent, {});
    vertex.atlasUv[1] = (vertex.atlasUv[1] + float(index)) / float(kNormals.size());
    room.vertices.push_back(vertex);
  }
  for (asset::Triangle triangle : square.triangles) {
    for (uint32_t& vertex : triangle.vertex) vertex += firstVertex;
    room.triangles.push_back(triangle);
  }
  for (asset::TexelRecord record : square.records) {
    wall.turn(record.position, wall.place);
    wall.turn(record.normal, {});
    wall.turn(record.tangent, {});
    record.atlasY += index * kEdge;
    room.records.push_back(record);
  }
  for (asset::AtlasTexel texel : square.atlas) {
    for (uint32_t* record : {&texel.front, &texel.back})
      if (*record != asset::kNone) *record += firstRecord;
    room.atlas.push_back(texel);
  }
}

/// The cube [-1,1]^3, its walls one below the other in the atlas.
asset::Asset makeRoom(const Square& square, Front front) {
  const asset::Asset one = square.makeAsset();
  asset::Asset room = one;
  room.vertices.clear(), room.triangles.clear(), room.records.clear(), room.atlas.clear();
  room.info.atlasHeight = uint32_t(kNormals.size()) * kEdge;
  room.info.boundsMin[1] = -1, room.info.boundsMax[1] = 1;
  for (uint32_t i = 0; i < kNormals.size(); ++i)
    addWall(room, one, {kNormals[i], (front == Front::inwards ? -1.0f : 1.0f) * kNormals[i]}, i);
  tileRecords(room, square.glossyBoxes, square.diffuseBoxes);
  return room;
}

class InsideExtremes : public ViewExtremes {
 protected:
  InsideExtremes() {
    square_.atlasEdge = kEdge;
    settings_.samples = 1;
  }

  asset::AssetReader write(Front front, const KernelSource& kernel) const {
    return writeSynthetic(file("room.ptb"), makeRoom(square_, front),
                          [&](uint32_t stream, uint32_t record, uint32_t slot) {
                            return packBox(kernel(stream, record, slot));
                          });
  }

  /// Pictures from `eye` along every one of the directions.
  void look(const asset::AssetReader& reader, const Image& environment, vec3 eye,
            const std::function<void(const Image&)>& see) {
    std::optional<gpu::FrameRenderer> renderer;
    for (const vec3 forward : {vec3(1, 0, 0), vec3(0, -1, 0), vec3(0, 0, 1), vec3(-1, 1, -1)}) {
      settings_.camera = cameraAlong(eye, forward, 48, 100.0f);
      if (renderer)
        renderer->set(settings_), renderer->run();
      else
        renderer.emplace(*device_, reader, environment, settings_);
      SCOPED_TRACE(fmt::format("eye {} {} {}, forward {} {} {}", eye.x, eye.y, eye.z, forward.x, forward.y,
                               forward.z));
      see(renderer->picture());
    }
  }

  /// Of all pixels under a white sky.
  void expectEverywhere(const asset::AssetReader& reader, vec3 eye, vec4 expected, float tolerance) {
    look(reader, constantEnvironment({64, 32}, Rgb(1)), eye, [&](const Image& picture) {
      for (size_t i = 0; i < picture.pixels.size(); ++i)
        ASSERT_NEAR(picture.pixels[i], expected[int(i % 4)], tolerance) << i;
    });
  }

  Square square_;
};

TEST_F(InsideExtremes, WallsAsTheOracleHasThem) {
  square_.glossyBoxes = 3;
  const auto boxes = boxKinds().back().boxes;
  const auto reader = write(Front::inwards, [&](uint32_t stream, uint32_t record, uint32_t slot) {
    return boxOf(boxes[(stream + 5 * record + 23 * slot) % boxes.size()],
                 Rgb(1.0f / float(1 + (stream + slot) % 5)));
  });
  for (const vec3 eye : {vec3(0), vec3(0.999f, -0.999f, 0.999f), vec3(-0.2f, 0.9999f, 0.3f)})
    for (const vec3 forward : {vec3(-1, 1, -1), vec3(1, -0.1f, 0.2f)}) {
      settings_.camera = cameraAlong(eye, forward, 64, 120.0f);
      EXPECT_LT(worstAgainstOracle(reader, extremeMaps()[1].image), 1e-4) << eye.x << " " << forward.x;
    }
}

/// No gap at the cube's edges, whose two walls meet there, and constant light exact on each.
TEST_F(InsideExtremes, WallsWithoutGaps) {
  const auto boxes = boxKinds().back().boxes;
  const auto reader = write(Front::inwards, [&](uint32_t, uint32_t record, uint32_t) {
    return boxOf(boxes[record % boxes.size()], Rgb(1));
  });
  settings_.background = false;
  for (const vec3 eye : {vec3(0), vec3(0.9f, -0.8f, 0.7f)}) expectEverywhere(reader, eye, vec4(1), 1e-5f);
}

/// glTF's rule: what is not double-sided is not there from behind.
TEST_F(InsideExtremes, BacksOfSingleSidedWallsAreNotSeen) {
  const auto reader = write(Front::outwards, [](uint32_t, uint32_t, uint32_t) {
    return Box{0, 0, 1, 1, Rgb(0.25f)};
  });
  expectEverywhere(reader, vec3(0), vec4(1), 1e-6f);  // the light itself
  settings_.background = false;
  expectEverywhere(reader, vec3(0), vec4(0), 0.0f);
}

/// Sides that no light reaches have no records: black, and in the way of what is behind.
TEST_F(InsideExtremes, SidesWithoutRecordsAreBlack) {
  square_.material.flags = asset::kDoubleSided;
  const auto reader = write(Front::outwards, [](uint32_t, uint32_t, uint32_t) {
    return Box{0, 0, 1, 1, Rgb(0.25f)};
  });
  expectEverywhere(reader, vec3(0.3f, 0.2f, -0.1f), vec4(0, 0, 0, 1), 0.0f);
}

/// In a wall's plane, on an edge, in a corner, and at the very place of a record, where its direction to the
/// eye is 0 / 0: a record's place is the mean of its texel, which a curved surface passes by.
TEST_F(InsideExtremes, EyesOnTheSurfaceItself) {
  square_.glossyBoxes = 3;
  square_.material.flags = asset::kDoubleSided;
  square_.twoSided = true;
  square_.material.metallic = square_.material.specular = 1;
  asset::Asset room = makeRoom(square_, Front::inwards);
  for (asset::TexelRecord& record : room.records)
    for (int k = 0; k < 3; ++k) record.position[k] *= 0.9f;
  const auto reader = writeSynthetic(file("room.ptb"), room, [](uint32_t stream, uint32_t, uint32_t slot) {
    return packBox({0.01f * float(stream), 0.1f * float(slot), 0.3f, 0.2f, Rgb(1)});
  });
  const auto& p = room.records[4 * kEdge * kEdge + 27].position;  // of the floor
  ASSERT_FLOAT_EQ(p[1], -0.9f);
  for (const vec3 eye : {vec3(0, -1, 0), vec3(1, -1, 0.3f), vec3(1, 1, 1), vec3(p[0], p[1], p[2])})
    look(reader, extremeMaps()[2].image, eye, [](const Image& picture) {
      float brightest = 0;
      for (const float value : picture.pixels) {
        ASSERT_TRUE(std::isfinite(value));
        ASSERT_GE(value, -1e-3f);
        brightest = std::max(brightest, value);
      }
      EXPECT_GT(brightest, 1e-3f);
    });
}

}  // namespace
}  // namespace boxlight::test
