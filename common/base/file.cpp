// SPDX-License-Identifier: Apache-2.0
#include "common/base/file.h"

#include <fcntl.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "common/base/error.h"

namespace boxlight {
namespace {

[[noreturn]] void failIo(const char* what, const std::filesystem::path& path) {
  fail(ExitCode::io, "{}: cannot {}: {}", path.string(), what, std::strerror(errno));
}

void syncFolder(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // some file systems do not let a folder be opened; the rename itself succeeded
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

std::vector<std::byte> readFile(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    fail(ExitCode::io, "{}: cannot read: it is a folder", path.string());
  errno = 0;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) failIo("open", path);
  const auto size = std::streamoff(file.tellg());
  if (size < 0) failIo("read", path);
  std::vector<std::byte> bytes(static_cast<size_t>(size));
  file.seekg(0);
  if (!file.read(reinterpret_cast<char*>(bytes.data()), size)) failIo("read", path);
  return bytes;
}

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code ignored;
  if (std::filesystem::is_symlink(path_, ignored)) path_ = std::filesystem::weakly_canonical(path_, ignored);
  // rename would find out too, or put a file in the place of a device, but only when the work is done.
  if (std::filesystem::exists(path_, ignored) && !std::filesystem::is_regular_file(path_, ignored))
    fail(ExitCode::io, "{}: cannot write: it is no regular file", path_.string());
  temporary_ = path_;
  temporary_.replace_filename(
      fmt::format(".{}.{}.tmp{}", path_.stem().string(), ::getpid(), path_.extension().string()));
  descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) failIo("write", path_);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  writeAt(size_, bytes);
  size_ += bytes.size();
}

void AtomicFile::writeAt(uint64_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), off_t(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) failIo("write", path_);
    offset += uint64_t(written);
    bytes = bytes.subspan(size_t(written));
  }
}

void AtomicFile::commit() {
  // A library may have replaced the temporary file by name: sync what is there now.
  const int descriptor = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
  if (descriptor >= 0) ::close(descriptor);
  if (!synced) failIo("sync", path_);
  const bool closed = ::close(std::exchange(descriptor_, -1)) == 0;
  if (!closed) ::unlink(temporary_.c_str());
  if (!closed) failIo("close", path_);
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
    const int reason = errno;
    ::unlink(temporary_.c_str());
    errno = reason;
    failIo("rename the finished file to", path_);
  }
  syncFolder(path_);
}

void writeTextFile(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
}

void checkOutput(const std::filesystem::path& output, std::initializer_list<std::filesystem::path> others) {
  std::error_code ignored;
  for (const std::filesystem::path& other : others)
    if (other == output || std::filesystem::equivalent(output, other, ignored))
      fail(ExitCode::usage, "{}: is both written and used otherwise; give the output a name of its own",
           output.string());
  const AtomicFile probe(output);
}

uint64_t xxh64(std::span<const std::byte> bytes, uint64_t seed) {
  return XXH64(bytes.data(), bytes.size(), seed);
}

}  // namespace boxlight
