// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "common/asset/asset.h"
#include "runtime/app/frame.h"
#include "shaders/shared.h"

namespace boxlight::gpu {

/// Image tiles that cover the picture, within what the device's images and buffers hold; the first is the
/// largest.
std::vector<ImageTile> splitPicture(const FrameSettings& settings, const DeviceLimits& limits, bool blended);

FrameConstants frameConstants(const asset::Asset& asset, const FrameSettings& settings, const Light& light);

/// Adds the times of passes of the same name.
void addTimes(std::vector<PassTime>& total, const std::vector<PassTime>& times);

}  // namespace boxlight::gpu
