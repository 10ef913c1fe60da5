// SPDX-License-Identifier: Apache-2.0
#include "data/mesh.h"

#include <cmath>

namespace boxlight::data {

void addQuad(Chart& chart, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  const auto& p = chart.positions;
  auto add = [&](uint32_t i, uint32_t j, uint32_t k) {
    const double area = glm::length(glm::cross(dvec3(p[j]) - dvec3(p[i]), dvec3(p[k]) - dvec3(p[i])));
    const double edge = std::max(glm::length(p[j] - p[i]), glm::length(p[k] - p[i]));
    if (area > 1e-6 * edge * edge) chart.indices.insert(chart.indices.end(), {i, j, k});
  };
  if (glm::distance(p[a], p[c]) <= glm::distance(p[b], p[d])) {
    add(a, b, c);
    add(a, c, d);
  } else {
    add(a, b, d);
    add(b, c, d);
  }
}

Chart rectangleChart(vec3 corner, vec3 u, vec3 v, uint32_t segments) {
  const vec3 normal = glm::normalize(glm::cross(u, v));
  return gridChart(segments, segments, {glm::length(u), glm::length(v)},
                   [&](double s, double t, vec3& position, vec3& vertexNormal) {
                     position = corner + float(s) * u + float(t) * v;
                     vertexNormal = normal;
                   });
}

Chart sphereChart(vec3 centre, float radius, vec2 polarRange, uint32_t columns, uint32_t rows, bool inward) {
  const float span = polarRange.y - polarRange.x;
  // Area = 2 pi r^2 (cos a - cos b): the mean ring times the length of the meridian.
  const float meridian = radius * span;
  const float meanRing = 2.0f * kPi * radius * (std::cos(polarRange.x) - std::cos(polarRange.y)) / span;
  return gridChart(
      columns, rows, {meanRing, meridian}, [&](double u, double v, vec3& position, vec3& normal) {
        // Longitude runs so that d/du x d/dv points out, or in.
        const double phi = (inward ? -1.0 : 1.0) * 2.0 * kPiDouble * (u == 1.0 ? 0.0 : u);
        const double theta = polarRange.x + v * double(span);
        const bool pole = theta < 1e-6 || theta > kPiDouble - 1e-6;
        const double ring = pole ? 0.0 : std::sin(theta);
        const vec3 out(float(ring * std::cos(phi)), float(std::cos(theta)), float(ring * std::sin(phi)));
        position = centre + radius * out;
        normal = inward ? -out : out;
      });
}

Chart discChart(vec3 centre, float radius, uint32_t segments, uint32_t rings, bool up) {
  Chart chart =
      gridChart(segments, rings, vec2(2.0f * radius), [&](double u, double v, vec3& position, vec3& normal) {
        const double phi = (up ? 1.0 : -1.0) * 2.0 * kPiDouble * (u == 1.0 ? 0.0 : u);
        const double r = double(radius) * v;
        position = centre + vec3(float(r * std::cos(phi)), 0, float(r * std::sin(phi)));
        normal = {0, up ? 1.0f : -1.0f, 0};
      });
  for (size_t i = 0; i < chart.positions.size(); ++i) {
    const vec3 offset = (chart.positions[i] - centre) / (2.0f * radius);
    chart.atlas[i] = glm::clamp(vec2(0.5f + offset.x, 0.5f + offset.z), 0.0f, 1.0f);
  }
  chart.texcoords = chart.atlas;
  return chart;
}

Chart cylinderChart(vec3 base, float radius, float height, uint32_t segments) {
  return gridChart(segments, 1, {2.0f * kPi * radius, height},
                   [&](double u, double v, vec3& position, vec3& normal) {
                     const double phi = 2.0 * kPiDouble * (u == 1.0 ? 0.0 : u);
                     normal = {float(std::cos(phi)), 0, float(std::sin(phi))};
                     position = base + radius * normal + vec3(0, height * float(1.0 - v), 0);
                   });
}

void appendChart(Chart& chart, const Chart& part) {
  const auto first = uint32_t(chart.positions.size());
  auto append = [](auto& target, const auto& source) {
    target.insert(target.end(), source.begin(), source.end());
  };
  append(chart.positions, part.positions);
  append(chart.normals, part.normals);
  append(chart.texcoords, part.texcoords);
  append(chart.atlas, part.atlas);
  for (uint32_t index : part.indices) chart.indices.push_back(first + index);
}

double signedVolume(const Chart& chart) {
  double volume = 0;
  for (size_t i = 0; i < chart.indices.size(); i += 3) {
    const dvec3 a(chart.positions[chart.indices[i]]), b(chart.positions[chart.indices[i + 1]]),
        c(chart.positions[chart.indices[i + 2]]);
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return volume;
}

double surfaceArea(const Chart& chart) {
  double area = 0;
  for (size_t i = 0; i < chart.indices.size(); i += 3) {
    const dvec3 a(chart.positions[chart.indices[i]]), b(chart.positions[chart.indices[i + 1]]),
        c(chart.positions[chart.indices[i + 2]]);
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return area;
}

}  // namespace boxlight::data
