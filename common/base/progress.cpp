// SPDX-License-Identifier: Apache-2.0
#include "common/base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "common/base/error.h"

namespace boxlight {
namespace {

volatile std::sig_atomic_t gInterrupted = 0;

void onSignal(int signal) {
  if (gInterrupted) std::_Exit(128 + signal);
  gInterrupted = 1;
}

std::string duration(double seconds) {
  const auto s = int64_t(seconds + 0.5);
  return s < 60 ? fmt::format("{}s", s) : fmt::format("{}m{:02}s", s / 60, s % 60);
}

}  // namespace

Progress::Progress(std::string task, uint64_t total, ProgressStyle style)
    : task_(std::move(task)), total_(total), style_(style) {
  if (style_ == ProgressStyle::automatic)
    style_ = ::isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::lines;
}

Progress::~Progress() {
  if (style_ == ProgressStyle::none || total_ == 0) return;
  const std::scoped_lock lock(mutex_);
  print(done_);
  if (style_ == ProgressStyle::bar) std::fputc('\n', stderr);
}

void Progress::advance(uint64_t count) {
  const uint64_t done = done_ += count;
  if (style_ == ProgressStyle::none) return;
  const int64_t now = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start_).count();
  if (now < nextPrint_) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock || now < nextPrint_) return;
  nextPrint_ = now + (style_ == ProgressStyle::bar ? 100 : 2000);
  print(done);
}

void Progress::print(uint64_t done) {
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  const double fraction = total_ ? std::min(1.0, double(done) / double(total_)) : 1.0;
  const double left = done ? elapsed * (1.0 / fraction - 1.0) : 0.0;
  if (style_ == ProgressStyle::bar) {
    const int filled = int(40 * fraction);
    fmt::print(stderr, "\r{} [{:=<{}}{:{}}] {:3.0f}% {} left \x1b[K", task_, "", filled, "", 40 - filled,
               100 * fraction, duration(left));
  } else if (style_ == ProgressStyle::lines) {
    fmt::print(stderr, "{}: {}/{} ({:.0f}%), {} elapsed, {} left\n", task_, done, total_, 100 * fraction,
               duration(elapsed), duration(left));
  } else {
    fmt::print(stderr,
               "{{\"task\":\"{}\",\"done\":{},\"total\":{},\"elapsed_s\":{:.1f},\"left_s\":{:.1f}}}\n", task_,
               done, total_, elapsed, left);
  }
  std::fflush(stderr);
}

void catchInterrupts() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

bool interrupted() { return gInterrupted != 0; }

void throwIfInterrupted(const char* message) {
  if (interrupted()) throw Error(ExitCode::interrupted, message);
}

}  // namespace boxlight
