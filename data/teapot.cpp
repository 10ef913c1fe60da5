// SPDX-License-Identifier: Apache-2.0
//
// The control points are M. Newell's ("The Utilization of Procedure Models in Digital Image Synthesis", PhD
// thesis, University of Utah, 1975), as published by F. Crow ("The Origins of the Teapot", IEEE Computer
// Graphics and Applications 7(1), 1987). His 306 points obey two rules, so that a few rows of numbers say
// them all:
// - body, lid and bottom are profiles (radius, z) swept around the axis by four quarter arcs, whose control
// points are
//   (r, 0) (r, k r) (k r, r) (0, r), with k = .56 everywhere but at the lid's knob;
// - handle and spout are half tubes (x, 0, z) (x, w, z) (x', w, z') (x', 0, z'), and their mirror images at y
// = 0.
#include "data/teapot.h"

#include <cmath>

namespace boxlight::data {
namespace {

struct ProfilePoint {
  double radius, z;
  double arc = 0.56;
};
using Profile = std::array<ProfilePoint, 4>;

/// A cross-section: the line where the atlas is cut, the line opposite, and half the width between them.
struct TubeRow {
  double xSeam, zSeam, xFar, zFar, halfWidth;
};
using Tube = std::array<TubeRow, 4>;

// From the inside of the rim down to the foot, over the outside.
constexpr Profile kRim = {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}};
constexpr Profile kUpperBody = {{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}};
constexpr Profile kLowerBody = {{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}};
constexpr Profile kBottom = {{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0}, {0, 0}}};
constexpr Profile kKnob = {{{0, 3.15}, {0.8, 3.15, 0.5625}, {0, 2.85}, {0.2, 2.7}}};
constexpr Profile kLid = {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}};
// Ours: from the lid's edge straight out to the rim.
constexpr Profile kLedge = {{{1.3, 2.4}, {1.3 + 0.1 / 3, 2.4}, {1.4 - 0.1 / 3, 2.4}, {1.4, 2.4}}};

// From the body outwards, cut on the inside of the grip.
constexpr Tube kHandleTop = {{{-1.6, 2.025, -1.5, 2.25, 0.3},
                              {-2.3, 2.025, -2.5, 2.25, 0.3},
                              {-2.7, 2.025, -3, 2.25, 0.3},
                              {-2.7, 1.8, -3, 1.8, 0.3}}};
constexpr Tube kHandleBottom = {{{-2.7, 1.8, -3, 1.8, 0.3},
                                 {-2.7, 1.575, -3, 1.35, 0.3},
                                 {-2.5, 1.125, -2.65, 0.9375, 0.3},
                                 {-2, 0.9, -1.9, 0.6, 0.3}}};
// From the mouth into the body, cut on the underside.
constexpr Tube kSpoutLip = {{{3.2, 2.4, 2.8, 2.4, 0.15},
                             {3.45, 2.5125, 2.9, 2.475, 0.15},
                             {3.525, 2.49375, 2.8, 2.475, 0.25},
                             {3.3, 2.4, 2.7, 2.4, 0.25}}};
constexpr Tube kSpout = {{{3.3, 2.4, 2.7, 2.4, 0.25},
                          {2.4, 2.025, 2.3, 2.1, 0.25},
                          {3.1, 0.825, 2.6, 1.425, 0.66},
                          {1.7, 0.6, 1.7, 1.425, 0.66}}};

/// One quarter of a profile's sweep; quarter 0 starts at -X, where the handle hides the seam.
Patch sweptPatch(const Profile& profile, int quarter) {
  Patch patch;
  for (int row = 0; row < 4; ++row) {
    const auto [r, z, k] = profile[row];
    const dvec3 arc[4] = {{-r, 0, z}, {-r, k * r, z}, {-k * r, r, z}, {0, r, z}};
    for (int column = 0; column < 4; ++column) {
      dvec3 p = arc[column];
      for (int turn = 0; turn < quarter; ++turn) p = {p.y, -p.x, p.z};
      patch[row][column] = p;
    }
  }
  return patch;
}

/// Half a tube: side -1 runs from the seam over -Y to the far line, +1 back over +Y.
Patch tubePatch(const Tube& tube, int side) {
  Patch patch;
  for (int row = 0; row < 4; ++row) {
    const TubeRow& r = tube[row];
    const double w = side * r.halfWidth;
    const dvec3 arc[4] = {
        {r.xSeam, 0, r.zSeam}, {r.xSeam, w, r.zSeam}, {r.xFar, w, r.zFar}, {r.xFar, 0, r.zFar}};
    for (int column = 0; column < 4; ++column) patch[row][column] = arc[side < 0 ? column : 3 - column];
  }
  return patch;
}

struct Quarters {
  int first = 0, count = 4;
};

PatchSheet sweep(const char* name, std::initializer_list<Profile> profiles, std::vector<uint32_t> segments,
                 Quarters quarters = {}) {
  PatchSheet sheet{name, {}, std::move(segments), 16};
  for (const Profile& profile : profiles) {
    auto& row = sheet.patches.emplace_back();
    for (int k = 0; k < quarters.count; ++k) row.push_back(sweptPatch(profile, quarters.first + k));
  }
  return sheet;
}

PatchSheet tube(const char* name, const Tube& first, const Tube& second, std::vector<uint32_t> segments) {
  return {name,
          {{tubePatch(first, -1), tubePatch(first, 1)}, {tubePatch(second, -1), tubePatch(second, 1)}},
          std::move(segments),
          14};
}

/// Ours: a flat sheet across the mouth of the spout, from its middle to its first cross-section.
PatchSheet mouth() {
  const dvec3 middle(3, 0, 2.4);
  PatchSheet sheet{"mouth", {{}}, {4}, 14};
  for (int side : {-1, 1}) {
    Patch patch = tubePatch(kSpoutLip, side);
    for (int row = 3; row >= 0; --row)
      for (int column = 0; column < 4; ++column)
        patch[row][column] = glm::mix(middle, patch[0][column], row / 3.0);
    sheet.patches[0].push_back(patch);
  }
  return sheet;
}

/// Bernstein polynomials of degree 3 and their derivatives.
void bernstein(double t, double (&value)[4], double (&slope)[4]) {
  const double s = 1 - t;
  value[0] = s * s * s, value[1] = 3 * s * s * t, value[2] = 3 * s * t * t, value[3] = t * t * t;
  slope[0] = -3 * s * s, slope[1] = 3 * s * s - 6 * s * t, slope[2] = 6 * s * t - 3 * t * t,
  slope[3] = 3 * t * t;
}

struct PatchPoint {
  dvec3 position{0.0}, du{0.0}, dv{0.0}, dudv{0.0};
};

PatchPoint evaluate(const Patch& patch, double u, double v) {
  double bu[4], su[4], bv[4], sv[4];
  bernstein(u, bu, su);
  bernstein(v, bv, sv);
  PatchPoint point;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      point.position += bu[i] * bv[j] * patch[j][i];
      point.du += su[i] * bv[j] * patch[j][i];
      point.dv += bu[i] * sv[j] * patch[j][i];
      point.dudv += su[i] * sv[j] * patch[j][i];
    }
  return point;
}

/// Where a side of the patch has shrunk to a point, the derivative along it is zero and its limit just inside
/// is the mixed derivative, turned inwards: v (or u) grows away from the side at 0 and falls away from the
/// side at 1.
dvec3 patchNormal(const PatchPoint& point, double u, double v) {
  const double tiny = 1e-9;
  const dvec3 du = glm::length(point.du) > tiny ? point.du : point.dudv * (v < 0.5 ? 1.0 : -1.0);
  const dvec3 dv = glm::length(point.dv) > tiny ? point.dv : point.dudv * (u < 0.5 ? 1.0 : -1.0);
  return glm::normalize(glm::cross(du, dv));
}

/// The mean length of a patch along u and along v, and its area.
struct PatchMeasure {
  double width = 0, height = 0, area = 0;
};

PatchMeasure measure(const Patch& patch) {
  constexpr int kSteps = 32;
  constexpr double kShare = 1.0 / (kSteps * kSteps);
  PatchMeasure mean;
  for (int j = 0; j < kSteps; ++j)
    for (int i = 0; i < kSteps; ++i) {
      const PatchPoint point = evaluate(patch, (i + 0.5) / kSteps, (j + 0.5) / kSteps);
      mean.width += kShare * glm::length(point.du);
      mean.height += kShare * glm::length(point.dv);
      mean.area += kShare * glm::length(glm::cross(point.du, point.dv));
    }
  return mean;
}

vec3 toGltfAxes(dvec3 p) { return {float(p.x), float(p.z), float(-p.y)}; }

}  // namespace

std::vector<PatchSheet> teapotSheets() {
  // The body goes around in two charts: as one it would be the widest by far.
  return {sweep("front", {kRim, kUpperBody, kLowerBody}, {6, 14, 12}, {2, 2}),
          sweep("back", {kRim, kUpperBody, kLowerBody}, {6, 14, 12}, {0, 2}),
          sweep("bottom", {kBottom}, {10}),
          sweep("knob", {kKnob}, {12}),
          sweep("lid", {kLid, kLedge}, {12, 1}),
          tube("handle", kHandleTop, kHandleBottom, {14, 14}),
          tube("spout", kSpoutLip, kSpout, {12, 16}),
          mouth()};
}

Chart tessellate(const PatchSheet& sheet, float scale, vec3 origin) {
  const size_t columns = sheet.patches[0].size();
  std::vector<double> heights;
  double height = 0, width = 0, area = 0;
  for (const auto& row : sheet.patches) {
    const PatchMeasure mean = measure(row[0]);  // the patches of a row are congruent
    heights.push_back(mean.height);
    height += mean.height;
    width += mean.width * mean.height * double(columns);
    area += mean.area * double(columns);
  }
  width /= height;
  Chart chart;
  chart.size = vec2(float(width), float(height)) * scale * float(std::sqrt(area / (width * height)));
  double top = 0;
  for (size_t j = 0; j < sheet.patches.size(); top += heights[j++])
    for (size_t i = 0; i < columns; ++i) {
      const Patch& patch = sheet.patches[j][i];
      Chart part = gridChart(sheet.columnSegments, sheet.segments[j], {},
                             [&](double u, double v, vec3& position, vec3& normal) {
                               const PatchPoint point = evaluate(patch, u, v);
                               position = origin + scale * toGltfAxes(point.position);
                               normal = toGltfAxes(patchNormal(point, u, v));
                             });
      for (vec2& uv : part.atlas)
        uv = {float((double(i) + uv.x) / double(columns)), float((top + uv.y * heights[j]) / height)};
      appendChart(chart, part);
    }
  chart.texcoords = chart.atlas;
  return chart;
}

}  // namespace boxlight::data
