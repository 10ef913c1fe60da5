// SPDX-License-Identifier: Apache-2.0
#include "runtime/light/light_map_pass.h"

#include <span>

#include "common/light/light_map.h"
#include "shaders/shared.h"
#include "spirv/highlights_comp.h"
#include "spirv/light_map_comp.h"
#include "spirv/tilted_map_comp.h"

namespace boxlight::gpu {
namespace {

uint32_t groupsFor(uint32_t threads, uint32_t groupSize) { return (threads + groupSize - 1) / groupSize; }

/// A new buffer where the old one has another size.
template <class T>
void store(Device& device, Bindings& bindings, uint32_t binding, Buffer& buffer, const char* name,
           const std::vector<T>& values) {
  if (buffer.size() != values.size() * sizeof(T)) {
    buffer = Buffer(device, name, values.size() * sizeof(T));
    bindings.set(binding, buffer);
  }
  upload(device, buffer, std::as_bytes(std::span(values)));
}

void append(std::vector<float>& floats, const std::vector<vec2>& pairs) {
  for (const vec2& pair : pairs) floats.insert(floats.end(), {pair.x, pair.y});
}

std::vector<float> flatten(const TiltTables& tables) {
  std::vector<float> floats;
  append(floats, tables.columns);
  append(floats, tables.rows);
  append(floats, tables.columnEdges);
  floats.insert(floats.end(), tables.rowEdges.begin(), tables.rowEdges.end());
  return floats;
}

}  // namespace

LightMapPass::LightMapPass(Device& device, Bindings& bindings, uvec2 size)
    : size_(size),
      constants_(device, "light constants", sizeof(LightConstants)),
      image_(device, "environment", 0),
      tables_(device, "tables of the light map", 0),
      covers_(device, "covers of the light map", 0),
      map_(device, "light map", uint64_t(size.x) * size.y * 3 * sizeof(float)),
      highlights_(device, "highlights", 0),
      levelMap_(device, bindings, light_map_comp),
      tiltedMap_(device, bindings, tilted_map_comp),
      addHighlights_(device, bindings, highlights_comp) {
  bindings.set(kLightConstants, constants_);
  bindings.set(kLightImage, image_);
  bindings.set(kLightTables, tables_);
  bindings.set(kLightCovers, covers_);
  bindings.set(kLightMap, map_);
  bindings.set(kLightHighlights, highlights_);
}

void LightMapPass::setImage(Device& device, Bindings& bindings, const Image& image) {
  imageSize_ = {image.width, image.height};
  store(device, bindings, kLightImage, image_, "environment", image.pixels);
}

std::vector<float> LightMapPass::levelTables(Device& device, Bindings& bindings, LightConstants& constants) {
  AxisCover covers = coverColumns(imageSize_.x, size_.x);
  const AxisCover rows = coverRows(imageSize_.y, size_.y);
  const uint32_t columnShares = constants.columnShares = uint32_t(covers.share.size());
  for (const auto& [first, begin, end] : rows.texels)
    covers.texels.push_back({first, begin + columnShares, end + columnShares});
  covers.share.insert(covers.share.end(), rows.share.begin(), rows.share.end());
  store(device, bindings, kLightCovers, covers_, "covers of the light map", covers.texels);
  return std::move(covers.share);
}

void LightMapPass::setTilt(Device& device, Bindings& bindings, const Image& image, EnvironmentTilt tilt) {
  LightConstants constants{imageSize_, size_};
  level_ = tilt.isLevel();
  std::vector<float> tables;
  if (level_) {
    tables = levelTables(device, bindings, constants);
  } else {
    const TiltTables tilted = makeTiltTables(imageSize_, size_);
    const TiltedLight light = splitHighlights(image, size_, tilt);
    const glm::mat3 toImage(untilt(tilt));
    for (int k = 0; k < 3; ++k) constants.toImage[k] = vec4(toImage[k], 0.0f);
    constants.ceiling = vec4(light.ceiling, 0.0f);
    constants.samplesPerAxis = tilted.samplesPerAxis;
    constants.highlightCount = highlightCount_ = uint32_t(light.highlights.size());
    tables = flatten(tilted);
    store(device, bindings, kLightHighlights, highlights_, "highlights", light.highlights);
  }
  store(device, bindings, kLightTables, tables_, "tables of the light map", tables);
  upload(device, constants_, std::as_bytes(std::span(&constants, 1)));
}

void LightMapPass::make(Commands& commands) const {
  const uvec3 groups(groupsFor(size_.x, kPixelGroup), groupsFor(size_.y, kPixelGroup), 1);
  commands.dispatch(level_ ? levelMap_ : tiltedMap_, groups);
  if (!level_ && highlightCount_ > 0)
    commands.dispatch(addHighlights_, {groupsFor(highlightCount_, kGroupSize), 1, 1});
}

}  // namespace boxlight::gpu
