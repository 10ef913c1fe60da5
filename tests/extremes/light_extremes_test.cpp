// SPDX-License-Identifier: Apache-2.0
// The light's integrals on the device against long-double sums, at the ends of what light and boxes can be.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "common/light/environment.h"
#include "common/light/light_map.h"
#include "tests/extremes/light_report.h"
#include "tests/runtime/synthetic.h"

namespace boxlight::test {
namespace {

class LightExtremes : public GpuTest {};

constexpr uvec2 kSize(512, 256);

/// The cells of the rows of the page's table, by map.
std::map<std::string, std::vector<double>> pageRows(const std::string& file) {
  std::map<std::string, std::vector<double>> rows;
  std::ifstream page(file);
  for (std::string line; std::getline(page, line);) {
    std::stringstream cells(line);
    std::string cell, name;
    std::getline(cells, cell, '|');
    if (!std::getline(cells, name, '|') || name.size() < 2) continue;
    auto& row = rows[name.substr(1, name.size() - 2)];
    while (std::getline(cells, cell, '|')) row.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return rows;
}

/// Figures of another device differ in the last bits of floats.
void expectLike(double printed, double measured, const std::string& map) {
  if (std::max(printed, measured) < 2e-6) return;
  EXPECT_LT(std::abs(std::log2(printed / measured)), 1.0)
      << map << ": " << printed << " in the page, " << measured;
}

TEST_F(LightExtremes, ErrorsKeepTheirBoundsAndThePageSaysThem) {
  const auto rows = measureLight(*device_);
  const auto page = pageRows(NUMERICS_PAGE);
  for (const ReportRow& r : rows) {
    EXPECT_TRUE(r.bounded) << r.map;
    ASSERT_EQ(page.count(r.map), 1u) << "docs/numerics.md has no row for " << r.map << "; it should have:\n"
                                     << toMarkdown(rows);
    const std::vector<double>& cells = page.at(r.map);
    ASSERT_GE(cells.size(), 6u);
    const double measured[] = {r.bound, r.compact, r.exact, r.fp32, r.anyCompact, r.anyExact};
    for (size_t i = 0; i < 6; ++i) expectLike(cells[i], measured[i], r.map);
  }
}

TEST_F(LightExtremes, OneTexelUpToASunOfAMillion) {
  for (const size_t i : {0u, 1u, 2u}) {
    const ExtremeMap& map = extremeMaps()[i];
    LightProbe probe(*device_, map.image, {kSize});
    const auto found = probe.integrate(texelBoxes());
    EXPECT_LT(errorsOf(map.image, texelBoxes(), found, gpu::SatScheme::compact).worst, 1e-4) << map.name;
  }
}

/// Rotated and tilted, too: w Omega, whatever the box.
TEST_F(LightExtremes, ConstantLightGivesTheSolidAngle) {
  Image white = makeImage(64, 32, 3);
  std::fill(white.pixels.begin(), white.pixels.end(), 1.0f);
  for (const EnvironmentTilt tilt : {EnvironmentTilt{}, EnvironmentTilt{37.0f, -120.0f}})
    for (const auto scheme : {gpu::SatScheme::compact, gpu::SatScheme::exact}) {
      LightProbe probe(*device_, white, {kSize, scheme}, tilt);
      for (const BoxKind& kind : boxKinds())
        for (const float offset : {0.0f, 0.123f, 1.0f / 1024}) {
          const auto found = probe.integrate(kind.boxes, offset);
          double worst = 0;
          for (const Integral& i : found)
            worst = std::max(worst, std::abs(double(i.light.y) / double(i.solidAngle) - 1));
          // Of the smallest boxes the texel at the pole is 7e-8 of the sphere: 2^-41 of it is 7e-6 of that.
          EXPECT_LT(worst, 1e-5) << kind.name << ", offset " << offset;
        }
    }
}

/// Rectangles without area, and those that rounding pushes over an end of the domain.
TEST_F(LightExtremes, DegenerateRectanglesAreFinite) {
  for (const ExtremeMap& map : extremeMaps()) {
    LightProbe probe(*device_, map.image, {kSize});
    const auto found = probe.integrate({{0, 0, 0, 0, 1},
                                        {0.5f, 0, 0.5f, 0.25f, 0.25f},
                                        {0.5f, 0.25f, 0.5f, 0, 0.5f},
                                        {0.3f, 1, 1, 0, 0},
                                        {0.999999f, 1, 0, 1, 0},
                                        {0.2f, 1e-30f, 0.2f, 1e-30f, 0.8f},
                                        {1, 0.5f, 0.5f, 0.5f, 0},
                                        {0.1f, 1, 0.9999999f, 1e-7f, 0},
                                        {0.1f, 0.5f, 0.5f, 0.50001f, -1e-5f}},
                                       0.9999999f);
    const double total = totalEnergy(map.image).y * (1 + 1e-4);
    for (const Integral& i : found) {
      for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(i.light[c])) << map.name;
      EXPECT_LE(std::abs(double(i.light.y)), total + 1e-30) << map.name;
      EXPECT_GE(i.solidAngle, -1e-3f) << map.name;
    }
    for (const size_t empty : {0u, 1u, 2u, 3u}) EXPECT_EQ(found[empty].solidAngle, 0.0f);
  }
}

/// Averaged on the CPU to what the device holds, then on the device.
TEST_F(LightExtremes, AnEightKMapKeepsItsEnergy) {
  Image large = makeImage(8192, 4096, 3);
  for (uint32_t y = 0; y < large.height; ++y)
    for (uint32_t x = 0; x < large.width; ++x) std::fill_n(large.at(x, y), 3, float((x * 7 + y * 3) % 11));
  std::fill_n(large.at(1234, 1000), 3, 1e8f);
  const double total = totalEnergy(large).y;
  for (const EnvironmentTilt tilt : {EnvironmentTilt{}, EnvironmentTilt{20.0f, 10.0f}}) {
    LightProbe probe(*device_, large, {kSize}, tilt);
    const auto whole = probe.integrate(std::vector<GridBox>{{0, 0, 65536, 65536}});
    EXPECT_NEAR(double(whole.front().light.y) / total, 1.0, tilt.isLevel() ? 2e-6 : 1e-3);
  }
}

}  // namespace
}  // namespace boxlight::test
