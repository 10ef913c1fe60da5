// SPDX-License-Identifier: Apache-2.0
#include "bake/transport/environment_sampler.h"

#include <cmath>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

/// Mean luminance over each texel of the bilinearly interpolated image: the 1-6-1 filter in both directions.
std::vector<float> texelLuminance(const Image& image) {
  const uint32_t w = image.width, h = image.height;
  std::vector<float> result(size_t(w) * h);
  for (uint32_t y = 0; y < h; ++y)
    for (uint32_t x = 0; x < w; ++x) {
      double sum = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const uint32_t row = uint32_t(std::clamp(int(y) + dy, 0, int(h) - 1)),
                         column = (x + w + uint32_t(dx)) % w;
          const float* p = image.at(column, row);
          sum += double(luminance({p[0], p[1], p[2]})) * (dx ? 1 : 6) * (dy ? 1 : 6) / 64.0;
        }
      result[size_t(y) * w + x] = float(sum);
    }
  return result;
}

/// Index i with cumulative[i-1] <= value < cumulative[i]; value becomes its fraction inside the step.
size_t findStep(const double* cumulative, size_t count, double& value) {
  size_t i = size_t(std::upper_bound(cumulative, cumulative + count, value) - cumulative);
  i = std::min(i, count - 1);
  while (i > 0 && cumulative[i] == cumulative[i - 1]) --i;  // never a step of probability 0
  const double before = i ? cumulative[i - 1] : 0.0;
  value = std::clamp((value - before) / (cumulative[i] - before), 0.0, 1.0);
  return i;
}

}  // namespace

EnvironmentSampler::EnvironmentSampler(const Image& environment, float rotationDegrees, EnvironmentTilt tilt)
    : image_(environment),
      offset_(tilt.isLevel() ? environmentOffset(rotationDegrees) : 0.0f),
      level_(tilt.isLevel()),
      toImage_(worldToEnvironment(tilt, rotationDegrees)) {
  const std::vector<float> light = texelLuminance(image_);
  rows_.resize(image_.height);
  columns_.resize(light.size());
  double total = 0;
  for (uint32_t y = 0; y < image_.height; ++y) {
    double sum = 0;
    for (uint32_t x = 0; x < image_.width; ++x)
      columns_[size_t(y) * image_.width + x] = sum += light[size_t(y) * image_.width + x];
    rows_[y] = total += sum * texelSolidAngle(y);
  }
}

double EnvironmentSampler::texelSolidAngle(uint32_t row) const {
  return rectangleSolidAngle(1.0 / image_.width, double(row) / image_.height,
                             double(row + 1) / image_.height);
}

vec2 EnvironmentSampler::imageUv(vec3 direction) const {
  vec2 uv = directionToUv(level_ ? direction : toImage_ * direction);
  uv.x += offset_;
  if (uv.x >= 1.0f) uv.x -= 1.0f;
  return uv;
}

Rgb EnvironmentSampler::radiance(vec3 direction) const {
  return sampleEnvironment(image_, imageUv(direction));
}

float EnvironmentSampler::density(vec3 direction) const {
  if (rows_.back() <= 0) return 0.0f;
  const vec2 uv = imageUv(direction);
  const uint32_t x = std::min(uint32_t(uv.x * float(image_.width)), image_.width - 1);
  const uint32_t y = std::min(uint32_t(uv.y * float(image_.height)), image_.height - 1);
  const double* row = &columns_[size_t(y) * image_.width];
  return float((row[x] - (x ? row[x - 1] : 0.0)) / rows_.back());
}

EnvironmentSampler::Sample EnvironmentSampler::sample(vec2 random) const {
  if (rows_.back() <= 0) return {vec3(0, 1, 0), Rgb(0.0f), 0.0f};
  double a = double(random.x) * rows_.back();
  const size_t y = findStep(rows_.data(), rows_.size(), a);
  const double* row = &columns_[y * image_.width];
  double b = double(random.y) * row[image_.width - 1];
  const size_t x = findStep(row, image_.width, b);
  const double top = std::cos(kPiDouble * double(y) / image_.height),
               bottom = std::cos(kPiDouble * double(y + 1) / image_.height);
  const double v = std::acos(std::clamp(glm::mix(top, bottom, a), -1.0, 1.0)) / kPiDouble;
  const double u = (double(x) + b) / image_.width - double(offset_);
  const vec3 inImage = uvToDirection({float(u - std::floor(u)), float(v)});
  const vec3 direction = level_ ? inImage : glm::transpose(toImage_) * inImage;
  return {direction, radiance(direction), density(direction)};
}

}  // namespace boxlight
