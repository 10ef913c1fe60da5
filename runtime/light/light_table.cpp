// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/light_table.h"

#include <cstdint>

#include "runtime/light/fixed_point.h"
#include "shaders/shared.h"
#include "spirv/sat_columns_comp.h"
#include "spirv/sat_rows_comp.h"

namespace boxlight::gpu {
namespace {

uint32_t groupsFor(uint32_t threads) { return (threads + kGroupSize - 1) / kGroupSize; }

}  // namespace

LightTable::LightTable(Device& device, Bindings& bindings, const Image& lightMap)
    : size_(lightMap.width, lightMap.height),
      unit_(1.0f),
      lightMap_(makeBuffer(device, "light map", lightMap.pixels)),
      rowFactors_(device, "row factors", lightMap.height * sizeof(float)),
      rowSums_(device, "row sums of the light map", uint64_t(size_.x) * size_.y * sizeof(RowSum)),
      entries_(device, "summed-area table", uint64_t(size_.x + 1) * (size_.y + 1) * sizeof(uvec4)),
      rows_(device, bindings, sat_rows_comp),
      columns_(device, bindings, sat_columns_comp) {
  const FixedPoint fixedPoint = chooseFixedPoint(lightMap);
  unit_ = fixedPoint.unit;
  upload(device, rowFactors_, std::as_bytes(std::span(fixedPoint.rowFactors)));
  bindings.set(kBindLightMap, lightMap_);
  bindings.set(kBindRowFactors, rowFactors_);
  bindings.set(kBindRowSums, rowSums_);
  bindings.set(kBindSummedArea, entries_);
}

void LightTable::build(Commands& commands) const {
  commands.dispatch(rows_, {groupsFor(size_.y), 1, 1});
  commands.dispatch(columns_, {groupsFor(size_.x + 1), 1, 1});
}

}  // namespace boxlight::gpu
