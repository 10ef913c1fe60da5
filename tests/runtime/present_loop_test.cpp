// SPDX-License-Identifier: Apache-2.0
// What an X server without a window manager never says: out of date, no area, twice in a row.
#include "runtime/vulkan/present_loop.h"

#include <gtest/gtest.h>

#include <deque>
#include <string>

namespace boxlight::gpu {
namespace {

constexpr auto kReady = SurfaceState::ready, kSuboptimal = SurfaceState::suboptimal,
               kOutOfDate = SurfaceState::outOfDate;

/// Notes what is asked of it: r(ecreate), a(cquire), p(resent), and d(raw).
struct FakeTarget : PresentTarget {
  uvec2 extent() const override { return size; }
  void recreate(uvec2 framebufferSize) override {
    calls += 'r';
    size = hasArea ? framebufferSize : uvec2(0);
  }
  SurfaceState acquire() override { return answer('a', acquired); }
  SurfaceState present() override { return answer('p', presented); }
  SurfaceState answer(char call, std::deque<SurfaceState>& answers) {
    calls += call;
    const SurfaceState state = answers.empty() ? kReady : answers.front();
    if (!answers.empty()) answers.pop_front();
    return state;
  }

  uvec2 size{0};
  bool hasArea = true;
  std::deque<SurfaceState> acquired, presented;
  std::string calls;
};

class PresentLoopTest : public testing::Test {
 protected:
  bool show(uvec2 size = {40, 30}) {
    target_.calls.clear();
    return loop_.show(size, [&] { target_.calls += 'd'; });
  }
  FakeTarget target_;
  PresentLoop loop_{target_};
};

TEST_F(PresentLoopTest, ImagesAreMadeOnce) {
  EXPECT_TRUE(show());
  EXPECT_EQ(target_.calls, "radp");
  EXPECT_TRUE(show());
  EXPECT_EQ(target_.calls, "adp");
}

TEST_F(PresentLoopTest, AnotherSizeMakesOthers) {
  show();
  EXPECT_TRUE(show({41, 30}));
  EXPECT_EQ(target_.calls, "radp");
}

TEST_F(PresentLoopTest, OutOfDateOnAcquireIsMendedAtOnce) {
  show();
  target_.acquired = {kOutOfDate};
  EXPECT_TRUE(show());
  EXPECT_EQ(target_.calls, "aradp");
}

TEST_F(PresentLoopTest, OutOfDateTwiceDrawsNothing) {
  show();
  target_.acquired = {kOutOfDate, kOutOfDate};
  EXPECT_FALSE(show());
  EXPECT_EQ(target_.calls, "ara");
  EXPECT_TRUE(show());
  EXPECT_EQ(target_.calls, "radp");
}

TEST_F(PresentLoopTest, OutOfDateOnPresentIsNotShown) {
  show();
  target_.presented = {kOutOfDate};
  EXPECT_FALSE(show());
  EXPECT_TRUE(show());
  EXPECT_EQ(target_.calls, "radp");
}

TEST_F(PresentLoopTest, SuboptimalIsShownAndMendedLater) {
  for (const bool onAcquire : {true, false}) {
    show();
    (onAcquire ? target_.acquired : target_.presented) = {kSuboptimal};
    EXPECT_TRUE(show());
    EXPECT_EQ(target_.calls, "adp");
    EXPECT_TRUE(show());
    EXPECT_EQ(target_.calls, "radp");
  }
}

TEST_F(PresentLoopTest, AMinimisedWindowIsLeftAlone) {
  show();
  EXPECT_FALSE(show({0, 0}));
  EXPECT_FALSE(show({40, 0}));
  EXPECT_EQ(target_.calls, "");
  EXPECT_TRUE(show());
  EXPECT_EQ(target_.calls, "adp");
}

TEST_F(PresentLoopTest, ASurfaceWithoutAreaHasNoImages) {
  target_.hasArea = false;  // while GLFW still reports the size before
  EXPECT_FALSE(show());
  EXPECT_EQ(target_.calls, "rr");
  target_.hasArea = true;
  EXPECT_TRUE(show());
  EXPECT_EQ(target_.calls, "radp");
}

}  // namespace
}  // namespace boxlight::gpu
