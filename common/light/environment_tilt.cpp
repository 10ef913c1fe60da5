// SPDX-License-Identifier: Apache-2.0
#include "common/light/environment_tilt.h"

#include <cmath>
#include <map>

#include "common/base/cli.h"
#include "common/light/environment.h"
#include "common/light/light_domain.h"
#include "common/light/light_map.h"

namespace boxlight {
namespace {

constexpr double kCeiling = 64.0;     // times the mean
constexpr int kTiltCorrections = 16;  // of a column; atan of a device may be off by 2^-11
constexpr double radians(float degrees) { return double(degrees) * kPiDouble / 180.0; }

/// About axis (i, i + 1, i + 2 = axis) by the right-hand rule.
dmat3 rotation(int axis, double angle) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  dmat3 m(1.0);
  m[a][a] = m[b][b] = std::cos(angle);
  m[a][b] = std::sin(angle);
  m[b][a] = -std::sin(angle);
  return m;
}

vec2 onCircle(double angle) { return {float(std::cos(angle)), float(std::sin(angle))}; }
double phiOf(double u) { return 2.0 * kPiDouble * (u - 0.5); }

/// The k-th of n directions of equal solid angle from the upper edge of row y to its lower one.
double stratumCosine(double y, double height, double k, double n) {
  const double top = std::cos(kPiDouble * y / height), bottom = std::cos(kPiDouble * (y + 1.0) / height);
  return top + (bottom - top) * (k + 0.5) / n;
}

/// The texel that contains a direction. `guess` comes from inexact functions; products and comparisons with
/// the edges decide.
uint32_t findRow(const TiltTables& tables, float y) {
  const int last = int(tables.rowEdges.size()) - 2;
  int row = std::clamp(int(std::acos(std::clamp(y, -1.0f, 1.0f)) / kPi * float(last + 1)), 0, last);
  while (row > 0 && y > tables.rowEdges[size_t(row)]) --row;
  while (row < last && y <= tables.rowEdges[size_t(row) + 1]) ++row;
  return uint32_t(row);
}

/// Is the direction on the far side of the edge, counter-clockwise?
bool isPast(vec2 edge, float x, float z) { return edge.x * z - edge.y * x >= 0.0f; }

uint32_t findColumn(const TiltTables& tables, float x, float z) {
  const int count = int(tables.columnEdges.size());
  int column = std::clamp(int((0.5f + std::atan2(z, x) / (2.0f * kPi)) * float(count)), 0, count - 1);
  for (int k = 0; k < kTiltCorrections && !isPast(tables.columnEdges[size_t(column)], x, z); ++k)
    column = (column + count - 1) % count;
  for (int k = 0; k < kTiltCorrections && isPast(tables.columnEdges[size_t((column + 1) % count)], x, z); ++k)
    column = (column + 1) % count;
  return uint32_t(column);
}

/// Pieces of a highlight's texel each way: an eighth of a texel of the map.
uint32_t piecesPerAxis(uint32_t image, uint32_t map) {
  return std::clamp((8 * map + image - 1) / image, 4u, 64u);
}

uint32_t samplesFor(uvec2 image, uvec2 map) {
  const uint32_t ratio = std::max(image.x / map.x, image.y / map.y);
  return ratio <= 2 ? 4 : ratio <= 4 ? 8 : 16;
}

/// Adds `energy`, radiance times steradian, of texel (x, y) of the image piece by piece.
void spread(const Image& environment, uint32_t x, uint32_t y, dvec3 energy, uvec2 map, const dmat3& tilted,
            const std::vector<double>& solidAngles, std::map<uint32_t, dvec3>& highlights) {
  const uint32_t columns = piecesPerAxis(environment.width, map.x),
                 rows = piecesPerAxis(environment.height, map.y);
  for (uint32_t j = 0; j < rows; ++j)
    for (uint32_t i = 0; i < columns; ++i) {
      const double c = stratumCosine(y, environment.height, j, rows), ring = std::sqrt(1.0 - c * c);
      const double phi = phiOf((x + (i + 0.5) / columns) / environment.width);
      const dvec3 d = tilted * dvec3(ring * std::cos(phi), c, ring * std::sin(phi));
      const double u = 0.5 + std::atan2(d.z, d.x) / (2.0 * kPiDouble),
                   v = std::atan2(std::hypot(d.x, d.z), d.y) / kPiDouble;
      const uint32_t column = std::min(uint32_t(u * map.x), map.x - 1),
                     row = std::min(uint32_t(v * map.y), map.y - 1);
      highlights[row * map.x + column] += energy / double(rows * columns) / solidAngles[row];
    }
}

/// kCeiling times the mean of what is below the ceiling, nearly: a sun should not count.
Rgb chooseCeiling(const Image& environment) {
  const auto solidAngles = texelSolidAngles(environment.width, environment.height);
  Rgb ceiling(kMostRadiance);
  for (int round = 0; round < 3; ++round) {
    dvec3 total(0.0);
    for (uint32_t y = 0; y < environment.height; ++y)
      for (uint32_t x = 0; x < environment.width; ++x)
        total += solidAngles[y] * dvec3(glm::min(rgbAt(environment, x, y), ceiling));
    ceiling = Rgb(kCeiling / (4.0 * kPiDouble) * total);
  }
  return ceiling;
}

/// Mean over the samples of texel (x, y) of the map.
Rgb meanOfSamples(const Image& environment, const TiltTables& tables, const glm::mat3& toImage, Rgb ceiling,
                  uint32_t x, uint32_t y) {
  const uint32_t n = tables.samplesPerAxis;
  Rgb sum(0.0f);
  for (uint32_t j = 0; j < n; ++j) {
    Rgb rowSum(0.0f);
    for (uint32_t i = 0; i < n; ++i) {
      const vec2 column = tables.columns[x * n + i], row = tables.rows[y * n + j];
      const vec3 d(row.y * column.x, row.x, row.y * column.y);
      const vec3 e = (toImage[0] * d.x + toImage[1] * d.y) + toImage[2] * d.z;
      rowSum += glm::min(rgbAt(environment, findColumn(tables, e.x, e.z), findRow(tables, e.y)), ceiling);
    }
    sum += rowSum;
  }
  return sum * (1.0f / float(n * n));
}

}  // namespace

void addTurnOptions(CLI::App& app, float& rotationDegrees, EnvironmentTilt& tilt) {
  const auto add = [&](const char* name, float& value, const char* help) {
    app.add_option(name, value, help)->check(inRange(-1e6, 1e6))->option_text("DEG");
  };
  add("--env-rotation", rotationDegrees,
      "Turn the environment about +Y, in degrees counter-clockwise seen from above; after pitch and roll");
  add("--env-pitch", tilt.pitch, "Turn it about +X, counter-clockwise seen from +X; after roll");
  add("--env-roll", tilt.roll, "Turn it about +Z, counter-clockwise seen from +Z; first of the three");
}

dmat3 untilt(EnvironmentTilt tilt) {
  return rotation(2, -radians(tilt.roll)) * rotation(0, -radians(tilt.pitch));
}

dmat3 worldToEnvironment(EnvironmentTilt tilt, float rotationDegrees) {
  return untilt(tilt) * rotation(1, -radians(rotationDegrees));
}

TiltTables makeTiltTables(uvec2 image, uvec2 map) {
  TiltTables tables;
  const uint32_t n = tables.samplesPerAxis = samplesFor(image, map);
  for (uint32_t i = 0; i < map.x * n; ++i)
    tables.columns.push_back(onCircle(phiOf((i + 0.5) / double(map.x * n))));
  for (uint32_t y = 0; y < map.y; ++y)
    for (uint32_t j = 0; j < n; ++j) {
      const double c = stratumCosine(y, map.y, j, n);
      tables.rows.emplace_back(float(c), float(std::sqrt(1.0 - c * c)));
    }
  for (uint32_t x = 0; x < image.x; ++x) tables.columnEdges.push_back(onCircle(phiOf(double(x) / image.x)));
  for (uint32_t y = 0; y <= image.y; ++y)
    tables.rowEdges.push_back(float(std::cos(kPiDouble * double(y) / image.y)));
  return tables;
}

TiltedLight splitHighlights(const Image& environment, uvec2 map, EnvironmentTilt tilt) {
  TiltedLight light{chooseCeiling(environment), {}};
  const auto imageAngles = texelSolidAngles(environment.width, environment.height),
             mapAngles = texelSolidAngles(map.x, map.y);
  const dmat3 tilted = glm::transpose(untilt(tilt));
  std::map<uint32_t, dvec3> highlights;
  for (uint32_t y = 0; y < environment.height; ++y)
    for (uint32_t x = 0; x < environment.width; ++x) {
      const Rgb radiance = rgbAt(environment, x, y), above = radiance - glm::min(radiance, light.ceiling);
      if (maxComponent(above) > 0.0f)
        spread(environment, x, y, imageAngles[y] * dvec3(above), map, tilted, mapAngles, highlights);
    }
  for (const auto& [texel, radiance] : highlights)
    light.highlights.push_back({texel, float(radiance.x), float(radiance.y), float(radiance.z)});
  return light;
}

Image makeTiltedMap(const Image& environment, uvec2 size, EnvironmentTilt tilt) {
  const TiltTables tables = makeTiltTables({environment.width, environment.height}, size);
  const TiltedLight light = splitHighlights(environment, size, tilt);
  const glm::mat3 toImage(untilt(tilt));
  Image map = makeImage(size.x, size.y, 3);
  for (uint32_t y = 0; y < size.y; ++y)
    for (uint32_t x = 0; x < size.x; ++x) {
      const Rgb mean = meanOfSamples(environment, tables, toImage, light.ceiling, x, y);
      for (int c = 0; c < 3; ++c) map.at(x, y)[c] = mean[c];
    }
  for (const Highlight& h : light.highlights) {
    float* texel = &map.pixels[size_t(h.texel) * 3];
    texel[0] += h.red, texel[1] += h.green, texel[2] += h.blue;
  }
  return map;
}

}  // namespace boxlight
