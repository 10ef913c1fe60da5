// SPDX-License-Identifier: Apache-2.0
#include "common/base/cli.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>
#include <thread>

#include "common/base/error.h"
#include "common/base/log.h"

namespace boxlight {
namespace {

/// "1,2,3" with separator ',' into values[0..2]: exactly `values.size()` numbers and nothing else.
template <class T, size_t N>
bool parseList(std::string_view text, char separator, std::array<T, N>& values) {
  const char* at = text.data();
  const char* const end = at + text.size();
  for (size_t i = 0; i < N; ++i) {
    if (i > 0 && (at == end || *at++ != separator)) return false;
    const auto [next, error] = std::from_chars(at, end, values[i]);
    if (error != std::errc()) return false;
    at = next;
  }
  return at == end;
}

vec3 parseVec3(const std::string& name, const std::string& text) {
  std::array<float, 3> v;
  if (!parseList(text, ',', v)) throw CLI::ValidationError(name, "expected x,y,z, got '" + text + "'");
  for (float component : v)
    if (!std::isfinite(component)) throw CLI::ValidationError(name, "must be finite, got '" + text + "'");
  return {v[0], v[1], v[2]};
}

template <class Target>
CLI::Option* addVec3To(CLI::App& command, const std::string& name, Target& value, const std::string& help) {
  auto parse = [&value, name](const std::string& text) { value = parseVec3(name, text); };
  return command.add_option_function<std::string>(name, parse, help)->option_text("X,Y,Z");
}

template <class Target>
CLI::Option* addSizeTo(CLI::App& command, const std::string& name, Target& value, const std::string& help) {
  auto parse = [&value, name](const std::string& text) {
    std::array<uint32_t, 2> v;
    if (!parseList(text, 'x', v) || v[0] < 1 || v[1] < 1 || v[0] > 16384 || v[1] > 16384)
      throw CLI::ValidationError(name, "expected WxH, each 1 to 16384, got '" + text + "'");
    value = uvec2(v[0], v[1]);
  };
  return command.add_option_function<std::string>(name, parse, help)->option_text("WxH");
}

}  // namespace

void addCommonOptions(CLI::App& command, CommonOptions& options) {
  if (const CLI::App* program = command.get_parent())
    command.set_version_flag("--version", fmt::format("{} {}", program->get_name(), BOXLIGHT_VERSION));
  static const std::map<std::string, ProgressStyle> styles = {{"auto", ProgressStyle::automatic},
                                                              {"bar", ProgressStyle::bar},
                                                              {"lines", ProgressStyle::lines},
                                                              {"json", ProgressStyle::json},
                                                              {"none", ProgressStyle::none}};
  command.add_option("-t,--threads", options.threads, "Threads to use; 0 = all")->check(inRange(0, 1024));
  auto* quiet = command.add_flag("-q,--quiet", options.quiet, "Only errors on stderr");
  command.add_flag("-v,--verbose", options.verbose, "Details on stderr")->excludes(quiet);
  command.add_option("--progress", options.progress, "auto, bar, lines, json or none")
      ->transform(CLI::CheckedTransformer(styles))
      ->option_text("STYLE");
  command.add_flag("--json", options.json, "Print the result as JSON on stdout");
}

CLI::Option* addVec3(CLI::App& command, const std::string& name, vec3& value, const std::string& help) {
  return addVec3To(command, name, value, help);
}

CLI::Option* addVec3(CLI::App& command, const std::string& name, std::optional<vec3>& value,
                     const std::string& help) {
  return addVec3To(command, name, value, help);
}

CLI::Option* addSize(CLI::App& command, const std::string& name, uvec2& value, const std::string& help) {
  return addSizeTo(command, name, value, help);
}

CLI::Option* addSize(CLI::App& command, const std::string& name, std::optional<uvec2>& value,
                     const std::string& help) {
  return addSizeTo(command, name, value, help);
}

CLI::Option* addOnOff(CLI::App& command, const std::string& name, bool& value, const std::string& help) {
  auto parse = [&value](const std::string& text) { value = text == "on"; };
  return command.add_option_function<std::string>(name, parse, help)
      ->check(CLI::IsMember({"on", "off"}))
      ->option_text("on|off");
}

CLI::Validator inRange(double low, double high) {
  const std::string range = fmt::format("{} to {}", low, high);
  auto check = [=](const std::string& text) {
    double value = 0;
    const bool isNumber = CLI::detail::lexical_cast(text, value);
    return isNumber && value >= low && value <= high ? std::string()
                                                     : "expected " + range + ", got '" + text + "'";
  };
  return CLI::Validator(check, range);
}

int resolveThreads(int threads) {
  return threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency()));
}

int runMain(CLI::App& app, int argc, char** argv, const CommonOptions& options,
            const std::function<void()>& run) {
  const char* program = app.get_name().c_str();
  startLog(program, 0);
  app.set_version_flag("--version", fmt::format("{} {}", app.get_name(), BOXLIGHT_VERSION));
  // Runs before the callbacks of subcommands, so their messages obey -q and -v.
  app.parse_complete_callback([&] { startLog(program, options.quiet ? -1 : options.verbose ? 1 : 0); });
  try {
    app.parse(argc, argv);
    run();
    if (std::fflush(stdout) != 0) fail(ExitCode::io, "cannot write to stdout");
    return int(ExitCode::ok);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? int(ExitCode::ok) : int(ExitCode::usage);
  } catch (const Error& error) {
    log().error("{}", error.what());
    return int(error.code());
  } catch (const std::bad_alloc&) {
    log().error("out of memory");
    return int(ExitCode::runtime);
  } catch (const std::exception& error) {
    log().error("unexpected failure: {}", error.what());
    return int(ExitCode::runtime);
  }
}

}  // namespace boxlight
