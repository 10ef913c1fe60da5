// SPDX-License-Identifier: Apache-2.0
// The same input, options and seed give the same bytes, whatever the number of threads.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "common/base/file.h"
#include "tests/known/programs.h"

using namespace boxlight;
using test::file;
using test::run;

TEST(Determinism, BakeGivesTheSameBytesFromOneThreadAndTwo) {
  const std::string scene = file("deterministic.glb"), one = file("one.ptb"), two = file("two.ptb"),
                    other = file("other.ptb");
  run("boxlight_data", "scene sphere_on_ground " + scene + " --set metallic=1");
  const std::string bake = fmt::format("bake {} --atlas 16 --paths 32 -q -o ", scene);
  run("ptbake", bake + one + " --threads 1");
  run("ptbake", bake + two + " --threads 2");
  run("ptbake", bake + other + " --threads 2 --seed 1");
  EXPECT_EQ(readFile(one), readFile(two));
  EXPECT_NE(readFile(one), readFile(other));
}

TEST(Determinism, ChartedBakeGivesTheSameBytesFromOneThreadAndTwo) {
  const std::string scene = file("charted.glb"), one = file("charted1.ptb"), two = file("charted2.ptb");
  run("boxlight_data", "scene sphere_on_ground " + scene);
  const std::string bake = fmt::format("bake {} --atlas 16 --paths 16 --atlas-uv chart -q -o ", scene);
  run("ptbake", bake + one + " --threads 1");
  run("ptbake", bake + two + " --threads 2");
  EXPECT_EQ(readFile(one), readFile(two));
}

TEST(Determinism, TruthGivesTheSameBytesFromOneThreadAndTwo) {
  const std::string scene = file("truth.glb"), light = file("truth-light.exr"), one = file("one.exr"),
                    two = file("two.exr");
  run("boxlight_data", "scene glossy_dielectric " + scene);
  run("boxlight_data", "environment sky " + light);
  const std::string render = fmt::format("render {} --env {} --size 32x32 --spp 8 -q -o ", scene, light);
  run("ptbake", render + one + " --threads 1");
  run("ptbake", render + two + " --threads 2");
  EXPECT_EQ(readFile(one), readFile(two));
}
