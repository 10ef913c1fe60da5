// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "common/image/image.h"

namespace boxlight::test {

/// Both ways to a picture. The truth is held to .5 %, bake and relight to 1.5 %.
enum class Way { truth, baked };
double tolerance(Way way);
const char* name(Way way);

/// A scene and an environment of boxlight_data, made once per process in a temporary folder.
struct Shot {
  std::string scene;  ///< with its settings: "plane --set albedo=.5"
  std::string environment;
  std::string camera;  ///< options of both programs
  std::string bakeOptions = "--atlas 16 --paths 1024 --boxes 16";
  std::string renderOptions = "--spp 256";
};

/// Runs one of the built programs; throws if it does not end with 0.
void run(const std::string& program, const std::string& arguments);
/// A path in this process's temporary folder, which is removed at its end.
std::string file(const std::string& name);

/// Runs the programs as a user would and reads the picture they write, background off. Throws if a program
/// fails.
Image picture(Way way, const Shot& shot);

/// Mean radiance over the object's pixels, by coverage; at(x, y) for one pixel, straight.
Rgb objectMean(const Image& image);
Rgb objectAt(const Image& image, uint32_t x, uint32_t y);

}  // namespace boxlight::test
