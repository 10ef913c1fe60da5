// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/cmd_compare.h"

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/image/image_metrics.h"

namespace boxlight {
namespace {

struct CompareOptions {
  std::string image, reference, difference;
  std::optional<double> limit;
};

const char* measuredPixels(const ImageMetrics& m) {
  return m.byAlpha ? "object pixels: alpha above .5 in the reference"
                   : "all pixels: the reference has no alpha";
}

void printText(const ImageMetrics& m) {
  fmt::print("pixels        {} of {} ({})\n", m.pixels, m.allPixels, measuredPixels(m));
  fmt::print("RMSE          {:.6g}\n", m.rmse);
  fmt::print("trimmed RMSE  {:.6g} (without the worst .1 % of the pixels)\n", m.trimmedRmse);
  fmt::print("relMSE        {:.6g}\n", m.relMse);
  fmt::print("PSNR          {:.2f} dB\n", m.psnr);
  fmt::print("8-bit RMSE    {:.4g} steps (clamped, sRGB)\n", m.rmse8);
  fmt::print("mean FLIP     {:.4f} (perceived difference at 67 pixels a degree, 0 to 1)\n", m.flip);
  if (m.byAlpha) fmt::print("alpha RMSE    {:.4g} (coverage, all pixels)\n", m.alphaRmse);
  fmt::print("mean          {:.6g}, reference {:.6g}, bias {:+.4g} %\n", m.mean, m.referenceMean,
             100.0 * m.bias);
}

/// JSON has no infinity: PSNR of equal pictures is null.
nlohmann::ordered_json finite(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
}

void printJson(const CompareOptions& options, const ImageMetrics& m) {
  const nlohmann::ordered_json json = {{"image", options.image},
                                       {"reference", options.reference},
                                       {"measured", measuredPixels(m)},
                                       {"pixels", m.pixels},
                                       {"all_pixels", m.allPixels},
                                       {"rmse", m.rmse},
                                       {"trimmed_rmse", m.trimmedRmse},
                                       {"rel_mse", m.relMse},
                                       {"psnr_db", finite(m.psnr)},
                                       {"rmse_8bit", m.rmse8},
                                       {"flip", m.flip},
                                       {"alpha_rmse", finite(m.alphaRmse)},
                                       {"mean", m.mean},
                                       {"reference_mean", m.referenceMean},
                                       {"bias", finite(m.bias)}};
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void compare(const CompareOptions& options, const CommonOptions& common) {
  if (!options.difference.empty() && std::filesystem::path(options.difference).extension() != ".png")
    fail(ExitCode::usage, "--diff {}: the difference picture is written as .png", options.difference);
  const Image image = readImage(options.image), reference = readImage(options.reference);
  const ImageMetrics metrics = compareImages(image, reference);
  common.json ? printJson(options, metrics) : printText(metrics);
  if (!options.difference.empty()) writeImage(options.difference, falseColourDifference(image, reference));
  if (options.limit && metrics.rmse > *options.limit)
    fail(ExitCode::difference, "{}: RMSE {:.6g} against {} is above {:.6g}", options.image, metrics.rmse,
         options.reference, *options.limit);
}

}  // namespace

void addCompareCommand(CLI::App& app, CommonOptions& common) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Measure a picture against its reference");
  addCommonOptions(*command, common);
  command->add_option("image", options->image, "Picture, linear or sRGB-encoded")
      ->required()
      ->option_text("IMAGE");
  command->add_option("reference", options->reference, "What it should be; its alpha chooses the pixels")
      ->required()
      ->option_text("REFERENCE");
  command->add_option("--diff", options->difference, "False-colour picture: white is 63 8-bit steps or more")
      ->option_text("FILE.png");
  command->add_option("--fail", options->limit, "Exit 7 if the RMSE is above this")
      ->check(inRange(0.0, 1e30))
      ->option_text("E");
  command->callback([options, &common] { compare(*options, common); });
}

}  // namespace boxlight
