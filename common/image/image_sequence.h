// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

namespace boxlight {

/// File names of numbered images: a run of # in the name stands for the frame's number, with as many digits
/// at least, "sky.####.exr" for sky.0001.exr; so does printf's %d, %04d. The folder's name is taken as it is.
bool isNumbered(const std::filesystem::path& path);
/// The name of one frame; a path without a place for the number is returned as it is.
std::filesystem::path numberedPath(const std::filesystem::path& path, uint32_t frame);

}  // namespace boxlight
