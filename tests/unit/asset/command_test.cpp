// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <nlohmann/json.hpp>

#include "bake/commands/cmd_inspect.h"
#include "bake/commands/cmd_validate.h"
#include "common/asset/asset_reader.h"
#include "common/base/error.h"
#include "common/base/file.h"
#include "tests/format/sample_asset.h"
#include "tests/unit/asset/surgeon.h"

namespace boxlight {
namespace {

struct Outcome {
  ExitCode code = ExitCode::ok;
  std::string output;
};

Outcome run(const std::string& arguments) {
  CLI::App app("test");
  CommonOptions common;
  addInspectCommand(app, common);
  addValidateCommand(app, common);
  Outcome result;
  ::testing::internal::CaptureStdout();
  try {
    app.parse(arguments);
  } catch (const Error& error) {
    result.code = error.code();
  }
  result.output = ::testing::internal::GetCapturedStdout();
  return result;
}

class Command : public ::testing::Test {
 protected:
  Command() { asset::makeSample({.records = 70, .recordsPerTile = 64}).write(file.path); }
  void damage() const {
    asset::Surgeon surgeon(readFile(file.path));
    surgeon.edit<asset::Triangle>(asset::chunk::kTriangles, 0, [](asset::Triangle& t) { t.material = 9; });
    for (size_t i = 0; i < 70; ++i)
      surgeon.edit<asset::TexelRecord>(asset::chunk::kRecords, i,
                                       [](asset::TexelRecord& r) { r.material = 9; });
    surgeon.write(file.path);
  }
  const asset::TemporaryFile file;
};

TEST_F(Command, inspectAccountsForEveryByte) {
  const Outcome result = run("inspect " + file.path.string() + " --json");
  EXPECT_EQ(result.code, ExitCode::ok);
  const auto summary = nlohmann::json::parse(result.output);
  const auto& bytes = summary["bytes"];
  uint64_t sum = bytes["head"].get<uint64_t>() + bytes["padding"].get<uint64_t>(), pages = 0;
  for (const auto& entry : bytes["chunks"]) {
    sum += entry["stored"].get<uint64_t>();
    if (entry["type"] == "PAGE") pages = entry["stored"];
  }
  EXPECT_EQ(sum, std::filesystem::file_size(file.path));
  EXPECT_EQ(pages,
            bytes["glossyPages"]["stored"].get<uint64_t>() + bytes["diffusePages"]["stored"].get<uint64_t>());
  EXPECT_EQ(bytes["cellPages"]["pages"], 0);
  EXPECT_EQ(summary["version"], "1.6");
  EXPECT_EQ(summary["counts"]["records"], 70);
  EXPECT_EQ(bytes["diffusePages"]["kernels"], 70);
  EXPECT_EQ(bytes["diffusePages"]["boxes"], 280);
}

TEST_F(Command, inspectNamesTermsAndEmission) {
  const auto summary = nlohmann::json::parse(run("inspect " + file.path.string() + " --json").output);
  const auto& terms = summary["materialTerms"];
  EXPECT_EQ(terms["KHR_materials_unlit"], 1);
  EXPECT_EQ(terms["KHR_materials_specular"], 1);
  EXPECT_EQ(terms.size(), 15u) << "all but MASK: " << terms;
  const auto& bytes = summary["bytes"];
  // Tile 0 has 64 records and emits in its Lambert kernels, tile 1 has 6 and emits in its glossy ones.
  EXPECT_EQ(bytes["diffusePages"]["emittedKernels"], 64);
  uint64_t glossy = 0;
  const asset::Sample sample = asset::makeSample({.records = 70, .recordsPerTile = 64});
  for (uint32_t view = 0; view < 12; ++view) glossy += uint64_t(std::popcount(sample.asset.mask(view, 1)));
  EXPECT_EQ(bytes["glossyPages"]["emittedKernels"], glossy);
  EXPECT_GT(glossy, 0u);
  const std::string text = run("inspect " + file.path.string()).output;
  EXPECT_NE(text.find("1 material with KHR_materials_clearcoat"), std::string::npos) << text;
  EXPECT_NE(text.find("in 64 kernels of the diffusePages"), std::string::npos) << text;
  asset::makeSample({.extensions = false}).write(file.path);
  const auto plain = nlohmann::json::parse(run("inspect " + file.path.string() + " --json").output);
  EXPECT_EQ(plain["bytes"]["diffusePages"]["emittedKernels"], 0);
  EXPECT_EQ(plain["materialTerms"].size(), 2u) << "MASK and specular: " << plain["materialTerms"];
}

TEST_F(Command, inspectNamesTheSchemeAndCountsVisibilityMaps) {
  const auto sketch = nlohmann::json::parse(run("inspect " + file.path.string() + " --json").output);
  EXPECT_EQ(sketch["scheme"], "sketch");
  EXPECT_EQ(sketch["visibilityMaps"], nlohmann::json({{"count", 0}, {"stored", 0}, {"raw", 0}}));
  EXPECT_EQ(run("inspect " + file.path.string()).output.find("visibility"), std::string::npos);
  asset::makeSample({.split = true}).write(file.path);
  const auto split = nlohmann::json::parse(run("inspect " + file.path.string() + " --json").output);
  EXPECT_EQ(split["scheme"], "split");
  const auto& maps = split["visibilityMaps"];
  EXPECT_EQ(maps["count"], 3);
  EXPECT_EQ(maps["raw"], 3 * 1024);
  uint64_t stored = 0;
  for (const auto& entry : split["bytes"]["chunks"])
    if (entry["type"] == "VISI") stored = entry["stored"];
  EXPECT_GT(stored, 0u);
  EXPECT_EQ(maps["stored"], stored);
  const std::string text = run("inspect " + file.path.string()).output;
  EXPECT_NE(text.find("1.6, scheme split"), std::string::npos) << text;
  EXPECT_NE(text.find(fmt::format("3 maps of split records, {} bytes of 3072", stored)), std::string::npos)
      << text;
}

/// A reader skips chunks that it does not know, whatever their codec.
TEST_F(Command, inspectNamesCodecsThatItDoesNotKnow) {
  for (const uint32_t codec : {4u, 9u, 0xFFFFFFFFu}) {
    asset::makeSample().write(file.path);
    asset::Surgeon surgeon(readFile(file.path));
    surgeon.addChunk(asset::fourCc("visp"), asset::Bytes(9));
    surgeon.table.back().codec = asset::Codec(codec);
    surgeon.write(file.path);
    const std::string text = run("inspect " + file.path.string()).output;
    EXPECT_NE(text.find(fmt::format("codec {}", codec)), std::string::npos) << text;
    EXPECT_EQ(run("inspect " + file.path.string() + " --json").code, ExitCode::ok);
  }
}

TEST_F(Command, inspectCountsCells) {
  const auto sketch = nlohmann::json::parse(run("inspect " + file.path.string() + " --json").output);
  EXPECT_EQ(sketch["cells"], nlohmann::json({{"frequency", 0}, {"count", 0}, {"records", 0}}));
  EXPECT_EQ(run("inspect " + file.path.string()).output.find("cells"), std::string::npos);
  const asset::Sample sample =
      asset::makeSample({.records = 70, .recordsPerTile = 64, .split = true, .cells = true});
  sample.write(file.path);
  const auto summary = nlohmann::json::parse(run("inspect " + file.path.string() + " --json").output);
  EXPECT_EQ(summary["scheme"], "cells");
  EXPECT_EQ(summary["cells"], nlohmann::json({{"frequency", 2}, {"count", 42}, {"records", 24}}));
  uint64_t kernels = 0, emitted = 0, stored = 0, pages = 0;
  for (uint32_t stream = 13; stream < 55; ++stream) {
    emitted += uint64_t(std::popcount(sample.asset.mask(stream, 1)));
    for (uint32_t tile = 0; tile < 2; ++tile)
      kernels += uint64_t(std::popcount(sample.asset.mask(stream, tile)));
  }
  const auto& bytes = summary["bytes"];
  EXPECT_EQ(bytes["cellPages"]["kernels"], kernels);
  EXPECT_EQ(bytes["cellPages"]["emittedKernels"], emitted);
  EXPECT_GT(emitted, 0u);
  for (const char* kind : {"glossyPages", "diffusePages", "cellPages"})
    pages += bytes[kind]["stored"].get<uint64_t>();
  for (const auto& entry : bytes["chunks"])
    if (entry["type"] == "PAGE") stored = entry["stored"];
  EXPECT_EQ(pages, stored);
  EXPECT_EQ(bytes["diffusePages"]["emittedKernels"], 64);
  const std::string text = run("inspect " + file.path.string()).output;
  for (const char* part :
       {"1.6, scheme cells", "42 (frequency 2), of 24 records", " kernels of the cellPages"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST_F(Command, inspectCountsCoarseViewsAndLevels) {
  const auto inspected = [&] {
    return nlohmann::json::parse(run("inspect " + file.path.string() + " --json").output);
  };
  EXPECT_TRUE(inspected()["coarseViews"].empty());
  EXPECT_EQ(inspected()["atlas"]["recordsOfLevels"], nlohmann::json({70}));
  asset::makeSample({.viewFrequency = 3, .records = 9, .split = true, .coarse = true}).write(file.path);
  EXPECT_EQ(inspected()["coarseViews"], nlohmann::json({{{"frequency", 2}, {"count", 42}, {"records", 3}},
                                                        {{"frequency", 1}, {"count", 12}, {"records", 3}}}));
  EXPECT_EQ(inspected()["atlas"]["recordsOfLevels"], nlohmann::json({7, 2}));
  const std::string text = run("inspect " + file.path.string()).output;
  for (const char* part :
       {"42 (frequency 2), of 3 records", "12 (frequency 1), of 3 records", "2, of [7,2] records"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST_F(Command, inspectPrintsText) {
  const Outcome result = run("inspect " + file.path.string());
  for (const char* part :
       {"1.6, scheme sketch", "sample 1.0", "PAGE", "glossy", "diffuse", "12 (frequency 1)"})
    EXPECT_NE(result.output.find(part), std::string::npos) << part << "\n" << result.output;
}

TEST_F(Command, validateOfAValidAsset) {
  const Outcome json = run("validate --json " + file.path.string());
  EXPECT_EQ(json.code, ExitCode::ok);
  EXPECT_EQ(nlohmann::json::parse(json.output)["valid"], true);
  const Outcome text = run("validate " + file.path.string());
  EXPECT_EQ(text.code, ExitCode::ok);
  EXPECT_NE(text.output.find("valid, 0 errors"), std::string::npos) << text.output;
}

TEST_F(Command, validateOfADamagedAsset) {
  damage();
  const Outcome json = run("validate --json " + file.path.string());
  EXPECT_EQ(json.code, ExitCode::invalidInput);
  const auto result = nlohmann::json::parse(json.output);
  EXPECT_EQ(result["valid"], false);
  EXPECT_EQ(result["errors"], 71);
  EXPECT_EQ(result["notShown"], 60);
  EXPECT_EQ(result["findings"].size(), 11u);
  EXPECT_EQ(result["findings"][0]["number"], 1);
  EXPECT_EQ(result["findings"][0]["code"], 309);
  EXPECT_EQ(result["findings"][0]["chunk"], "TRIS");
  const Outcome text = run("validate " + file.path.string());
  EXPECT_EQ(text.code, ExitCode::invalidInput);
  EXPECT_NE(text.output.find("and 60 more of 314"), std::string::npos) << text.output;
  EXPECT_EQ(run("inspect " + file.path.string()).code, ExitCode::invalidInput);
}

TEST_F(Command, aMissingFileIsAnIoError) {
  EXPECT_EQ(run("inspect /nonexistent.ptb").code, ExitCode::io);
  EXPECT_EQ(run("validate /nonexistent.ptb").code, ExitCode::io);
}

}  // namespace
}  // namespace boxlight
