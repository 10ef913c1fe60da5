// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace boxlight {

/// What a program tells its caller. Documented in docs/ptbake.md; the numbers never change.
enum class ExitCode : int {
  ok = 0,
  usage = 1,
  io = 2,
  invalidInput = 3,
  runtime = 4,
  unsupported = 5,
  interrupted = 6,
  difference = 7,
};

/// A failure the user can act on. The message names the file, the place, the reason and, where there is one,
/// the remedy. It travels to runMain (cli.h), which prints it and ends with `code`. Wrong code is an assert
/// instead.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

template <class... Args>
[[noreturn]] void fail(ExitCode code, fmt::format_string<Args...> format, Args&&... args) {
  throw Error(code, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace boxlight
