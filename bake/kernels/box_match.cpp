// SPDX-License-Identifier: Apache-2.0
#include "bake/kernels/box_match.h"

#include <cassert>
#include <cmath>
#include <numeric>
#include <queue>

#include "bake/kernels/assignment.h"
#include "common/light/light_domain.h"

namespace boxlight {
namespace {

float totalEnergy(const Box& box) { return box.energy.x + box.energy.y + box.energy.z; }

/// What a match looks at. Boxes of a glossy lobe move with the mirror direction from view to view, those of
/// occluders stay where they are: a centre is therefore compared in both ways and the better one counts.
struct Trait {
  vec3 centre{0.0f};    ///< direction of the box's centre
  vec3 inMirror{0.0f};  ///< the same in the light domain's frame at the view's mirror direction
  vec2 logSize{0.0f};   ///< log2 of width and height on the sphere
  float energy = 0.0f;
  bool missing = true;
};

/// Columns: east, `direction` and what lies across both; defined at the poles too.
glm::mat3 lightDomainFrame(vec3 direction) {
  const float phi = std::atan2(direction.z, direction.x);
  const vec3 east(-std::sin(phi), 0.0f, std::cos(phi));
  return {east, direction, glm::cross(east, direction)};
}

Trait traitOf(const Box& box, const glm::mat3& mirrorFrame) {
  const float v = box.v0 + 0.5f * box.dv;
  Trait trait;
  trait.centre = uvToDirection({box.u0 + 0.5f * box.du, v});
  trait.inMirror = trait.centre * mirrorFrame;
  trait.logSize = {std::log2(box.du * std::sin(kPi * v)), std::log2(box.dv)};
  trait.energy = totalEnergy(box);
  trait.missing = false;
  return trait;
}

float squaredLength(vec3 v) { return glm::dot(v, v); }

/// The energy that moves, changes or fades on the way from one box to the other. The factors are flat optima,
/// measured by the error of interpolated kernels (GGX lobes of alpha .02 to .3 with occluders, soft and
/// sun-lit).
float matchCost(const Trait& a, const Trait& b) {
  constexpr float kSizeFactor = 0.03f, kEnergyFactor = 0.1f, kFadeFactor = 1.0f;
  if (a.missing || b.missing) return kFadeFactor * (a.energy + b.energy);
  const float moved = std::min(squaredLength(a.centre - b.centre), squaredLength(a.inMirror - b.inMirror));
  const vec2 resized = a.logSize - b.logSize;
  return (a.energy + b.energy) * (moved + kSizeFactor * glm::dot(resized, resized)) +
         kEnergyFactor * std::abs(a.energy - b.energy);
}

class SlotMatcher {
 public:
  SlotMatcher(const ViewSphere& sphere, vec3 normal, std::vector<std::vector<Box>>& kernels, int slots)
      : sphere_(sphere), normal_(normal), kernels_(kernels), slots_(slots) {}

  void run() {
    describe();
    spread();
    orderByEnergy();
    shapeMissing();
  }

 private:
  using Candidate = std::pair<float, uint32_t>;  // how frontal, view

  bool isStored(uint32_t view) const { return !traits_[view].empty(); }

  void describe() {
    traits_.resize(kernels_.size());
    matched_.resize(kernels_.size());
    for (uint32_t view = 0; view < kernels_.size(); ++view) {
      std::vector<Box>& kernel = kernels_[view];
      if (kernel.empty()) continue;
      std::erase_if(kernel, [](const Box& box) { return totalEnergy(box) <= 0.0f; });
      assert(int(kernel.size()) <= slots_);
      const vec3 eye = raiseAboveHorizon(sphere_.directions()[view], normal_);
      const glm::mat3 frame = lightDomainFrame(2.0f * glm::dot(normal_, eye) * normal_ - eye);
      for (const Box& box : kernel) traits_[view].push_back(traitOf(box, frame));
      kernel.resize(slots_);
      traits_[view].resize(slots_);
    }
  }

  /// From the most frontal view outwards, always on to the most frontal view next to a matched one.
  void spread() {
    std::priority_queue<Candidate> starts, front;
    for (uint32_t view = 0; view < kernels_.size(); ++view)
      if (isStored(view)) starts.push(candidate(view));
    for (; !starts.empty(); starts.pop()) {  // more than one only if the stored views are not connected
      front.push(starts.top());
      while (!front.empty()) {
        const uint32_t view = front.top().second;
        front.pop();
        if (matched_[view]) continue;
        matchToNeighbours(view);
        matched_[view] = true;
        for (uint32_t next : sphere_.adjacent(view))
          if (isStored(next) && !matched_[next]) front.push(candidate(next));
      }
    }
  }

  Candidate candidate(uint32_t view) const { return {glm::dot(sphere_.directions()[view], normal_), view}; }

  void matchToNeighbours(uint32_t view) {
    cost_.assign(size_t(slots_) * slots_, 0.0f);
    for (uint32_t neighbour : sphere_.adjacent(view)) {
      if (!matched_[neighbour]) continue;
      for (int box = 0; box < slots_; ++box)
        for (int slot = 0; slot < slots_; ++slot)
          cost_[size_t(box) * slots_ + slot] += matchCost(traits_[view][box], traits_[neighbour][slot]);
    }
    const std::vector<int> slotOf = cheapestAssignment(cost_, slots_);
    const std::vector<Box> boxes = kernels_[view];
    const std::vector<Trait> traits = traits_[view];
    for (int box = 0; box < slots_; ++box) {
      kernels_[view][slotOf[box]] = boxes[box];
      traits_[view][slotOf[box]] = traits[box];
    }
  }

  void orderByEnergy() {
    std::vector<double> energy(slots_);
    for (const std::vector<Box>& kernel : kernels_)
      for (size_t slot = 0; slot < kernel.size(); ++slot) energy[slot] += totalEnergy(kernel[slot]);
    std::vector<int> order(slots_);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return energy[a] > energy[b]; });
    for (std::vector<Box>& kernel : kernels_) {
      const std::vector<Box> unordered = kernel;
      for (size_t slot = 0; slot < kernel.size(); ++slot) kernel[slot] = unordered[order[slot]];
    }
  }

  /// Hands shapes on from view to view until every slot has one.
  void shapeMissing() {
    for (int slot = 0; slot < slots_; ++slot)
      for (bool changed = true; changed;) {
        changed = false;
        for (uint32_t view = 0; view < kernels_.size(); ++view)
          if (isStored(view) && kernels_[view][slot].dv == 0.0f) changed |= borrowShape(view, slot);
      }
    for (std::vector<Box>& kernel : kernels_)
      for (Box& box : kernel)
        if (box.dv == 0.0f) box.du = box.dv = 1.0f;  // no view has a box here
  }

  /// From the neighbour with the most energy in the slot.
  bool borrowShape(uint32_t view, int slot) {
    const Box* lender = nullptr;
    for (uint32_t neighbour : sphere_.adjacent(view)) {
      if (!isStored(neighbour) || kernels_[neighbour][slot].dv == 0.0f) continue;
      const Box& box = kernels_[neighbour][slot];
      if (!lender || totalEnergy(box) > totalEnergy(*lender)) lender = &box;
    }
    if (!lender) return false;
    kernels_[view][slot] = *lender;
    kernels_[view][slot].energy = Rgb(0.0f);
    return true;
  }

  const ViewSphere& sphere_;
  vec3 normal_;
  std::vector<std::vector<Box>>& kernels_;
  int slots_;
  std::vector<std::vector<Trait>> traits_;  // [view][slot], like kernels_
  std::vector<bool> matched_;
  std::vector<float> cost_;
};

}  // namespace

void matchSlots(const ViewSphere& sphere, vec3 normal, std::vector<std::vector<Box>>& kernels, int slots) {
  assert(kernels.size() == sphere.viewCount() && slots > 0);
  SlotMatcher(sphere, normal, kernels, slots).run();
}

}  // namespace boxlight
