// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "common/base/error.h"

namespace boxlight {

/// Fails with the message "file: place: reason; remedy". `place` is a path in the document, such as
/// meshes[0].primitives[1].attributes.POSITION.
template <class... Args>
[[noreturn]] void failAt(ExitCode code, const std::filesystem::path& file, std::string_view place,
                         fmt::format_string<Args...> format, Args&&... args) {
  fail(code, "{}: {}: {}", file.string(), place, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace boxlight
