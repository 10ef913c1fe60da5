// SPDX-License-Identifier: Apache-2.0
#include "bake/study/kernel_drawing.h"

#include <fmt/format.h>

#include <cmath>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

constexpr double kWidth = 1024, kHeight = 512, kCaption = 44;

/// Rows of hidden cells as runs.
std::string drawHidden(const VisibilityMap& map) {
  constexpr double kCellWidth = kWidth / VisibilityMap::kColumns,
                   kCellHeight = kHeight / VisibilityMap::kRows;
  std::string runs;
  for (uint32_t y = 0; y < VisibilityMap::kRows; ++y)
    for (uint32_t x = 0; x < VisibilityMap::kColumns;) {
      uint32_t end = x;
      while (end < VisibilityMap::kColumns && !map.isVisible(end, y)) ++end;
      if (end > x)
        runs += fmt::format("M{} {}h{}v{}h-{}z", x * kCellWidth, y * kCellHeight, (end - x) * kCellWidth,
                            kCellHeight, (end - x) * kCellWidth);
      x = end + 1;
    }
  return fmt::format("<path id=\"hidden\" fill=\"#33383f\" d=\"{}\"/>\n", runs);
}

/// The largest channel at full, so that hue shows whatever the size.
std::string hue(Rgb color) {
  const float largest = std::max(maxComponent(color), 1e-30f);
  const auto code = [&](float c) { return int(std::lround(255 * std::pow(c / largest, 1 / 2.2f))); };
  return fmt::format("#{:02x}{:02x}{:02x}", code(color.r), code(color.g), code(color.b));
}

std::string drawDeposits(const KernelStudy& study) {
  double mean = 0;
  for (const Deposit& d : study.deposits) mean += double(luminance(d.throughput));
  mean /= std::max<double>(double(study.deposits.size()), 1);
  std::string dots = "<g id=\"deposits\" fill-opacity=\".8\">\n";
  for (const Deposit& d : study.deposits) {
    const double radius = 2 * std::sqrt(double(luminance(d.throughput)) / std::max(mean, 1e-30));
    dots += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"/>\n",
                        kWidth * double(d.uv.x), kHeight * double(d.uv.y), std::clamp(radius, 0.3, 12.0),
                        hue(d.throughput));
  }
  return dots + "</g>\n";
}

std::string rectangle(const Box& box, double u0, double opacity) {
  return fmt::format(
      "<rect x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\" fill=\"{}\" "
      "fill-opacity=\"{:.3f}\"/>\n",
      kWidth * u0, kHeight * double(box.v0), kWidth * double(box.du), kHeight * double(box.dv),
      hue(box.energy), opacity);
}

/// Those that take away are grey.
std::string drawCosineBoxes(const KernelStudy& study) {
  if (study.cosineBoxes.empty()) return "";
  std::string boxes = "<g id=\"cosine-boxes\" stroke=\"#ffc23d\" stroke-width=\"1.2\">\n";
  for (const auto& [box, amplitude] : study.cosineBoxes) {
    Box drawn = box;
    drawn.energy = Rgb(amplitude > 0.0f ? Rgb(1.0f, 0.8f, 0.2f) : Rgb(0.1f));
    const double opacity = std::min(0.3 * std::abs(double(amplitude)), 0.3);
    boxes += rectangle(drawn, double(box.u0), opacity);
    if (box.u0 + box.du > 1) boxes += rectangle(drawn, double(box.u0) - 1, opacity);
  }
  return boxes + "</g>\n";
}

/// A box over the seam is drawn at both ends.
std::string drawBoxes(const KernelStudy& study) {
  double strongest = 1e-30;
  for (const Box& box : study.boxes) strongest = std::max(strongest, double(luminance(box.weight())));
  std::string boxes = drawCosineBoxes(study) + "<g id=\"boxes\" stroke=\"#ff5a36\" stroke-width=\"1.2\">\n";
  for (const Box& box : study.boxes) {
    const double opacity = 0.5 * std::cbrt(double(luminance(box.weight())) / strongest);
    boxes += rectangle(box, double(box.u0), opacity);
    if (box.u0 + box.du > 1) boxes += rectangle(box, double(box.u0) - 1, opacity);
  }
  return boxes + "</g>\n";
}

std::string mark(vec3 direction, const char* name) {
  const dvec2 at = dvec2(directionToUv(direction)) * dvec2(kWidth, kHeight);
  return fmt::format(
      "<path d=\"M{0:.2f} {1:.2f}m-6 0h12m-6 -6v12\" stroke=\"#4fd1ff\" stroke-width=\"1.5\"/>"
      "<text x=\"{2:.2f}\" y=\"{3:.2f}\" fill=\"#4fd1ff\">{4}</text>\n",
      at.x, at.y, at.x + 7, at.y - 5, name);
}

std::string drawMarks(const KernelStudy& study) {
  const vec3 normal(study.plan.record.normal[0], study.plan.record.normal[1], study.plan.record.normal[2]);
  std::string marks = mark(normal, "n");
  if (!study.query.view) return marks;
  return marks + mark(study.viewDirection, "v") + mark(glm::reflect(-study.viewDirection, normal), "m");
}

std::string caption(const KernelStudy& study) {
  const auto& [texel, back, view] = study.query;
  std::string text =
      fmt::format("texel {},{} {}, {}: {} deposits of {} paths, {} boxes", texel.x, texel.y,
                  back ? "back" : "front", view ? fmt::format("view {}", *view) : "Lambert",
                  study.deposits.size(), study.traced, study.boxes.size() + study.cosineBoxes.size());
  if (study.hiddenPart) text += fmt::format(", hidden part {:.3f}", *study.hiddenPart);
  return fmt::format("<text x=\"8\" y=\"{}\" fill=\"#dddddd\">{}</text>\n", kHeight + 28, text);
}

}  // namespace

std::string drawKernel(const KernelStudy& study) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"16\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#14161a\"/>\n",
      kWidth, kHeight + kCaption);
  if (study.visibility) svg += drawHidden(*study.visibility);
  svg += drawDeposits(study) + drawBoxes(study) + drawMarks(study) + caption(study);
  return svg + "</svg>\n";
}

}  // namespace boxlight
