// SPDX-License-Identifier: Apache-2.0
#include "common/image/flip.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace boxlight;

namespace {

Image flat(Rgb colour, uint32_t edge = 16) {
  Image image = makeImage(edge, edge, 3);
  for (uint32_t i = 0; i < edge * edge; ++i) std::copy_n(&colour.x, 3, image.at(i % edge, i / edge));
  return image;
}

double flipOf(const Image& a, const Image& b) {
  return flipMap(a, b)[a.width * (a.height / 2) + a.width / 2];
}

/// Grey patterns of edges and points.
Image pattern(float phase) {
  Image image = makeImage(64, 64, 3);
  for (uint32_t y = 0; y < 64; ++y)
    for (uint32_t x = 0; x < 64; ++x) {
      const float v = 0.4f +
                      0.2f * std::sin(0.9f * float(x) + phase) * std::cos(0.5f * float(y) * (1 + phase)) +
                      ((x * 7 + y * 13) % 11 < 2 ? 0.3f * (1 - phase) : 0.0f);
      std::fill_n(image.at(x, y), 3, v);
    }
  return image;
}

double lightness(double y) { return 116 * std::cbrt(y) - 16; }  // above .009

/// FLIP of grey pictures at one pixel, as the paper writes it: two-dimensional filters, no chroma.
double greyFlip(const Image& a, const Image& b, int cx, int cy) {
  constexpr double kPpd = kFlipPixelsPerDegree, kDeviation = 0.5 * 0.082 * kPpd;
  constexpr int kRadius = 12;
  double blur[2] = {}, edge[2][2] = {}, point[2][2] = {}, blurSum = 0, edgeSum = 0, pointAbove = 0,
         pointBelow = 0;
  const auto g = [](double x, double y) {
    return std::exp(-(x * x + y * y) / (2 * kDeviation * kDeviation));
  };
  const auto second = [&](double x, double y) { return (x * x / (kDeviation * kDeviation) - 1) * g(x, y); };
  for (int y = -kRadius; y <= kRadius; ++y)
    for (int x = -kRadius; x <= kRadius; ++x) {
      const double degrees = double(x * x + y * y) / (kPpd * kPpd);
      const double eye = std::exp(-kPiDouble * kPiDouble * degrees / 0.0047);
      const bool near = std::abs(x) <= 9 && std::abs(y) <= 9;
      if (x > 0 && near) edgeSum += x * g(x, y);
      if (near) (second(x, y) > 0 ? pointAbove : pointBelow) += std::abs(second(x, y));
      blurSum += eye;
      for (int k = 0; k < 2; ++k) {
        const double v = double(*(k ? b : a).at(uint32_t(cx + x), uint32_t(cy + y)));
        blur[k] += eye * v;
        if (near) edge[k][0] += x * g(x, y) * v, edge[k][1] += y * g(x, y) * v;
      }
    }
  for (int y = -9; y <= 9; ++y)
    for (int x = -9; x <= 9; ++x)
      for (int k = 0; k < 2; ++k) {
        const double v = double(*(k ? b : a).at(uint32_t(cx + x), uint32_t(cy + y)));
        point[k][0] += second(x, y) / (second(x, y) > 0 ? pointAbove : pointBelow) * v;
        point[k][1] += second(y, x) / (second(y, x) > 0 ? pointAbove : pointBelow) * v;
      }
  const double colour = std::pow(std::abs(lightness(blur[0] / blurSum) - lightness(blur[1] / blurSum)), 0.7);
  const double edges =
      std::abs(std::hypot(edge[0][0], edge[0][1]) - std::hypot(edge[1][0], edge[1][1])) / edgeSum;
  const double points = std::abs(std::hypot(point[0][0], point[0][1]) - std::hypot(point[1][0], point[1][1]));
  constexpr double kLargest = 41.2760;                    // between green and blue, sRGB
  const double share = 0.95 / (0.4 * kLargest) * colour;  // small differences only
  return std::pow(share, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2.0)));
}

}  // namespace

TEST(Flip, EqualPicturesDoNotDiffer) {
  for (const double error : flipMap(pattern(0.2f), pattern(0.2f))) EXPECT_EQ(error, 0);
}

TEST(Flip, GreenAndBlueDifferMost) { EXPECT_NEAR(flipOf(flat({0, 1, 0}), flat({0, 0, 1})), 1, 1e-12); }

// |L| = 100: 100^.7 of 41.276, past the bend at .4 of it.
TEST(Flip, BlackAndWhiteAreAHyAbDistanceOfAHundred) {
  const double largest = 41.2760, error = std::pow(100, 0.7);
  EXPECT_NEAR(flipOf(flat(Rgb(0)), flat(Rgb(1))), 0.95 + 0.05 * (error - 0.4 * largest) / (0.6 * largest),
              1e-5);
}

TEST(Flip, IsThePapersFormulaOnGrey) {
  const Image a = pattern(0), b = pattern(0.3f);
  const std::vector<double> errors = flipMap(a, b);
  for (const auto& [x, y] : {std::pair(20, 20), {31, 40}, {45, 25}, {33, 33}})
    EXPECT_NEAR(errors[size_t(y * 64 + x)], greyFlip(a, b, x, y), 1e-3) << x << ' ' << y;
}

TEST(Flip, WhatADisplayCannotShowIsClamped) {
  EXPECT_EQ(flipOf(flat(Rgb(5)), flat(Rgb(1))), 0);
  EXPECT_EQ(flipOf(flat(Rgb(NAN)), flat(Rgb(0))), 0);
}
