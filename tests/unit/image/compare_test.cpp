// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bake/commands/cmd_compare.h"
#include "common/base/error.h"
#include "common/image/image.h"
#include "tests/unit/temporary_folder.h"

namespace boxlight {
namespace {

class CompareTest : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    Image image = makeImage(8, 4, 3);
    writeImage(folder_ / "black.exr", image);
    for (float& value : image.pixels) value = 0.25f;
    writeImage(folder_ / "grey.exr", image);
    writeImage(folder_ / "small.exr", makeImage(4, 4, 3));
  }

  int compare(std::vector<std::string> arguments) {
    for (std::string& argument : arguments)
      if (argument.find(".exr") != std::string::npos || argument.find(".png") != std::string::npos)
        argument = (folder_ / argument).string();
    arguments.insert(arguments.begin(), {"ptbake", "compare"});
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    CLI::App app("", "ptbake");
    CommonOptions common;
    addCompareCommand(app, common);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = runMain(app, int(argv.size()), argv.data(), common, [] {});
    out_ = testing::internal::GetCapturedStdout();
    err_ = testing::internal::GetCapturedStderr();
    return code;
  }

  std::string out_, err_;
};

TEST_F(CompareTest, Text) {
  EXPECT_EQ(compare({"grey.exr", "black.exr"}), 0);
  EXPECT_NE(out_.find("RMSE          0.25\n"), std::string::npos) << out_;
  EXPECT_NE(out_.find("32 of 32 (all pixels"), std::string::npos) << out_;
  EXPECT_TRUE(err_.empty()) << err_;
}

TEST_F(CompareTest, Json) {
  EXPECT_EQ(compare({"grey.exr", "grey.exr", "--json"}), 0);
  const auto json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["rmse"], 0.0);
  EXPECT_EQ(json["pixels"], 32);
  EXPECT_TRUE(json["psnr_db"].is_null());
  EXPECT_EQ(compare({"black.exr", "grey.exr", "--json"}), 0);
  EXPECT_NEAR(nlohmann::json::parse(out_)["bias"].get<double>(), -1.0, 1e-12);
}

TEST_F(CompareTest, FailsAboveTheLimitOnly) {
  EXPECT_EQ(compare({"grey.exr", "black.exr", "--fail", "0.25"}), 0);
  EXPECT_EQ(compare({"grey.exr", "black.exr", "--fail", "0.249"}), 7);
  EXPECT_NE(out_.find("RMSE"), std::string::npos) << "the figures are printed all the same";
  EXPECT_EQ(compare({"grey.exr", "grey.exr", "--fail", "0"}), 0);
}

TEST_F(CompareTest, WritesTheDifference) {
  EXPECT_EQ(compare({"grey.exr", "black.exr", "--diff", "d.png", "--fail", "0"}), 7);
  EXPECT_EQ(readImage(folder_ / "d.png").width, 8u) << "kept on failure, when it is wanted most";
}

TEST_F(CompareTest, WrongInput) {
  EXPECT_EQ(compare({"grey.exr"}), 1);
  EXPECT_EQ(compare({"grey.exr", "black.exr", "--fail", "-1"}), 1);
  EXPECT_EQ(compare({"grey.exr", "black.exr", "--fail", "nan"}), 1) << "nothing is above NaN";
  EXPECT_EQ(compare({"grey.exr", "black.exr", "--diff", "d.exr"}), 1);
  EXPECT_EQ(compare({"grey.exr", "missing.exr"}), 2);
  EXPECT_EQ(compare({"grey.exr", "small.exr"}), 3);
  EXPECT_NE(err_.find("8x4"), std::string::npos) << err_;
}

}  // namespace
}  // namespace boxlight
