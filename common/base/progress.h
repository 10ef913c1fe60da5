// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace boxlight {

enum class ProgressStyle { automatic, bar, lines, json, none };

/// Progress of one long task on stderr, with the time left. `automatic` is a bar on a terminal and lines
/// elsewhere. advance() may be called from any thread.
class Progress {
 public:
  Progress(std::string task, uint64_t total, ProgressStyle style);
  ~Progress();
  void advance(uint64_t count = 1);

 private:
  using Clock = std::chrono::steady_clock;
  void print(uint64_t done);

  std::string task_;
  uint64_t total_;
  ProgressStyle style_;
  Clock::time_point start_ = Clock::now();
  std::atomic<uint64_t> done_{0};
  std::atomic<int64_t> nextPrint_{0};  // milliseconds after start
  std::mutex mutex_;
};

/// Turns SIGINT and SIGTERM into a flag that long loops poll; a second signal ends the process at once.
void catchInterrupts();
bool interrupted();
/// Throws Error(ExitCode::interrupted) with `message` if a signal came.
void throwIfInterrupted(const char* message);

}  // namespace boxlight
