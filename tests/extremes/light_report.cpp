// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/light_report.h"

#include <fmt/format.h>

#include <cmath>

#include "common/light/light_map.h"

namespace boxlight::test {
namespace {

constexpr double kSmallest = 0x1p-100;  // radiance times steradian: fixed_point.cpp

std::vector<GridBox> otherBoxes() {
  std::vector<GridBox> all;
  for (const BoxKind& kind : boxKinds()) all.insert(all.end(), kind.boxes.begin(), kind.boxes.end());
  return all;
}

/// The darkest lit texel, which has the largest relative bound.
double worstTexelBound(const Image& map) {
  const auto solidAngles = texelSolidAngles(map.width, map.height);
  const double total = totalEnergy(map).y;
  double worst = 0;
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 0; x < map.width; ++x)
      if (const double light = double(map.at(x, y)[1]) * solidAngles[y]; light > 0)
        worst = std::max(worst, bound(light, total, gpu::SatScheme::compact) / light);
  return worst;
}

double worstFloatTexel(const Image& map) {
  const FloatTable table(map);
  double worst = 0;
  for (uint32_t y = 0; y < map.height; ++y) {
    const double solidAngle = texelSolidAngles(map.width, map.height)[y];
    for (uint32_t x = 0; x < map.width; ++x)
      if (const double light = double(map.at(x, y)[1]) * solidAngle; light > 0)
        worst = std::max(worst, std::abs(table.texel(x, y) / light - 1));
  }
  return worst;
}

ReportRow measure(gpu::Device& device, const ExtremeMap& map) {
  static const auto texels = texelBoxes(), others = otherBoxes();
  ReportRow row{map.name, worstTexelBound(map.image)};
  row.fp32 = worstFloatTexel(map.image);
  for (const auto scheme : {gpu::SatScheme::compact, gpu::SatScheme::exact}) {
    LightProbe probe(device, map.image, {{map.image.width, map.image.height}, scheme});
    const Errors single = errorsOf(map.image, texels, probe.integrate(texels), scheme);
    const Errors other = errorsOf(map.image, others, probe.integrate(others), scheme);
    (scheme == gpu::SatScheme::compact ? row.compact : row.exact) = single.worst;
    (scheme == gpu::SatScheme::compact ? row.anyCompact : row.anyExact) = other.worst;
    row.bounded = row.bounded && single.bounded && other.bounded;
  }
  return row;
}

}  // namespace

double bound(double integral, double total, gpu::SatScheme scheme) {
  return kRounded * integral + (scheme == gpu::SatScheme::compact ? std::ldexp(total, -41) : 0) + kSmallest;
}

Errors errorsOf(const Image& map, const std::vector<GridBox>& boxes, const std::vector<Integral>& found,
                gpu::SatScheme scheme) {
  const double total = totalEnergy(map).y;
  Errors errors;
  for (size_t i = 0; i < boxes.size(); ++i) {
    const ExactSum exact = exactSum(map, boxes[i]);
    const double error = std::abs(double((long double)(found[i].light.y) - exact.light));
    const double angle = std::abs(double((long double)(found[i].solidAngle) / exact.solidAngle - 1));
    // Not "error > bound": NaN is not bounded either.
    const bool kept = error <= bound(double(exact.light), total, scheme) && angle <= kRounded;
    errors.bounded = errors.bounded && kept;
    if (exact.light > 0) errors.worst = std::max(errors.worst, error / double(exact.light));
  }
  return errors;
}

std::vector<ReportRow> measureLight(gpu::Device& device) {
  std::vector<ReportRow> rows;
  for (const ExtremeMap& map : extremeMaps()) rows.push_back(measure(device, map));
  return rows;
}

std::string toMarkdown(const std::vector<ReportRow>& rows) {
  std::string text =
      "| light map, 512 x 256 | bound | 42 bits | 64 bits | fp32 | other boxes: 42 bits | 64 bits |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const ReportRow& r : rows)
    text += fmt::format("| {} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} |\n", r.map, r.bound,
                        r.compact, r.exact, r.fp32, r.anyCompact, r.anyExact);
  return text;
}

}  // namespace boxlight::test
