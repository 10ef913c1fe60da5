// SPDX-License-Identifier: Apache-2.0
#include "common/base/progress.h"

#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "common/base/error.h"

namespace boxlight {
namespace {

template <class Action>
std::string stderrOf(const Action& action) {
  testing::internal::CaptureStderr();
  action();
  return testing::internal::GetCapturedStderr();
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Progress, LastLineSaysAll) {
  const auto lines = linesOf(stderrOf([] {
    Progress progress("tracing", 50, ProgressStyle::lines);
    for (int i = 0; i < 50; ++i) progress.advance();
  }));
  ASSERT_FALSE(lines.empty());
  EXPECT_LE(lines.size(), 3u) << "a fast task must not flood a log";
  EXPECT_NE(lines.back().find("tracing: 50/50 (100%)"), std::string::npos) << lines.back();
}

TEST(Progress, AutomaticIsLinesWhenNotOnATerminal) {
  const std::string text = stderrOf([] { Progress("task", 2, ProgressStyle::automatic).advance(2); });
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_NE(text.find("2/2"), std::string::npos);
}

TEST(Progress, JsonLinesParse) {
  const auto lines = linesOf(stderrOf([] { Progress("task", 4, ProgressStyle::json).advance(3); }));
  ASSERT_FALSE(lines.empty());
  const auto json = nlohmann::json::parse(lines.back());
  EXPECT_EQ(json["done"], 3);
  EXPECT_EQ(json["total"], 4);
  EXPECT_GE(json["left_s"].get<double>(), 0.0);
}

TEST(Progress, BarSurvivesTooManySteps) {
  const std::string text = stderrOf([] { Progress("task", 4, ProgressStyle::bar).advance(9); });
  EXPECT_NE(text.find("100%"), std::string::npos);
}

TEST(Progress, NoneIsSilent) {
  EXPECT_EQ(stderrOf([] { Progress("task", 4, ProgressStyle::none).advance(4); }), "");
  EXPECT_EQ(stderrOf([] { Progress("nothing to do", 0, ProgressStyle::lines); }), "");
}

TEST(Progress, CountsEveryThread) {
  const auto lines = linesOf(stderrOf([] {
    Progress progress("task", 4000, ProgressStyle::lines);
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&] {
        for (int i = 0; i < 1000; ++i) progress.advance();
      });
  }));
  EXPECT_NE(lines.back().find("4000/4000"), std::string::npos);
}

TEST(InterruptDeathTest, FirstSignalIsAFlagAndSecondEnds) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_FALSE(interrupted());
  EXPECT_NO_THROW(throwIfInterrupted("not yet"));
  EXPECT_EXIT(
      {
        catchInterrupts();
        std::raise(SIGTERM);
        try {
          throwIfInterrupted("stopped");
        } catch (const Error& error) {
          std::exit(int(error.code()));
        }
        std::exit(0);
      },
      testing::ExitedWithCode(6), "");
  EXPECT_EXIT(
      {
        catchInterrupts();
        std::raise(SIGINT);
        std::raise(SIGINT);
        std::exit(0);
      },
      testing::ExitedWithCode(130), "");
}

}  // namespace
}  // namespace boxlight
