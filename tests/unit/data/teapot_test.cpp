// SPDX-License-Identifier: Apache-2.0
#include "data/teapot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace boxlight::data {
namespace {

Chart sheetNamed(const std::string& name) {
  for (const PatchSheet& sheet : teapotSheets())
    if (sheet.name == name) return tessellate(sheet, 1, vec3(0.0f));
  ADD_FAILURE() << name;
  return {};
}

std::vector<Chart> allSheets() {
  std::vector<Chart> charts;
  for (const PatchSheet& sheet : teapotSheets()) charts.push_back(tessellate(sheet, 1, vec3(0.0f)));
  return charts;
}

TEST(Teapot, HasThePublishedPatchesAndTwoMore) {
  size_t patches = 0;
  std::set<std::array<double, 3>> points;
  for (const PatchSheet& sheet : teapotSheets())
    for (const auto& row : sheet.patches)
      for (const Patch& patch : row) {
        ++patches;
        if (std::string(sheet.name) == "mouth") continue;
        for (const auto& line : patch)
          for (const dvec3& p : line) points.insert({p.x + 0.0, p.y + 0.0, p.z + 0.0});
      }
  EXPECT_EQ(patches, 32u + 4u + 2u);  // four of the ledge, two across the mouth
  // The published list has 306 entries, of which 16 repeat the two poles and the knob's middle; ours adds 24
  // for the ledge.
  EXPECT_EQ(points.size(), 290u + 24u);
}

TEST(Teapot, SpansThePublishedBox) {
  vec3 low(1e9f), high(-1e9f);
  for (const Chart& chart : allSheets())
    for (vec3 p : chart.positions) low = glm::min(low, p), high = glm::max(high, p);
  EXPECT_NEAR(low.x, -3.0f, 0.002f);
  EXPECT_NEAR(high.x, 3.434f, 0.002f);
  EXPECT_NEAR(low.y, 0.0f, 1e-6f);
  EXPECT_NEAR(high.y, 3.15f, 1e-6f);
  EXPECT_NEAR(low.z, -2.0f, 0.002f);
  EXPECT_NEAR(high.z, 2.0f, 0.002f);
}

TEST(Teapot, NormalsAreUnitAndAgreeWithTheTriangles) {
  for (const Chart& chart : allSheets()) {
    for (vec3 n : chart.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
    for (size_t i = 0; i < chart.indices.size(); i += 3) {
      const uint32_t* t = &chart.indices[i];
      const vec3 face = glm::normalize(glm::cross(chart.positions[t[1]] - chart.positions[t[0]],
                                                  chart.positions[t[2]] - chart.positions[t[0]]));
      for (int k = 0; k < 3; ++k) ASSERT_GT(glm::dot(face, chart.normals[t[k]]), 0.5f);
    }
  }
}

TEST(Teapot, PolesPointAlongTheAxis) {
  for (const auto& [name, y] : {std::pair{"knob", 1.0f}, std::pair{"bottom", -1.0f}}) {
    const Chart chart = sheetNamed(name);
    int found = 0;
    for (size_t i = 0; i < chart.positions.size(); ++i)
      if (chart.positions[i].x == 0 && chart.positions[i].z == 0) {
        ++found;
        EXPECT_NEAR(chart.normals[i].y, y, 1e-6f) << name;
      }
    EXPECT_GT(found, 16) << name;
  }
}

/// The volume inside Newell's quarter arcs: their own area, 1/2 + 3k/5 - 3k^2/20 of a square, times the
/// integral of r^2 dz.
double sweptVolume(const PatchSheet& sheet) {
  double volume = 0;
  for (const auto& row : sheet.patches) {
    const Patch& patch = row[0];
    auto radius = [](dvec3 p) { return std::hypot(p.x, p.y); };
    // The second point of an arc is k of a tangent away from the first.
    const double k = glm::distance(patch[1][1], patch[1][0]) / radius(patch[1][0]);
    const double area = double(row.size()) * (0.5 + 0.6 * k - 0.15 * k * k);
    auto at = [&](double v) {
      const double s = 1 - v;
      return s * s * s * patch[0][0] + 3 * s * s * v * patch[1][0] + 3 * s * v * v * patch[2][0] +
             v * v * v * patch[3][0];
    };
    constexpr int kSteps = 4000;
    for (int i = 0; i < kSteps; ++i) {
      const dvec3 a = at(double(i) / kSteps), b = at(double(i + 1) / kSteps), middle = at((i + 0.5) / kSteps);
      volume += area * radius(middle) * radius(middle) * (a.z - b.z);
    }
  }
  return volume;
}

TEST(Teapot, PotIsClosedAndFacesOut) {
  Chart pot;
  for (const char* name : {"front", "back", "bottom", "knob", "lid"}) appendChart(pot, sheetNamed(name));
  // Every directed edge (by position) has its reverse.
  using Edge = std::array<float, 6>;
  std::map<Edge, int> count;
  auto key = [&](uint32_t a, uint32_t b) {
    const vec3 p = pot.positions[a] + 0.0f, q = pot.positions[b] + 0.0f;
    return Edge{p.x, p.y, p.z, q.x, q.y, q.z};
  };
  for (size_t i = 0; i < pot.indices.size(); i += 3)
    for (int k = 0; k < 3; ++k) {
      ++count[key(pot.indices[i + k], pot.indices[i + (k + 1) % 3])];
      --count[key(pot.indices[i + (k + 1) % 3], pot.indices[i + k])];
    }
  for (const auto& [edge, balance] : count)
    ASSERT_EQ(balance, 0) << edge[0] << ' ' << edge[1] << ' ' << edge[2];
  double expected = 0;
  for (const PatchSheet& sheet : teapotSheets())
    for (const char* name : {"front", "back", "bottom", "knob", "lid"})
      if (sheet.name == std::string(name)) expected += sweptVolume(sheet);
  EXPECT_NEAR(signedVolume(pot) / expected, 1.0, 0.005);  // chords lie inside
}

TEST(Teapot, ChartsAreAsLargeAsTheirSurface) {
  for (const PatchSheet& sheet : teapotSheets()) {
    const Chart chart = tessellate(sheet, 0.5f, vec3(0.0f));
    EXPECT_NEAR(chart.size.x * chart.size.y / surfaceArea(chart), 1.0, 0.25) << sheet.name;
  }
}

}  // namespace
}  // namespace boxlight::data
