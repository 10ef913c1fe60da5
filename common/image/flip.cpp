// SPDX-License-Identifier: Apache-2.0
#include "common/image/flip.h"

#include <cmath>
#include <functional>

#include "common/image/flip_colour.h"

namespace boxlight {
namespace {

using flip::colourError;
using flip::fromOpponent;
using flip::toHuntLab;
using flip::toOpponent;

constexpr double kFeatureExponent = 0.5;

/// A picture of three doubles a pixel.
struct Picture {
  uint32_t width, height;
  std::vector<dvec3> pixels;

  /// Pixels beyond the border repeat the last one.
  const dvec3& near(int x, int y) const {
    return pixels[size_t(std::clamp(y, 0, int(height) - 1)) * width +
                  size_t(std::clamp(x, 0, int(width) - 1))];
  }
};

Picture map(Picture picture, const std::function<dvec3(dvec3)>& function) {
  for (dvec3& pixel : picture.pixels) pixel = function(pixel);
  return picture;
}

/// Weights at -radius to radius, one for each channel.
using Filter = std::vector<dvec3>;

Picture filterAlong(const Picture& picture, const Filter& filter, bool vertical) {
  Picture result = picture;
  const int radius = int(filter.size() / 2);
  for (int y = 0; y < int(picture.height); ++y)
    for (int x = 0; x < int(picture.width); ++x) {
      dvec3 sum(0);
      for (int i = -radius; i <= radius; ++i)
        sum += filter[size_t(i + radius)] * picture.near(x + (vertical ? 0 : i), y + (vertical ? i : 0));
      result.pixels[size_t(y) * picture.width + size_t(x)] = sum;
    }
  return result;
}

Picture filter(const Picture& picture, const Filter& across, const Filter& down) {
  return filterAlong(filterAlong(picture, across, false), down, true);
}

struct Gaussian {
  std::vector<double> weights;  ///< their sum is 1
  double sum = 0;               ///< of exp(-x^2 / (2 deviation^2))
};

Gaussian gaussian(double deviation, int radius) {
  Gaussian g;
  for (int i = -radius; i <= radius; ++i)
    g.sum += g.weights.emplace_back(std::exp(-0.5 * i * i / (deviation * deviation)));
  for (double& weight : g.weights) weight /= g.sum;
  return g;
}

/// What the eye resolves of achromatic, red-green and blue-yellow contrast: Gaussians a sqrt(pi / b)
/// exp(-pi^2 r^2 / b), r in degrees; of blue and yellow the sum of two.
Picture blurAsEyes(const Picture& opponent, double pixelsPerDegree) {
  constexpr double kB[4] = {0.0047, 0.0053, 0.04, 0.025};
  const auto deviation = [&](double b) { return std::sqrt(b / 2) / kPiDouble * pixelsPerDegree; };
  const int radius = int(std::ceil(3 * deviation(kB[2])));
  Gaussian g[4];
  for (int i = 0; i < 4; ++i) g[i] = gaussian(deviation(kB[i]), radius);
  Filter first, second;
  for (size_t i = 0; i < g[0].weights.size(); ++i) {
    first.push_back({g[0].weights[i], g[1].weights[i], g[2].weights[i]});
    second.push_back(dvec3(g[3].weights[i]));
  }
  const double wide = 34.1 / std::sqrt(kB[2]) * g[2].sum * g[2].sum;
  const double narrow = 13.5 / std::sqrt(kB[3]) * g[3].sum * g[3].sum, share = wide / (wide + narrow);
  Picture blurred = filter(opponent, first, first);
  const Picture other = filter(opponent, second, second);
  for (size_t i = 0; i < blurred.pixels.size(); ++i)
    blurred.pixels[i].z = share * blurred.pixels[i].z + (1 - share) * other.pixels[i].z;
  return blurred;
}

/// Weights above zero scaled to a sum of 1, those below to -1.
void balance(std::vector<double>& weights) {
  double above = 0, below = 0;
  for (const double w : weights) (w > 0 ? above : below) += std::abs(w);
  for (double& w : weights) w /= w > 0 ? above : below;
}

/// Strengths of edges and of points in what is seen of lightness: (edge, point, 0).
Picture features(const Picture& opponent, double pixelsPerDegree) {
  constexpr double kFeatureDegrees = 0.082;
  const double deviation = 0.5 * kFeatureDegrees * pixelsPerDegree;
  const int radius = int(std::ceil(3 * deviation));
  const std::vector<double> smooth = gaussian(deviation, radius).weights;
  std::vector<double> edge = smooth, point = smooth;
  for (int i = -radius; i <= radius; ++i) {
    edge[size_t(i + radius)] *= -i;
    point[size_t(i + radius)] *= i * i / (deviation * deviation) - 1;
  }
  balance(edge), balance(point);
  Filter change, level;
  for (size_t i = 0; i < smooth.size(); ++i)
    change.push_back({edge[i], point[i], 0}), level.push_back(dvec3(smooth[i]));
  const Picture lightness = map(opponent, [](dvec3 c) { return dvec3((c.x + 16) / 116); });
  Picture across = filter(lightness, change, level);
  const Picture down = filter(lightness, level, change);
  for (size_t i = 0; i < across.pixels.size(); ++i)
    across.pixels[i] = {std::hypot(across.pixels[i].x, down.pixels[i].x),
                        std::hypot(across.pixels[i].y, down.pixels[i].y), 0};
  return across;
}

struct Seen {
  Picture colours, features;
};

Seen see(const Image& image, double pixelsPerDegree) {
  Picture picture{image.width, image.height, {}};
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x) {
      const dvec3 rgb(rgbAt(image, x, y));
      picture.pixels.push_back(std::isfinite(rgb.x + rgb.y + rgb.z) ? glm::clamp(rgb, 0.0, 1.0) : dvec3(0));
    }
  const Picture opponent = map(std::move(picture), toOpponent);
  const auto display = [](dvec3 c) { return toHuntLab(glm::clamp(fromOpponent(c), 0.0, 1.0)); };
  return {map(blurAsEyes(opponent, pixelsPerDegree), display), features(opponent, pixelsPerDegree)};
}

}  // namespace

std::vector<double> flipMap(const Image& image, const Image& reference, double pixelsPerDegree) {
  assert(image.width == reference.width && image.height == reference.height);
  const Seen a = see(image, pixelsPerDegree), b = see(reference, pixelsPerDegree);
  std::vector<double> errors;
  for (size_t i = 0; i < a.colours.pixels.size(); ++i) {
    const double colour = colourError(a.colours.pixels[i], b.colours.pixels[i]);
    const dvec3 change = glm::abs(a.features.pixels[i] - b.features.pixels[i]);
    const double feature = std::pow(std::max(change.x, change.y) / std::sqrt(2.0), kFeatureExponent);
    errors.push_back(std::pow(colour, 1 - feature));
  }
  return errors;
}

}  // namespace boxlight
