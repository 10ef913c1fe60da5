// SPDX-License-Identifier: Apache-2.0
#include "bake/commands/cmd_validate.h"

#include <memory>
#include <nlohmann/json.hpp>

#include "common/asset/asset_validate.h"

namespace boxlight {
namespace {

using asset::Finding;
using asset::Severity;
using asset::Validation;
using Json = nlohmann::ordered_json;

uint64_t notShown(const Validation& validation) {
  uint64_t found = 0;
  for (const auto& [code, count] : validation.count) found += count;
  return found - validation.findings.size();
}

Json toJson(const std::string& path, const Validation& validation) {
  Json list = Json::array();
  for (const Finding& finding : validation.findings)
    list.push_back({{"number", list.size() + 1},
                    {"code", int(finding.kind->code)},
                    {"severity", severityName(finding.kind->severity)},
                    {"title", finding.kind->title},
                    {"chunk", finding.chunk},
                    {"place", finding.place},
                    {"what", finding.what},
                    {"remedy", finding.kind->remedy}});
  return {{"file", path},
          {"valid", validation.exitCode() == ExitCode::ok},
          {"errors", validation.total(Severity::error)},
          {"warnings", validation.total(Severity::warning)},
          {"notes", validation.total(Severity::note)},
          {"notShown", notShown(validation)},
          {"findings", list}};
}

void printText(const std::string& path, const Validation& validation) {
  size_t number = 0;
  for (const Finding& finding : validation.findings)
    fmt::print("{:3}. {} {}: {}\n       {}: {}\n", ++number, severityName(finding.kind->severity),
               int(finding.kind->code), finding.kind->title, path, finding.message());
  for (const auto& [code, count] : validation.count)
    if (count > asset::kShownPerCode)
      fmt::print("     and {} more of {}\n", count - asset::kShownPerCode, int(code));
  fmt::print("{}: {}, {} errors, {} warnings, {} notes\n", path,
             validation.exitCode() == ExitCode::ok ? "valid" : "not valid", validation.total(Severity::error),
             validation.total(Severity::warning), validation.total(Severity::note));
}

void validate(const std::string& path, bool json) {
  const Validation validation = asset::validateAsset(path);
  if (json)
    fmt::print("{}\n", toJson(path, validation).dump(2, ' ', false, Json::error_handler_t::replace));
  else
    printText(path, validation);
  if (const ExitCode code = validation.exitCode(); code != ExitCode::ok)
    fail(code, "{}: not valid, {} errors found", path, validation.total(Severity::error));
}

}  // namespace

void addValidateCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command =
      app.add_subcommand("validate", "Check an asset and list everything that is wrong with it");
  addCommonOptions(*command, common);
  const auto path = std::make_shared<std::string>();
  command->add_option("ASSET", *path, "The .ptb file")->required();
  command->callback([path, &common] { validate(*path, common.json); });
}

}  // namespace boxlight
