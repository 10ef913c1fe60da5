// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <limits>

#include "common/asset/asset_validate.h"
#include "common/base/file.h"
#include "tests/format/sample_asset.h"
#include "tests/unit/asset/surgeon.h"

namespace boxlight::asset {

/// An operation on makeSample(size) after which this finding must be there.
struct Case {
  const char* name;
  FindingCode code;
  std::function<void(Surgeon&)> operate;
  SampleSize size = {};
};

inline void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// An edit of one entry of an array chunk.
template <class T>
std::function<void(Surgeon&)> in(uint32_t type, size_t index, std::function<void(T&)> change) {
  return [=](Surgeon& s) { s.edit<T>(type, index, change); };
}
inline std::function<void(Surgeon&)> inEntry(uint32_t type, std::function<void(ChunkEntry&)> change) {
  return [=](Surgeon& s) { change(s.entry(type)); };
}
/// An edit of one box of a page.
inline std::function<void(Surgeon&)> inBox(size_t page, size_t box, std::function<void(PackedBox&)> change) {
  return [=](Surgeon& s) { s.editBox(page, box, change); };
}
inline std::function<void(Surgeon&)> toBox(size_t page, size_t box) {
  return inBox(page, box, [](PackedBox& b) { b = packBox({0, 0, 0.5f, 0.5f, Rgb(0.25f)}); });
}
inline std::function<void(Surgeon&)> toHidden(size_t page, size_t box) {
  return inBox(page, box, [](PackedBox& b) { b = packHiddenPart(0.5f); });
}
/// An edit of a record's flags.
inline std::function<void(Surgeon&)> inFlags(size_t record, std::function<void(uint32_t&)> change) {
  return in<TexelRecord>(chunk::kRecords, record, [=](TexelRecord& r) { change(r.flags); });
}

/// A table of another length, cut or with zeros at its end.
inline std::function<void(Surgeon&)> resizeTable(uint32_t type, size_t bytes) {
  return [=](Surgeon& s) {
    Bytes table = s.chunk(type);
    table.resize(bytes);
    s.setChunk(type, table);
  };
}

/// What validation finds in a sample after an edit; the edited file stays as long as `file`.
inline Validation validationAfter(const SampleSize& size, const std::function<void(Surgeon&)>& operate,
                                  const TemporaryFile& file = {}) {
  makeSample(size).write(file.path);
  Surgeon surgeon(readFile(file.path));
  operate(surgeon);
  surgeon.write(file.path);
  return validateAsset(file.path);
}

/// For findings that end the reading.
class Hostile : public ::testing::TestWithParam<Case> {
 protected:
  Hostile() : validation(validationAfter(GetParam().size, GetParam().operate, file)) {}
  std::string found() const {
    std::string list;
    for (const Finding& finding : validation.findings)
      list += fmt::format("\n{}: {}", int(finding.kind->code), finding.message());
    return list;
  }
  const TemporaryFile file;
  Validation validation;
};
/// For those that do not.
class Harmless : public Hostile {};

inline const auto kCaseName = [](const auto& test) { return test.param.name; };

}  // namespace boxlight::asset
