// SPDX-License-Identifier: Apache-2.0
#include "common/base/cli.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

struct Outcome {
  int code = -1;
  std::string out, err;
};

/// A program "tool" with one command "work" that takes every kind of option and calls `action`.
struct Tool {
  CommonOptions common;
  vec3 place{0.0f};
  std::optional<vec3> target;
  uvec2 size{1, 1};
  bool background = true;
  std::function<void()> action = [] {};

  Outcome run(std::vector<std::string> arguments) {
    CLI::App app("A tool", "tool");
    app.require_subcommand(1);
    CLI::App* work = app.add_subcommand("work", "Works");
    addCommonOptions(*work, common);
    addVec3(*work, "--place", place, "A place");
    addVec3(*work, "--target", target, "Another place");
    addSize(*work, "--size", size, "A size");
    addOnOff(*work, "--background", background, "A switch");
    work->callback([this] { action(); });
    arguments.insert(arguments.begin(), "tool");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = runMain(app, int(argv.size()), argv.data(), common, [] {});
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
  }
};

TEST(Cli, HelpAndVersionAreSuccessOnStdout) {
  for (const auto& arguments : {std::vector<std::string>{"--help"}, {"work", "--help"}, {"--version"}}) {
    const Outcome outcome = Tool().run(arguments);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_FALSE(outcome.out.empty());
    EXPECT_TRUE(outcome.err.empty()) << outcome.err;
  }
  EXPECT_EQ(Tool().run({"--version"}).out, "tool " BOXLIGHT_VERSION "\n");
}

TEST(Cli, UsageErrorsAreOneOnStderr) {
  for (const auto& arguments : {std::vector<std::string>{},
                                {"play"},
                                {"work", "--unknown"},
                                {"work", "--threads", "-1"},
                                {"work", "--progress", "loud"},
                                {"work", "-q", "-v"},
                                {"work", "--background", "maybe"}}) {
    const Outcome outcome = Tool().run(arguments);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
    EXPECT_FALSE(outcome.err.empty());
  }
}

TEST(Cli, ErrorsEndWithTheirCode) {
  Tool tool;
  tool.action = [] { fail(ExitCode::unsupported, "{}: too new", "a.glb"); };
  const Outcome outcome = tool.run({"work"});
  EXPECT_EQ(outcome.code, 5);
  EXPECT_NE(outcome.err.find("a.glb: too new"), std::string::npos);
  EXPECT_TRUE(outcome.out.empty());

  tool.action = [] { throw std::bad_alloc(); };
  EXPECT_EQ(tool.run({"work"}).code, 4);
  tool.action = [] { throw std::runtime_error("odd"); };
  EXPECT_EQ(tool.run({"work"}).code, 4);
}

TEST(Cli, VerbosityHoldsInsideTheCommand) {
  Tool tool;
  tool.action = [] {
    log().debug("details");
    log().info("news");
    log().error("trouble");
  };
  const std::string quiet = tool.run({"work", "-q"}).err;
  EXPECT_EQ(quiet.find("news"), std::string::npos);
  EXPECT_NE(quiet.find("trouble"), std::string::npos);
  tool.common = {};
  EXPECT_EQ(tool.run({"work"}).err.find("details"), std::string::npos);
  EXPECT_NE(tool.run({"work", "-v"}).err.find("details"), std::string::npos);
}

TEST(CliDeathTest, AFullDiskIsAnError) {
  GTEST_FLAG_SET(death_test_style,
                 "threadsafe");  // libraries start threads before main, so a plain fork could hang
  EXPECT_EXIT(
      {
        if (!std::freopen("/dev/full", "w", stdout)) std::exit(99);
        CLI::App app("A tool", "tool");
        char name[] = "tool";
        char* argv[] = {name};
        std::exit(runMain(app, 1, argv, {}, [] { fmt::print("result\n"); }));
      },
      testing::ExitedWithCode(2), "stdout");
}

TEST(Cli, Values) {
  Tool tool;
  EXPECT_EQ(tool.run({"work", "--place", "1,-2.5,3e2", "--target=0,0,-1", "--size", "640x480", "--background",
                      "off"})
                .code,
            0);
  EXPECT_EQ(tool.place, vec3(1.0f, -2.5f, 300.0f));
  ASSERT_TRUE(tool.target.has_value());
  EXPECT_EQ(*tool.target, vec3(0, 0, -1));
  EXPECT_EQ(tool.size, uvec2(640, 480));
  EXPECT_FALSE(tool.background);
  EXPECT_FALSE(Tool().target.has_value());
  EXPECT_EQ(resolveThreads(3), 3);
  EXPECT_GE(resolveThreads(0), 1);
}

TEST(Cli, MalformedValuesAreRefused) {
  for (const char* place :
       {"", "1,2", "1,2,3,4", "1,2,3x", "a,b,c", "1;2;3", "nan,0,0", "0,inf,0", "1e99,0,0", "1,,3"})
    EXPECT_EQ(Tool().run({"work", std::string("--place=") + place}).code, 1) << place;
  for (const char* size : {"", "640", "640x", "x480", "0x480", "640x-1", "640X480x2", "640x480x2", "16385x1",
                           "4294967297x1", "6.5x4"})
    EXPECT_EQ(Tool().run({"work", std::string("--size=") + size}).code, 1) << size;
}

}  // namespace
}  // namespace boxlight
