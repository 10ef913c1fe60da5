// SPDX-License-Identifier: Apache-2.0
#include "common/image/image_metrics.h"

#include <algorithm>
#include <cmath>

#include "common/base/error.h"
#include "common/image/flip.h"

namespace boxlight {
namespace {

constexpr double kRelMseEpsilon = 0.01;
constexpr uint64_t kTrimmedFraction = 1000;  // one pixel in a thousand

void checkSizes(const Image& image, const Image& reference) {
  if (image.width != reference.width || image.height != reference.height)
    fail(ExitCode::invalidInput,
         "cannot compare {}x{} pixels with a reference of {}x{}; render both at one size", image.width,
         image.height, reference.width, reference.height);
}

bool isMeasured(const Image& reference, uint32_t x, uint32_t y) {
  return !(alphaAt(reference, x, y) <= 0.5f);
}

Rgb finiteAt(const Image& image, uint32_t x, uint32_t y, const char* which) {
  const Rgb value = rgbAt(image, x, y);
  if (!std::isfinite(value.x) || !std::isfinite(value.y) || !std::isfinite(value.z) ||
      !std::isfinite(alphaAt(image, x, y)))
    fail(ExitCode::invalidInput, "pixel ({}, {}) of the {} is not finite: {} {} {}", x, y, which, value.x,
         value.y, value.z);
  return value;
}

dvec3 steps8(Rgb value) {
  return 255.0 * dvec3(encodeSrgb(value.x), encodeSrgb(value.y), encodeSrgb(value.z));
}

/// Calls visit(x, y, image's colour, reference's colour) for every measured pixel.
template <class Visit>
void forMeasured(const Image& image, const Image& reference, const Visit& visit) {
  for (uint32_t y = 0; y < reference.height; ++y)
    for (uint32_t x = 0; x < reference.width; ++x)
      if (isMeasured(reference, x, y))
        visit(x, y, finiteAt(image, x, y, "image"), finiteAt(reference, x, y, "reference"));
}

/// Sum without the largest one in a thousand.
double trimmedSum(std::vector<double> squaredErrors) {
  const size_t kept = squaredErrors.size() - squaredErrors.size() / kTrimmedFraction;
  std::sort(squaredErrors.begin(), squaredErrors.end());
  double sum = 0;
  for (size_t i = 0; i < kept; ++i) sum += squaredErrors[i];
  return sum / double(kept);
}

double alphaRmse(const Image& image, const Image& reference) {
  double squares = 0;
  for (uint32_t y = 0; y < reference.height; ++y)
    for (uint32_t x = 0; x < reference.width; ++x)
      squares += std::pow(double(alphaAt(image, x, y)) - double(alphaAt(reference, x, y)), 2);
  return std::sqrt(squares / (double(reference.width) * reference.height));
}

double sumOf(dvec3 v) { return v.x + v.y + v.z; }

double meanFlip(const Image& image, const Image& reference) {
  const std::vector<double> errors = flipMap(image, reference);
  double sum = 0, count = 0;
  for (uint32_t y = 0; y < reference.height; ++y)
    for (uint32_t x = 0; x < reference.width; ++x)
      if (isMeasured(reference, x, y)) sum += errors[size_t(y) * reference.width + x], ++count;
  return sum / count;
}

}  // namespace

ImageMetrics compareImages(const Image& image, const Image& reference) {
  checkSizes(image, reference);
  ImageMetrics m;
  m.allPixels = uint64_t(reference.width) * reference.height;
  m.byAlpha = hasAlpha(reference);
  double squares = 0, relative = 0, squares8 = 0, sum = 0, referenceSum = 0;
  std::vector<double> pixelSquares;
  forMeasured(image, reference, [&](uint32_t, uint32_t, Rgb x, Rgb r) {
    const dvec3 difference = dvec3(x) - dvec3(r), square = difference * difference;
    const dvec3 difference8 = steps8(x) - steps8(r);
    pixelSquares.push_back(sumOf(square));
    squares += sumOf(square);
    relative += sumOf(square / (dvec3(r) * dvec3(r) + kRelMseEpsilon));
    squares8 += sumOf(difference8 * difference8);
    sum += sumOf(dvec3(x));
    referenceSum += sumOf(dvec3(r));
  });
  m.pixels = pixelSquares.size();
  if (m.pixels == 0)
    fail(ExitCode::invalidInput, "the reference has no object pixels: its alpha is nowhere above .5");
  const double count = 3.0 * double(m.pixels);
  m.rmse = std::sqrt(squares / count);
  m.relMse = relative / count;
  m.trimmedRmse = std::sqrt(trimmedSum(std::move(pixelSquares)) / 3.0);
  m.rmse8 = std::sqrt(squares8 / count);
  m.psnr = 20.0 * std::log10(255.0 / m.rmse8);
  m.alphaRmse = alphaRmse(image, reference);
  m.flip = meanFlip(image, reference);
  m.mean = sum / count;
  m.referenceMean = referenceSum / count;
  m.bias = referenceSum != 0.0 ? (sum - referenceSum) / referenceSum : (sum == 0.0 ? 0.0 : INFINITY);
  return m;
}

Image falseColourDifference(const Image& image, const Image& reference) {
  checkSizes(image, reference);
  Image colours = makeImage(reference.width, reference.height, 4);
  forMeasured(image, reference, [&](uint32_t x, uint32_t y, Rgb value, Rgb truth) {
    const dvec3 steps = glm::abs(steps8(value) - steps8(truth));
    const double largest = std::max({steps.x, steps.y, steps.z});
    const Rgb colour = cubehelix(float(std::log2(1.0 + largest) / 6.0));
    float* p = colours.at(x, y);
    for (int c = 0; c < 3; ++c) p[c] = colour[c];
    p[3] = 1.0f;
  });
  return colours;
}

Rgb cubehelix(float t) {
  t = std::clamp(t, 0.0f, 1.0f);
  const float angle = 2.0f * kPi * (0.5f / 3.0f + 1.0f - 1.5f * t);
  const float amplitude = 0.5f * t * (1.0f - t);
  const float c = std::cos(angle), s = std::sin(angle);
  const Rgb colour(t + amplitude * (-0.14861f * c + 1.78277f * s),
                   t + amplitude * (-0.29227f * c - 0.90649f * s), t + amplitude * (1.97294f * c));
  return glm::clamp(colour, 0.0f, 1.0f);
}

}  // namespace boxlight
