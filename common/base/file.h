// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace boxlight {

/// The whole file. Error: ExitCode::io with the path and the system's reason.
std::vector<std::byte> readFile(const std::filesystem::path& path);

/// Output that appears whole or not at all: bytes go to `.<stem>.<pid>.tmp<extension>` beside it; commit()
/// syncs it and renames it over `path`; without commit the destructor removes it. Every write is checked.
/// Errors: ExitCode::io.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::span<const std::byte> bytes);
  void writeAt(uint64_t offset, std::span<const std::byte> bytes);  ///< does not move the end of the file
  uint64_t size() const { return size_; }
  /// For libraries that write by name: the temporary path (keeps `path`'s extension).
  const std::filesystem::path& temporaryPath() const { return temporary_; }
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  int descriptor_ = -1;
  uint64_t size_ = 0;
};

void writeTextFile(const std::filesystem::path& path, std::string_view text);  ///< by AtomicFile

/// What a long task asks before it starts: can `output` be written, and is it none of `others` (inputs and
/// other outputs)? Errors: ExitCode::io, ExitCode::usage.
void checkOutput(const std::filesystem::path& output, std::initializer_list<std::filesystem::path> others);

uint64_t xxh64(std::span<const std::byte> bytes, uint64_t seed = 0);

}  // namespace boxlight
