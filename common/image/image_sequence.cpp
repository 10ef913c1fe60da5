// SPDX-License-Identifier: Apache-2.0
#include "common/image/image_sequence.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>

namespace boxlight {
namespace {

struct Place {
  size_t begin = 0, length = 0;  // in the name
  int digits = 1;
};

constexpr size_t kNowhere = std::string::npos;

std::optional<Place> findPrintf(const std::string& name) {
  for (size_t at = name.find('%'); at != kNowhere; at = name.find('%', at + 1)) {
    int digits = 1;
    const char* const end = name.data() + name.size();
    const char* after = std::from_chars(name.data() + at + 1, end, digits).ptr;
    if (after != end && *after == 'd' && digits >= 0 && digits <= 9)
      return Place{at, size_t(after - name.data()) + 1 - at, digits};
  }
  return {};
}

std::optional<Place> findPlace(const std::string& name) {
  const size_t begin = name.find('#');
  if (begin == kNowhere) return findPrintf(name);
  const size_t end = std::min(name.find_first_not_of('#', begin), name.size());
  return Place{begin, end - begin, int(end - begin)};
}

}  // namespace

bool isNumbered(const std::filesystem::path& path) { return findPlace(path.filename().string()).has_value(); }

std::filesystem::path numberedPath(const std::filesystem::path& path, uint32_t frame) {
  std::string name = path.filename().string();
  const auto place = findPlace(name);
  if (!place) return path;
  name.replace(place->begin, place->length, fmt::format("{:0{}}", frame, place->digits));
  return path.parent_path() / name;
}

}  // namespace boxlight
