// SPDX-License-Identifier: Apache-2.0
#include "console_progress.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <utility>

#include "interrupts.hpp"
#include "output.hpp"
#include "progress_text.hpp"

namespace proofmass::cli {
namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 2s;  // before the first line
constexpr auto kRewritePause = 100ms;
constexpr auto kLinePause = 10s;
constexpr auto kWatchPause = 500ms;

// A thread that signals do not reach: they are for the thread that waits for input.
template <typename Function>
std::thread thread_without_signals(Function function) {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(function));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace

ConsoleProgress::ConsoleProgress(bool quiet) : quiet_(quiet), rewrite_(isatty(STDERR_FILENO) == 1) {
  if (!quiet_) watcher_ = thread_without_signals([this] { watch(); });
}

ConsoleProgress::~ConsoleProgress() {
  clear();
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  woken_.notify_all();
  if (watcher_.joinable()) watcher_.join();
}

void ConsoleProgress::clear() {
  const std::lock_guard lock(mutex_);
  if (shown_ && rewrite_) std::fputs("\r\x1b[K", stderr);
  shown_ = false;
  stage_.clear();
}

bool ConsoleProgress::is_due(Clock::time_point now) const {
  if (quiet_ || now - start_ < kPatience) return false;
  return !shown_ || now - last_ >= (rewrite_ ? Clock::duration(kRewritePause) : Clock::duration(kLinePause));
}

void ConsoleProgress::show(Clock::time_point now) {
  const std::string text =
      progress_text({.stage = stage_,
                     .first = stage_first_,
                     .done = done_,
                     .total = total_,
                     .seconds = std::chrono::duration<double>(now - stage_start_).count()},
                    // With one column to spare: the cursor then stays in the line.
                    rewrite_ ? terminal_columns(STDERR_FILENO).value_or(kAnyWidth) - 1 : kAnyWidth);
  std::fputs(rewrite_ ? fmt::format("\r{}\x1b[K", text).c_str() : fmt::format("{}\n", text).c_str(), stderr);
  shown_ = true;
  last_ = now;
}

void ConsoleProgress::update(std::string_view stage, std::size_t done, std::size_t total) {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (stage != stage_) {
    stage_ = stage;
    stage_start_ = now;
    stage_first_ = done;
  }
  done_ = done;
  total_ = total;
  // A stage in one piece that is done has nothing more to say.
  if (total > 1 && is_due(now)) show(now);
}

void ConsoleProgress::watch() {
  std::unique_lock lock(mutex_);
  while (!woken_.wait_for(lock, kWatchPause, [this] { return stop_; })) {
    const auto now = Clock::now();
    const bool under_way = !stage_.empty() && done_ < total_;
    if (under_way && is_due(now)) show(now);
  }
}

bool ConsoleProgress::cancelled() const noexcept { return interrupted(); }

}  // namespace proofmass::cli
