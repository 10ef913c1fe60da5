// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>

#include "common/asset/asset_validate.h"
#include "common/base/file.h"
#include "tests/format/sample_asset.h"
#include "tests/unit/asset/surgeon.h"

namespace boxlight::asset {
namespace {

/// In place: a file system may flush a file that is truncated and written anew, which thousands of times
/// takes minutes.
void setByte(const std::filesystem::path& path, size_t offset, std::byte value) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(std::streamoff(offset));
  file.put(char(value));
}

/// Which bytes belong to the head or to a chunk: all but padding.
std::vector<bool> meaningfulBytes(const std::filesystem::path& path) {
  const AssetReader reader(path);
  std::vector<bool> meaningful(reader.header().fileSize, false);
  const auto mark = [&](uint64_t offset, uint64_t size) {
    std::fill_n(meaningful.begin() + std::ptrdiff_t(offset), size, true);
  };
  mark(0, sizeof(FileHeader) + reader.chunks().size() * sizeof(ChunkEntry));
  for (const ChunkEntry& entry : reader.chunks()) mark(entry.offset, entry.storedSize);
  return meaningful;
}

enum class Outcome { same, different, damaged, unsupported, other };

Outcome outcome(const std::filesystem::path& path, uint64_t expected) try {
  return contentHash(path) == expected ? Outcome::same : Outcome::different;
} catch (const Error& error) {
  return error.code() == ExitCode::invalidInput  ? Outcome::damaged
         : error.code() == ExitCode::unsupported ? Outcome::unsupported
                                                 : Outcome::other;
}

class Damage : public ::testing::Test {
 protected:
  Damage() {
    makeSample({.records = 3, .recordsPerTile = 2}).write(file.path);
    bytes = readFile(file.path);
    expected = contentHash(file.path);
  }
  const TemporaryFile file;
  Bytes bytes;
  uint64_t expected = 0;
};

TEST_F(Damage, everyFlippedByteIsNoticed) {
  const std::vector<bool> meaningful = meaningfulBytes(file.path);
  for (const std::byte flip : {std::byte(0x01), std::byte(0x80), std::byte(0xFF)})
    for (size_t i = 0; i < bytes.size(); ++i) {
      setByte(file.path, i, bytes[i] ^ flip);
      const bool majorVersion = i == 8 || i == 9;
      const Outcome wanted = !meaningful[i] ? Outcome::same
                             : majorVersion ? Outcome::unsupported
                                            : Outcome::damaged;
      ASSERT_EQ(outcome(file.path, expected), wanted) << "byte " << i;
      ASSERT_EQ(validateAsset(file.path).exitCode() == ExitCode::ok, !meaningful[i]) << "byte " << i;
      setByte(file.path, i, bytes[i]);
    }
}

TEST_F(Damage, everyTruncationIsNoticed) {
  for (size_t length = bytes.size(); length-- > 0;) {
    std::filesystem::resize_file(file.path, length);
    ASSERT_EQ(outcome(file.path, expected), Outcome::damaged) << length;
    ASSERT_EQ(validateAsset(file.path).exitCode(), ExitCode::invalidInput) << length;
  }
}

TEST_F(Damage, anAppendedByteIsNoticed) {
  std::filesystem::resize_file(file.path, bytes.size() + 1);
  EXPECT_EQ(outcome(file.path, expected), Outcome::damaged);
}

TEST_F(Damage, messageOfAnotherVersionNamesBothAndTheRemedy) {
  setByte(file.path, 8, std::byte(2));
  try {
    AssetReader reader(file.path);
    FAIL();
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.code(), ExitCode::unsupported);
    EXPECT_NE(message.find(file.path.string()), std::string::npos) << message;
    EXPECT_NE(message.find("version 2.6"), std::string::npos) << message;
    EXPECT_NE(message.find("version 1.x"), std::string::npos) << message;
    EXPECT_NE(message.find("bake the scene again"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace boxlight::asset
