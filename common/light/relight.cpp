// SPDX-License-Identifier: Apache-2.0
#include "common/light/relight.h"

#include <bit>
#include <cassert>
#include <cmath>

#include "common/light/light_domain.h"

namespace boxlight {
namespace {

vec3 toVec3(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

bool hasEnergy(const Box& box) { return box.energy.x > 0.0f || box.energy.y > 0.0f || box.energy.z > 0.0f; }

/// fract(c - du / 2) for the mean centre c; see interpolateBoxes.
double interpolatedStart(const std::array<Box, 3>& boxes, const std::array<double, 3>& share, double du) {
  double reference = 0.0, cosine = 0.0, sine = 0.0;  // from the first, so that one centre alone is itself
  bool hasReference = false;
  for (int k = 0; k < 3; ++k) {
    if (!(share[k] > 0.0) || boxes[k].du >= 1.0f) continue;
    const double centre = double(boxes[k].u0) + 0.5 * double(boxes[k].du);
    if (!hasReference) reference = centre;
    hasReference = true;
    cosine += share[k] * std::cos(2.0 * kPiDouble * (centre - reference));
    sine += share[k] * std::sin(2.0 * kPiDouble * (centre - reference));
  }
  if (!hasReference) return 0.0;
  const double start = reference + std::atan2(sine, cosine) / (2.0 * kPiDouble) - 0.5 * du;
  return start - std::floor(start);
}

/// Slots before the boxes: one if the kernel has emitted radiance.
size_t emissionSlots(std::span<const PackedBox> kernel) {
  return !kernel.empty() && isEmission(kernel.front()) ? 1 : 0;
}

/// Behind the boxes that take part.
size_t lastSlot(size_t slots, size_t first, uint32_t maxBoxes) {
  return first + std::min<size_t>(slots - std::min(slots, first), maxBoxes);
}

void add(const CosineBox& box, dvec3 normal, const SummedArea& lights, double uOffset, DiffuseRadiance& sum) {
  const double share = double(box.amplitude) / kPiDouble;
  if (box.isWhole()) {
    const LightMoments::Hemisphere hemisphere = lights.moments().hemisphere(normal, uOffset);
    sum.radiance += share * hemisphere.irradiance;
    sum.gradient += share * hemisphere.moment;
    return;
  }
  const dmat3 moment = lights.moments().integrate(rectangleOf(box.box), uOffset);
  for (int c = 0; c < 3; ++c) {
    const double irradiance = glm::dot(normal, moment[c]);
    if (!(irradiance > 0.0)) continue;  // of light below the horizon
    sum.radiance[c] += share * irradiance;
    sum.gradient[c] += share * moment[c];
  }
}

/// Mean radiance of the light over a box, times energy: w * (K . L).
dvec3 light(const Rectangle& rectangle, dvec3 energy, const SummedArea& lights, double uOffset) {
  return energy * lights.integrate(rectangle, uOffset) / rectangle.solidAngle();
}

}  // namespace

InterpolatedBox interpolateBoxes(const std::array<Box, 3>& boxes, vec3 weight, Interpolation interpolation) {
  std::array<double, 3> share{};  // g_k
  double total = 0.0;             // G
  for (int k = 0; k < 3; ++k) total += share[k] = hasEnergy(boxes[k]) ? double(weight[k]) : 0.0;
  if (!(total > 0.0)) return {};

  double v0 = 0.0, v1 = 0.0, du = 0.0;
  dvec3 energy(0.0), boxWeight(0.0);
  for (int k = 0; k < 3; ++k) {
    if (share[k] == 0.0) continue;
    const Box& box = boxes[k];
    du += share[k] * double(box.du) / total;
    v0 += share[k] * double(box.v0) / total;
    v1 += share[k] * (double(box.v0) + double(box.dv)) / total;
    energy += share[k] * dvec3(box.energy);
    boxWeight += share[k] * dvec3(box.energy) / box.solidAngle();
  }
  InterpolatedBox result;
  result.rectangle = {interpolatedStart(boxes, share, du), v0, std::min(du, 1.0), std::min(v1, 1.0) - v0};
  result.energy = interpolation == Interpolation::energy ? energy : boxWeight * result.rectangle.solidAngle();
  return result;
}

DiffuseRadiance straightRadiance(std::span<const CosineBox> boxes, dvec3 normal, const SummedArea& lights,
                                 double uOffset) {
  DiffuseRadiance sum;
  for (const CosineBox& box : boxes) add(box, normal, lights, uOffset, sum);
  sum.radiance = glm::max(sum.radiance, dvec3(0.0));
  return sum;
}

std::vector<ViewSphere> viewSpheresOf(const asset::Asset& asset) {
  std::vector<ViewSphere> spheres{ViewSphere(asset.info.viewFrequency)};
  for (const asset::GeodesicSphere& coarse : asset.coarseViews) spheres.emplace_back(coarse.frequency);
  return spheres;
}

Relighter::Relighter(const asset::AssetReader& reader)
    : Relighter(reader.asset(),
                [&reader](uint32_t stream, uint32_t tile) { return reader.page(stream, tile); }) {}

Relighter::Relighter(const asset::Asset& asset, PageProvider pages)
    : asset_(asset),
      pages_(std::move(pages)),
      views_(viewSpheresOf(asset)),
      cells_(asset.cellSphere.empty() ? 1 : asset.cellSphere.front().frequency) {
  assert(views_[0].viewCount() == asset.info.viewCount);
}

std::span<const PackedBox> Relighter::kernel(uint32_t stream, uint32_t record) {
  assert(record < asset_.records.size());
  const auto next =
      std::upper_bound(asset_.tiles.begin(), asset_.tiles.end(), record,
                       [](uint32_t r, const asset::Tile& tile) { return r < tile.firstRecord; });
  const auto tile = uint32_t(next - asset_.tiles.begin()) - 1;
  const uint32_t row = record - asset_.tiles[tile].firstRecord;
  const uint64_t mask = asset_.mask(stream, tile);
  if (!(mask >> row & 1)) return {};
  const auto [page, isNew] = decoded_.try_emplace(uint64_t(stream) * asset_.tiles.size() + tile);
  if (isNew) page->second = pages_(stream, tile);
  const size_t boxes = asset_.boxesPerKernel(stream, tile);
  const auto rank = size_t(std::popcount(mask & ((uint64_t(1) << row) - 1)));
  assert((rank + 1) * boxes <= page->second.size());
  return std::span(page->second).subspan(rank * boxes, boxes);
}

TexelRadiance Relighter::relight(uint32_t record, vec3 eye, const SummedArea& lights, double uOffset,
                                 Interpolation interpolation, uint32_t maxBoxes) {
  TexelRadiance radiance;
  radiance.diffuse = diffuse(record, lights, uOffset, maxBoxes).radiance;
  if (asset_.hasCells(record)) return radiance;
  const asset::TexelRecord& texel = asset_.records[record];
  const vec3 normal = toVec3(texel.normal), towards = eye - toVec3(texel.position);
  const float distance = glm::length(towards);
  const vec3 view = distance > 0.0f ? towards / distance : normal;
  const vec3 raised = raiseAboveHorizon(view, normal);
  if (asset_.isSplit(record))
    addHidden(record, viewsOf(record).locate(raised), 0, lights, uOffset, maxBoxes, radiance);
  else
    radiance.glossy = glossy(record, raised, lights, uOffset, interpolation, maxBoxes);
  return radiance;
}

DiffuseRadiance Relighter::diffuse(uint32_t record, const SummedArea& lights, double uOffset,
                                   uint32_t maxBoxes) {
  const auto lambert = kernel(asset_.diffuseStream(), record);
  const dvec3 normal(toVec3(asset_.records[record].normal));
  const size_t first = emissionSlots(lambert);
  std::vector<CosineBox> straight;
  DiffuseRadiance sum;
  if (first > 0) sum.radiance = dvec3(unpackEmission(lambert.front()));
  for (size_t j = first; j < lastSlot(lambert.size(), first, maxBoxes); ++j) {
    if (isCosineBox(lambert[j])) {
      straight.push_back(unpackCosineBox(lambert[j]));
      continue;
    }
    const Box box = unpackBox(lambert[j]);
    const dvec3 radiance = light(rectangleOf(box), dvec3(box.energy), lights, uOffset);
    const dvec3 direction = meanDirection(box.u0, box.v0, box.du, box.dv);
    const double cosine = std::max(glm::dot(normal, direction), 0.0);
    const double floor = kLeastGradientCosine * kLeastGradientCosine;
    sum.radiance += radiance;
    sum.gradient += glm::outerProduct(direction * (cosine / std::max(cosine * cosine, floor)), radiance);
  }
  const DiffuseRadiance seen = straightRadiance(straight, normal, lights, uOffset);
  return {sum.radiance + seen.radiance, sum.gradient + seen.gradient};
}

TexelRadiance Relighter::arriving(uint32_t record, vec3 direction, const SummedArea& lights, double uOffset,
                                  uint32_t maxBoxes) {
  TexelRadiance radiance;
  addHidden(record, cells_.locate(direction), asset_.firstCellStream(), lights, uOffset, maxBoxes, radiance);
  return radiance;
}

void Relighter::addHidden(uint32_t record, const ViewBlend& blend, uint32_t firstStream,
                          const SummedArea& lights, double uOffset, uint32_t maxBoxes,
                          TexelRadiance& radiance) {
  for (int k = 0; k < 3; ++k) {
    const auto slots = kernel(firstStream + blend.view[k], record);
    if (slots.empty()) continue;
    const auto weight = double(blend.weight[k]);
    const size_t hidden = emissionSlots(slots);
    if (hidden > 0) radiance.glossy += weight * dvec3(unpackEmission(slots.front()));
    radiance.hidden += weight * double(unpackHiddenPart(slots[hidden]));
    for (size_t j = hidden + 1; j < lastSlot(slots.size(), hidden + 1, maxBoxes); ++j) {
      const Box box = unpackBox(slots[j]);
      radiance.glossy += weight * light(rectangleOf(box), dvec3(box.energy), lights, uOffset);
    }
  }
}

dvec3 Relighter::glossy(uint32_t record, vec3 view, const SummedArea& lights, double uOffset,
                        Interpolation interpolation, uint32_t maxBoxes) {
  const ViewBlend blend = viewsOf(record).locate(view);
  std::array<std::span<const PackedBox>, 3> kernels;
  vec3 weight(0.0f);
  size_t slots = 0, first = 0;
  for (int k = 0; k < 3; ++k) {
    kernels[k] = kernel(blend.view[k], record);
    if (!kernels[k].empty()) weight[k] = blend.weight[k];
    slots = std::max(slots, kernels[k].size());
    first = std::max(first, emissionSlots(kernels[k]));
  }
  const float total = weight.x + weight.y + weight.z;
  if (!(total > 0.0f)) return dvec3(0.0);
  weight /= total;

  dvec3 radiance(0.0);
  for (int k = 0; k < 3 && first > 0; ++k)
    if (!kernels[k].empty()) radiance += double(weight[k]) * dvec3(unpackEmission(kernels[k].front()));
  for (size_t j = first; j < lastSlot(slots, first, maxBoxes); ++j) {
    std::array<Box, 3> boxes;  // a missing view's box stays empty
    for (int k = 0; k < 3; ++k)
      if (!kernels[k].empty()) boxes[k] = unpackBox(kernels[k][j]);
    const InterpolatedBox box = interpolateBoxes(boxes, weight, interpolation);
    if (box.rectangle.du > 0.0) radiance += light(box.rectangle, box.energy, lights, uOffset);
  }
  return radiance;
}

}  // namespace boxlight
