// SPDX-License-Identifier: Apache-2.0
// The shipped program: exit codes, messages, outputs.
#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/runtime/synthetic.h"
#include "tests/support/temporary_path.h"

namespace boxlight {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class CommandLineTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    Square square;
    square.glossyBoxes = 2;
    square.write(asset_, [](uint32_t, uint32_t, uint32_t) { return Box{0.1f, 0.1f, 0.5f, 0.5f, Rgb(1)}; });
    writeImage(light_, axesEnvironment({64, 32}));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// The exit code; what was printed is in out_ and err_.
  int run(const std::string& arguments) {
    const auto out = folder_ / "out", err = folder_ / "err";
    const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY " + std::string(PTVIEW) + " " + arguments +
                                " >" + out.string() + " 2>" + err.string();
    const int status = std::system(command.c_str());
    out_ = contents(out);
    err_ = contents(err);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string usual(const std::string& output) const {
    return asset_.string() + " --headless --env " + light_.string() + " --size 40x30 --validation -o " +
           (folder_ / output).string() + " ";
  }

  std::filesystem::path folder_ = test::temporaryPath("ptview");
  std::filesystem::path asset_ = folder_ / "square.ptb", light_ = folder_ / "axes.exr";
  std::string out_, err_;
};

TEST_F(CommandLineTest, WritesPictureAndStats) {
  const auto stats = folder_ / "stats.json";
  ASSERT_EQ(
      run(usual("picture.exr") + "--frames 3 --boxes 1 --interpolation weight --stats " + stats.string()), 0)
      << err_;
  EXPECT_EQ(out_, "");
  const Image picture = readImage(folder_ / "picture.exr");
  EXPECT_EQ(picture.width, 40u);
  EXPECT_EQ(picture.height, 30u);
  EXPECT_EQ(picture.channels, 4u);
  const auto json = nlohmann::json::parse(contents(stats));
  EXPECT_EQ(json["visible_texels"], 64);
  EXPECT_EQ(json["boxes_evaluated"], 128);
  EXPECT_GT(json["pages"], 1);
  EXPECT_EQ(json["frames"], 3);
  EXPECT_EQ(json["gpu"]["passes"].size(), 6u);
}

TEST_F(CommandLineTest, LayersAreCountedAndTheirLimitIsHeard) {
  Square square;
  square.material.baseColor[3] = 0.5f;
  square.material.flags = asset::kAlphaBlend;
  square.extensions.resize(1);
  asset::Asset asset = square.makeAsset();
  asset.triangles.insert(asset.triangles.end(), asset.triangles.begin(), asset.triangles.begin() + 2);
  writeSynthetic(asset_, asset, [](uint32_t, uint32_t, uint32_t) { return packBox({0, 0, 1, 1, Rgb(1)}); });
  const auto stats = folder_ / "stats.json";
  ASSERT_EQ(run(usual("picture.exr") + "--stats " + stats.string()), 0) << err_;
  EXPECT_EQ(nlohmann::json::parse(contents(stats))["layers"], 2);
  EXPECT_EQ(nlohmann::json::parse(contents(stats))["samples_with_cut_layers"], 0);
  ASSERT_EQ(run(usual("picture.exr") + "--layers 1 --stats " + stats.string()), 0) << err_;
  EXPECT_EQ(nlohmann::json::parse(contents(stats))["layers"], 1);
  EXPECT_GT(nlohmann::json::parse(contents(stats))["samples_with_cut_layers"], 0);
  EXPECT_NE(err_.find("--layers"), std::string::npos);
  EXPECT_EQ(run(usual("picture.exr") + "--layers 0"), 1);
}

TEST_F(CommandLineTest, ASequenceOfEnvironmentsIsASequenceOfPictures) {
  for (const int frame : {9, 10, 11})
    writeImage(folder_ / fmt::format("sky.{:03}.exr", frame),
               constantEnvironment({16, 8}, Rgb(float(frame))));
  const std::string start =
      asset_.string() + " --headless --size 8x8 --fov 10 --eye 0,3,0.01 --validation --env " +
      (folder_ / "sky.###.exr").string() + " --first-frame 9 -o " + (folder_ / "out_%02d.exr").string();
  ASSERT_EQ(run(start + " --frames 3"), 0) << err_;
  for (const int frame : {9, 10, 11})
    EXPECT_NEAR(readImage(folder_ / fmt::format("out_{:02}.exr", frame)).at(4, 4)[0], frame, 1e-4 * frame);
  EXPECT_EQ(run(start + " --frames 4"), 2) << "there is no fourth";
  EXPECT_NE(err_.find("sky.012.exr"), std::string::npos) << err_;
  EXPECT_EQ(run(asset_.string() + " --headless --env " + (folder_ / "sky.###.exr").string() +
                " --frames 2 -o " + (folder_ / "one.exr").string()),
            1);
  EXPECT_NE(err_.find("number the pictures"), std::string::npos) << err_;
}

TEST_F(CommandLineTest, IntensityAndTheTableHaveOptions) {
  ASSERT_EQ(run(usual("a.exr")), 0) << err_;
  ASSERT_EQ(run(usual("b.exr") + "--env-intensity 4 --sat exact"), 0) << err_;
  const Image a = readImage(folder_ / "a.exr"), b = readImage(folder_ / "b.exr");
  for (size_t i = 0; i < a.pixels.size(); ++i)
    if (i % 4 != 3) {
      ASSERT_NEAR(b.pixels[i], 4 * a.pixels[i], 1e-4f);
    }
  EXPECT_EQ(run(usual("c.exr") + "--env-intensity -1"), 1);
  EXPECT_EQ(run(usual("c.exr") + "--sat big"), 1);
  EXPECT_EQ(run(usual("c.exr") + "--sat-size 16384x8192"), 4);
  EXPECT_NE(err_.find("holds"), std::string::npos) << err_;
}

TEST_F(CommandLineTest, SameSettingsSameBytes) {
  ASSERT_EQ(run(usual("a.exr") + "-t 1"), 0) << err_;
  ASSERT_EQ(run(usual("b.exr") + "-t 2"), 0) << err_;
  EXPECT_EQ(contents(folder_ / "a.exr"), contents(folder_ / "b.exr"));
}

TEST_F(CommandLineTest, ABackgroundMakesAPngOpaque) {
  ASSERT_EQ(run(usual("a.png")), 0) << err_;
  ASSERT_EQ(run(usual("b.png") + "--background off"), 0) << err_;
  EXPECT_EQ(alphaAt(readImage(folder_ / "a.png"), 0, 0), 1.0f);
  EXPECT_EQ(alphaAt(readImage(folder_ / "b.png"), 0, 0), 0.0f);
}

TEST_F(CommandLineTest, UsageErrors) {
  EXPECT_EQ(run(""), 1);
  EXPECT_EQ(run(asset_.string() + " -o picture.exr"), 1);  // without --headless
  EXPECT_NE(err_.find("--headless"), std::string::npos);
  EXPECT_EQ(run(asset_.string() + " --headless"), 1);
  EXPECT_EQ(run(usual("picture.jpg")), 1);
  EXPECT_EQ(run(usual("picture.exr") + "--interpolation cubic"), 1);
  EXPECT_EQ(run(usual("picture.exr") + "--size 0x7"), 1);
  EXPECT_EQ(run(usual("picture.exr") + "--nonsense"), 1);
  EXPECT_EQ(run(usual("picture.png") + "--tone-map filmic"), 1);
}

TEST_F(CommandLineTest, WithoutADisplayThereIsNoWindow) {
  EXPECT_EQ(run(asset_.string()), 4);
  EXPECT_NE(err_.find("--headless"), std::string::npos);
}

TEST_F(CommandLineTest, ToneMapsAreOfThePng) {
  ASSERT_EQ(run(usual("linear.exr")), 0) << err_;
  ASSERT_EQ(run(usual("mapped.exr") + "--tone-map aces --exposure 1"), 0) << err_;
  EXPECT_EQ(contents(folder_ / "mapped.exr"), contents(folder_ / "linear.exr"));
  const Image linear = readImage(folder_ / "linear.exr");
  for (unsigned map = 0; map < kToneMapNames.size(); ++map) {
    ASSERT_EQ(run(usual("mapped.png") + "--exposure 1 --tone-map " + kToneMapNames[map]), 0) << err_;
    writeImage(folder_ / "expected.png", toDisplay(linear, 1, ToneMap(map)));
    EXPECT_EQ(contents(folder_ / "mapped.png"), contents(folder_ / "expected.png")) << kToneMapNames[map];
  }
}

TEST_F(CommandLineTest, ASettingsFileStandsForOptions) {
  ASSERT_EQ(run(usual("a.png") +
                "--eye 1,2,1 --fov 50 --env-rotation 30 --exposure -1 --tone-map neutral --boxes 1"),
            0)
      << err_;
  const auto settings = folder_ / "settings.json";
  std::ofstream(settings) << R"({"asset": "square.ptb", "environment": "axes.exr", "tone_map": "neutral",
    "camera": {"eye": [1, 2, 1], "fov": 50, "size": [40, 30]}, "env_rotation": 30, "exposure": 5, "boxes": 1})";
  // The option counts, wherever it stands.
  const std::string with = "--settings " + settings.string(),
                    output = " --headless -o " + (folder_ / "b.png").string();
  for (const std::string& line : {with + " --exposure -1" + output, "--exposure -1 " + with + output}) {
    ASSERT_EQ(run(line), 0) << err_;
    EXPECT_EQ(contents(folder_ / "a.png"), contents(folder_ / "b.png"));
  }
  std::ofstream(settings) << R"({"exposure": "bright"})";
  EXPECT_EQ(run(with + output), 3);
  EXPECT_NE(err_.find("exposure"), std::string::npos);
  EXPECT_EQ(run("--settings nothing.json" + output), 2);
}

TEST_F(CommandLineTest, ListsKeys) {
  ASSERT_EQ(run("--list-keys"), 0);
  EXPECT_EQ(out_.substr(0, 8), "| keys |");
}

TEST_F(CommandLineTest, InputErrors) {
  EXPECT_EQ(run("nothing.ptb --headless --env " + light_.string() + " -o x.exr"), 2);
  EXPECT_NE(err_.find("nothing.ptb"), std::string::npos);
  EXPECT_EQ(run(asset_.string() + " --headless --env nothing.exr -o x.exr"), 2);
  std::filesystem::resize_file(asset_, std::filesystem::file_size(asset_) / 2);
  EXPECT_EQ(run(usual("picture.exr")), 3);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "picture.exr"));
}

// One flipped byte in each page in turn, most of which this camera never needs.
TEST_F(CommandLineTest, ADamagedPageIsFoundWhereverItIs) {
  const std::string sound = contents(asset_);
  std::vector<uint64_t> places;
  {
    const asset::AssetReader reader(asset_);
    uint64_t pages = 0;
    for (const asset::ChunkEntry& chunk : reader.chunks())
      if (chunk.type == asset::chunk::kPages) pages = chunk.offset;
    for (uint32_t stream = 0; stream < reader.asset().streamCount(); stream += 7)
      if (const asset::PageEntry& page = reader.pageEntry(stream, 0); page.storedSize > 0)
        places.push_back(pages + page.offset + page.storedSize / 2);
  }
  ASSERT_GT(places.size(), 3u);
  for (uint64_t place : places) {
    std::string damaged = sound;
    damaged[place] = char(damaged[place] ^ 0x10);
    std::ofstream(asset_, std::ios::binary) << damaged;
    EXPECT_EQ(run(usual("picture.exr")), 3) << "at byte " << place;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "picture.exr"));
  }
}

TEST_F(CommandLineTest, DeviceErrors) {
  EXPECT_EQ(run(usual("picture.exr") + "--device no-such-gpu"), 4);
  EXPECT_NE(err_.find("no-such-gpu"), std::string::npos);
  EXPECT_EQ(run(usual("picture.exr") + "--device 99"), 4);
}

TEST_F(CommandLineTest, ListsDevices) {
  ASSERT_EQ(run("--list-devices"), 0);
  EXPECT_EQ(out_.substr(0, 3), "0: ");
  ASSERT_EQ(run("--list-devices --json"), 0);
  EXPECT_GE(nlohmann::json::parse(out_).size(), 1u);
}

}  // namespace
}  // namespace boxlight
