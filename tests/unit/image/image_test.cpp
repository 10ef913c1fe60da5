// SPDX-License-Identifier: Apache-2.0
#include "common/image/image.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numeric>
#include <thread>

#include "common/base/error.h"
#include "common/base/file.h"
#include "tests/unit/temporary_folder.h"

namespace boxlight {
namespace {

class ImageTest : public FolderTest {
 protected:
  ExitCode readCode(const std::string& name) {
    try {
      readImage(folder_ / name);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
      return error.code();
    }
    return ExitCode::ok;
  }
};

Image gradient(uint32_t width, uint32_t height, uint32_t channels) {
  Image image = makeImage(width, height, channels);
  for (size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = float(i) / float(image.pixels.size());
  return image;
}

TEST_F(ImageTest, ExrKeepsEveryBit) {
  for (uint32_t channels : {1u, 3u, 4u}) {
    Image image = gradient(5, 3, channels);
    image.pixels[0] = 1e9f;
    image.pixels[1] = -0.25f;
    image.pixels[2] = 1e-30f;
    writeImage(folder_ / "a.exr", image);
    const Image back = readImage(folder_ / "a.exr");
    EXPECT_EQ(back.width, 5u);
    EXPECT_EQ(back.height, 3u);
    EXPECT_EQ(back.channels, channels);
    EXPECT_EQ(back.pixels, image.pixels);
  }
}

/// One pixel whose channel i holds i + 1, as half floats.
void writeChannels(const std::filesystem::path& path, const std::vector<std::string>& names) {
  OIIO::ImageSpec spec(1, 1, int(names.size()), OIIO::TypeDesc::HALF);
  spec.channelnames = names;
  std::vector<float> values(names.size());
  std::iota(values.begin(), values.end(), 1.0f);
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output && output->open(path.string(), spec) &&
              output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close());
}

TEST_F(ImageTest, ChannelsGoByTheirNames) {
  const auto read = [&](const std::vector<std::string>& names) {
    writeChannels(folder_ / "named.exr", names);
    return readImage(folder_ / "named.exr").pixels;
  };
  using Pixel = std::vector<float>;
  EXPECT_EQ(read({"B", "G", "R"}), (Pixel{3, 2, 1}));
  EXPECT_EQ(read({"b", "g", "r"}), (Pixel{3, 2, 1}));
  EXPECT_EQ(read({"red", "green", "blue", "alpha"}), (Pixel{1, 2, 3, 4}));
  EXPECT_EQ(read({"Blue", "Green", "Red"}), (Pixel{3, 2, 1}));
  EXPECT_EQ(read({"Sky.Combined.R", "Sky.Combined.G", "Sky.Combined.B", "Sky.Combined.A", "Sky.Depth.Z"}),
            (Pixel{1, 2, 3, 4}));
  EXPECT_EQ(read({"a.R", "a.G", "a.B", "R", "G", "B"}).size(), 3u);
  EXPECT_EQ(read({"Y"}), (Pixel{1}));
  writeChannels(folder_ / "chroma.exr", {"BY", "RY", "Y"});
  EXPECT_EQ(readCode("chroma.exr"), ExitCode::invalidInput);
  writeChannels(folder_ / "many.exr", {"a", "b", "c", "d", "e"});
  EXPECT_EQ(readCode("many.exr"), ExitCode::invalidInput);
}

TEST_F(ImageTest, RowZeroIsTheTop) {
  Image image = makeImage(1, 2, 3);
  image.at(0, 0)[0] = 1.0f;
  writeImage(folder_ / "a.png", toDisplay(image));
  // The first scan line of a PNG is the top by definition; OpenImageIO hands it over first.
  EXPECT_EQ(readImage(folder_ / "a.png").at(0, 0)[0], 1.0f);
}

TEST_F(ImageTest, SamePixelsGiveSameBytes) {
  const Image image = gradient(33, 17, 4);
  for (const char* extension : {".exr", ".png"}) {
    writeImage(folder_ / (std::string("a") + extension), image);
    std::this_thread::sleep_for(
        std::chrono::milliseconds(1100));  // time stamps have a resolution of a second
    writeImage(folder_ / (std::string("b") + extension), image);
    EXPECT_EQ(readFile(folder_ / (std::string("a") + extension)),
              readFile(folder_ / (std::string("b") + extension)));
  }
}

TEST_F(ImageTest, PngGoesThroughTheCurveAndBack) {
  Image image = makeImage(64, 1, 4);
  for (uint32_t x = 0; x < 64; ++x)
    for (int c = 0; c < 4; ++c) image.at(x, 0)[c] = c == 3 ? 0.5f : 0.5f * float(x) / 63.0f;  // premultiplied
  writeImage(folder_ / "a.png", toDisplay(image));
  const Image back = readImage(folder_ / "a.png");
  ASSERT_EQ(back.channels, 4u);
  for (uint32_t x = 0; x < 64; ++x) {
    EXPECT_NEAR(back.at(x, 0)[3], 0.5f, 0.51f / 255.0f);
    EXPECT_NEAR(back.at(x, 0)[0], image.at(x, 0)[0], 0.006f) << x;
  }
}

TEST_F(ImageTest, DisplayClampsAndExposes) {
  Image image = makeImage(4, 1, 3);
  const float values[4] = {0.25f, 2.0f, -1.0f, NAN};
  for (uint32_t x = 0; x < 4; ++x) image.at(x, 0)[1] = values[x];
  const Image display = toDisplay(image, 1.0f);
  EXPECT_NEAR(display.at(0, 0)[1], 0.7353570f, 1e-6f);  // sRGB of .5
  EXPECT_EQ(display.at(1, 0)[1], 1.0f);
  EXPECT_EQ(display.at(2, 0)[1], 0.0f);
  EXPECT_EQ(display.at(3, 0)[1], 0.0f);
}

TEST_F(ImageTest, SrgbCurve) {
  EXPECT_NEAR(encodeSrgb(0.18f), 0.4613561f, 1e-6f);
  EXPECT_NEAR(encodeSrgb(0.001f), 0.01292f, 1e-7f);
  for (int i = 0; i <= 255; ++i)
    EXPECT_NEAR(encodeSrgb(decodeSrgb(float(i) / 255.0f)), float(i) / 255.0f, 1e-6f);
}

TEST_F(ImageTest, WrongFilesAreRefused) {
  EXPECT_EQ(readCode("missing.exr"), ExitCode::io);
  std::filesystem::create_directory(folder_ / "folder.exr");
  EXPECT_EQ(readCode("folder.exr"), ExitCode::io);
  std::ofstream(folder_ / "text.exr") << "not an image";
  EXPECT_EQ(readCode("text.exr"), ExitCode::invalidInput);
  std::ofstream(folder_ / "empty.png");
  EXPECT_EQ(readCode("empty.png"), ExitCode::invalidInput);
  std::ofstream(folder_ / "huge.hdr") << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60000 +X 60000\n";
  EXPECT_EQ(readCode("huge.hdr"), ExitCode::invalidInput);
}

TEST_F(ImageTest, TruncatedFilesAreRefused) {
  for (const char* name : {"a.exr", "a.png"}) {
    writeImage(folder_ / name, gradient(64, 64, 3));
    const auto size = std::filesystem::file_size(folder_ / name);
    for (const auto kept : {size / 2, size / 4, uintmax_t(40), uintmax_t(9)}) {
      std::filesystem::resize_file(folder_ / name, kept);
      EXPECT_EQ(readCode(name), ExitCode::invalidInput) << name << " " << kept;
    }
  }
}

TEST_F(ImageTest, UnwritablePicturesAreRefused) {
  auto code = [](const std::filesystem::path& path) {
    try {
      writeImage(path, makeImage(1, 1, 3));
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::ok;
  };
  EXPECT_EQ(code(folder_ / "a.jpg"), ExitCode::usage);
  EXPECT_EQ(code(folder_ / "a"), ExitCode::usage);
  EXPECT_EQ(code(folder_ / "no" / "folder" / "a.exr"), ExitCode::io);
  EXPECT_EQ(
      std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()), 0);
}

}  // namespace
}  // namespace boxlight
