// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <functional>
#include <span>
#include <string>

#include "common/base/error.h"

namespace boxlight::asset {

enum class Severity { note, warning, error };

/// Everything that can be wrong with a .ptb. The numbers are public (docs/format.md, "Findings") and never
/// change.
enum class FindingCode : int {
  tooShort = 101,
  magic = 102,
  majorVersion = 103,
  fileSize = 104,
  chunkTable = 105,
  headHash = 106,
  scheme = 107,
  newerMinor = 108,
  chunkRange = 201,
  chunkOverlap = 202,
  chunkDuplicate = 203,
  chunkMissing = 204,
  chunkUnknown = 205,
  chunkSkipped = 206,
  chunkCodec = 207,
  chunkSize = 208,
  chunkHash = 209,
  chunkFrame = 210,
  provenance = 301,
  counts = 302,
  limits = 303,
  viewCount = 304,
  notFinite = 305,
  bounds = 306,
  vertexFrame = 307,
  triangleVertex = 308,
  triangleMaterial = 309,
  materialTexture = 310,
  materialValue = 311,
  textureLayout = 312,
  atlasRecord = 313,
  recordMaterial = 314,
  recordTexel = 315,
  recordFrame = 316,
  recordValue = 317,
  tileRange = 318,
  tileBoxes = 319,
  maskBits = 320,
  reserved = 321,
  vertexAtlasUv = 322,
  extensionMissing = 323,
  extensionValue = 324,
  visibilityMaps = 325,
  directionCells = 326,
  coarseViews = 327,
  atlasLevels = 328,
  pageSize = 401,
  pageRange = 402,
  pageHash = 403,
  pageFrame = 404,
  boxRange = 405,
  boxEnergy = 406,
  kernelEnergy = 407,
  boxKind = 408,
  emittedSlots = 409,
  hiddenPart = 410,
};

/// What does not depend on the file at hand. `exitCode` is what a program that cannot go on ends with.
struct FindingKind {
  FindingCode code;
  Severity severity;
  const char* title;
  const char* remedy;
  ExitCode exitCode = ExitCode::invalidInput;
};

std::span<const FindingKind> findingKinds();
const FindingKind& findingKind(FindingCode code);
const char* severityName(Severity severity);

struct Finding {
  const FindingKind* kind;
  std::string chunk;  ///< four letters, or "head"
  std::string place;  ///< "vertex 7"; empty if it is the chunk as a whole
  std::string what;

  /// "VERT: vertex 7: what; remedy"
  std::string message() const;
};

/// Where checks put what they find. A sink that throws makes the first error the last.
class Reporter {
 public:
  using Sink = std::function<void(Finding)>;
  explicit Reporter(Sink sink) : sink_(std::move(sink)) {}

  template <class... Args>
  void operator()(FindingCode code, uint32_t chunk, std::string place, fmt::format_string<Args...> format,
                  Args&&... args) const {
    sink_({&findingKind(code), chunkName(chunk), std::move(place),
           fmt::format(format, std::forward<Args>(args)...)});
  }

  static std::string chunkName(uint32_t type);  ///< printable whatever the bytes; 0 is "head"

 private:
  Sink sink_;
};

/// For who cannot go on after an error: throws it as "file: message", ignores the rest.
Reporter throwingReporter(std::string file);

}  // namespace boxlight::asset
