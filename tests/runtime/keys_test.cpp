// SPDX-License-Identifier: Apache-2.0
#include "runtime/app/keys.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace boxlight::gpu {
namespace {

TEST(Keys, TheDocumentHasTheProgramsTable) {
  std::ostringstream text;
  text << std::ifstream(BOXLIGHT_SOURCE "/docs/ptview.md").rdbuf();
  EXPECT_NE(text.str().find(keysAsMarkdown()), std::string::npos)
      << "put the output of ptview --list-keys into docs/ptview.md";
}

TEST(Keys, EveryKeyMeansWhatItsRowSays) {
  for (const KeyBinding& row : keyTable()) {
    if (row.key == 0) continue;
    for (const bool flying : {false, true}) {
      const auto action = actionOf(row.key, row.shift, row.control, flying);
      const bool holds = row.mode == KeyMode::always || flying == (row.mode == KeyMode::flying);
      if (holds) {
        EXPECT_EQ(action, row.action) << row.keys << (flying ? " flying" : " orbiting");
      } else {
        EXPECT_NE(action, row.action) << row.keys;
      }
    }
  }
}

TEST(Keys, EIsExposureOnlyOutsideOfFlyMode) {
  EXPECT_EQ(actionOf('E', false, false, false), Action::brighter);
  EXPECT_EQ(actionOf('E', true, false, false), Action::darker);
  EXPECT_EQ(actionOf('E', false, false, true), Action::flyUp);
  EXPECT_EQ(actionOf('E', true, false, true), Action::flyUp);  // fast
  EXPECT_EQ(actionOf('W', false, false, false), std::nullopt);
  EXPECT_EQ(actionOf('Q', false, true, true), Action::quit);
}

}  // namespace
}  // namespace boxlight::gpu
