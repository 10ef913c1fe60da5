// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <spdlog/sinks/ostream_sink.h>

#include <memory>
#include <sstream>
#include <string>

#include "common/base/log.h"

namespace boxlight::test {

/// What the log says, from debug upwards, while this lives.
class LogCapture {
 public:
  LogCapture() : level_(log().level()) {
    log().set_level(spdlog::level::debug);
    log().sinks().push_back(std::make_shared<spdlog::sinks::ostream_sink_st>(text_));
  }
  ~LogCapture() {
    log().sinks().pop_back();
    log().set_level(level_);
  }
  LogCapture(const LogCapture&) = delete;
  LogCapture& operator=(const LogCapture&) = delete;

  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  spdlog::level::level_enum level_;
};

}  // namespace boxlight::test
