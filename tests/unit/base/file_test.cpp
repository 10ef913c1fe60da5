// SPDX-License-Identifier: Apache-2.0
#include "common/base/file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "common/base/error.h"
#include "tests/unit/temporary_folder.h"

namespace boxlight {
namespace {

class FileTest : public FolderTest {
 protected:
  size_t fileCount() const {
    return size_t(
        std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()));
  }
  static std::string text(const std::filesystem::path& path) {
    const auto bytes = readFile(path);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  static std::span<const std::byte> bytesOf(std::string_view s) { return std::as_bytes(std::span(s)); }
};

template <class Action>
ExitCode codeOf(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.code();
  }
  return ExitCode::ok;
}

TEST_F(FileTest, AppearsWholeOnCommit) {
  const auto path = folder_ / "a.ptb";
  AtomicFile file(path);
  file.write(bytesOf("head----"));
  file.write(bytesOf("tail"));
  file.writeAt(4, bytesOf("MID!"));
  EXPECT_EQ(file.size(), 12u);
  EXPECT_FALSE(std::filesystem::exists(path));
  file.commit();
  EXPECT_EQ(text(path), "headMID!tail");
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(FileTest, WithoutCommitNothingChanges) {
  const auto path = folder_ / "a.txt";
  writeTextFile(path, "old");
  {
    AtomicFile file(path);
    file.write(bytesOf("new and longer"));
  }
  EXPECT_EQ(text(path), "old");
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(FileTest, LibrariesMayReplaceTheTemporaryFileByName) {
  const auto path = folder_ / "a.exr";
  AtomicFile file(path);
  EXPECT_EQ(file.temporaryPath().extension(), ".exr");
  EXPECT_EQ(file.temporaryPath().parent_path(), folder_);
  std::filesystem::remove(file.temporaryPath());
  std::ofstream(file.temporaryPath()) << "by a library";
  file.commit();
  EXPECT_EQ(text(path), "by a library");
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(FileTest, EmptyFile) {
  writeTextFile(folder_ / "empty", "");
  EXPECT_TRUE(readFile(folder_ / "empty").empty());
}

TEST_F(FileTest, ErrorsNameTheFile) {
  EXPECT_EQ(codeOf([&] { readFile(folder_ / "missing"); }), ExitCode::io);
  EXPECT_EQ(codeOf([&] { readFile(folder_); }), ExitCode::io);
  EXPECT_EQ(codeOf([&] { AtomicFile(folder_ / "no" / "such" / "folder.ptb"); }), ExitCode::io);
  EXPECT_EQ(codeOf([&] { AtomicFile file(folder_); }), ExitCode::io);
  try {
    readFile(folder_ / "missing.ptb");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("missing.ptb: cannot open: No such file"), std::string::npos)
        << error.what();
  }
}

TEST(Xxh64, MatchesThePublishedTestVectors) {
  EXPECT_EQ(xxh64({}), 0xEF46DB3751D8E999ull);
  EXPECT_NE(xxh64({}, 1), xxh64({}));
}

}  // namespace
}  // namespace boxlight
