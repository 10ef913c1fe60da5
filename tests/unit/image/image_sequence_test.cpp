// SPDX-License-Identifier: Apache-2.0
#include "common/image/image_sequence.h"

#include <gtest/gtest.h>

namespace boxlight {
namespace {

TEST(ImageSequence, NumbersStandWhereTheNameSays) {
  EXPECT_EQ(numberedPath("a/sky.####.exr", 7), "a/sky.0007.exr");
  EXPECT_EQ(numberedPath("sky#.exr", 123), "sky123.exr");
  EXPECT_EQ(numberedPath("sky_%04d.exr", 12), "sky_0012.exr");
  EXPECT_EQ(numberedPath("%d.hdr", 12), "12.hdr");
  EXPECT_EQ(numberedPath("sky.####.exr", 123456), "sky.123456.exr");
  EXPECT_EQ(numberedPath("100%/a#b/sky.exr", 1), "100%/a#b/sky.exr") << "folders are as they are";
}

TEST(ImageSequence, OtherNamesAreOneImage) {
  for (const char* name : {"sky.exr", "50%.exr", "50%x.exr", "%99d.exr", "%s.exr", "a#b/sky.exr"})
    EXPECT_FALSE(isNumbered(name)) << name;
  for (const char* name : {"#.exr", "sky%d", "50%_%03d.exr"}) EXPECT_TRUE(isNumbered(name)) << name;
}

}  // namespace
}  // namespace boxlight
