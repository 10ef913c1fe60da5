// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/light_table.h"

#include <array>
#include <cstdint>
#include <span>

#include "shaders/shared.h"
#include "spirv/sat_columns_comp.h"
#include "spirv/sat_columns_groups_comp.h"
#include "spirv/sat_rows_comp.h"
#include "spirv/sat_rows_groups_comp.h"

namespace boxlight::gpu {
namespace {

uint32_t groupsFor(uint32_t threads, uint32_t groupSize) { return (threads + groupSize - 1) / groupSize; }

bool inGroups(const Device& device, SatBuild build) {
  return build == SatBuild::automatic ? device.info().kind != "Cpu" : build == SatBuild::groups;
}

uint64_t entryBytes(SatScheme scheme) {
  return scheme == SatScheme::compact ? sizeof(uvec4) : 3 * sizeof(uvec2);
}

std::array<uint32_t, kSurfaceConstants> constantsOf(SatScheme scheme) {
  std::array<uint32_t, kSurfaceConstants> constants{};
  constants[kConstantExactSums] = scheme == SatScheme::exact;
  return constants;
}

ComputePipeline makePass(const Device& device, const Bindings& bindings, bool groups,
                         std::span<const uint32_t> inGroups, std::span<const uint32_t> inThreads,
                         SatScheme scheme) {
  return {device, bindings, groups ? inGroups : inThreads, constantsOf(scheme)};
}

}  // namespace

LightTable::LightTable(Device& device, Bindings& bindings, uvec2 size, SatScheme scheme, SatBuild build)
    : size_(size),
      rowFactors_(device, "row factors", size.y * sizeof(float)),
      rowSums_(device, "row sums of the light map", uint64_t(size.x) * size.y * sizeof(RowSum)),
      rows_(makePass(device, bindings, inGroups(device, build), sat_rows_groups_comp, sat_rows_comp, scheme)),
      columns_(makePass(device, bindings, inGroups(device, build), sat_columns_groups_comp, sat_columns_comp,
                        scheme)),
      rowGroups_(inGroups(device, build) ? size.y : groupsFor(size.y, kGroupSize), 1, 1),
      columnGroups_(groupsFor(size.x + 1, inGroups(device, build) ? kGroupSize / kSegments : kGroupSize), 1,
                    1) {
  for (int i = 0; i < 2; ++i)
    entries_.emplace_back(device, "summed-area table of the light",
                          uint64_t(size.x + 1) * (size.y + 1) * entryBytes(scheme));
  bindings.set(kLightRowFactors, rowFactors_);
  bindings.set(kLightRowSums, rowSums_);
}

void LightTable::setFixedPoint(Device& device, Bindings& bindings, const FixedPoint& fixedPoint) {
  upload(device, rowFactors_, std::as_bytes(std::span(fixedPoint.rowFactors)));
  bindings.set(kLightEntries, entries_[1 - shown_]);
}

void LightTable::build(Commands& commands) const {
  commands.dispatch(rows_, rowGroups_);
  commands.dispatch(columns_, columnGroups_);
}

}  // namespace boxlight::gpu
