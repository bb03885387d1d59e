// SPDX-License-Identifier: Apache-2.0
#include "console_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "interrupts.hpp"

namespace proofmass::cli {
namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 2s;  // before the first line
constexpr auto kRewritePause = 100ms;
constexpr auto kLinePause = 10s;

}  // namespace

std::string progress_text(std::string_view stage, std::size_t done, std::size_t total, double seconds_left) {
  const std::size_t percent = total == 0 ? 0 : done * 100 / total;
  std::string text = fmt::format("{}: {} of {} ({} %)", stage, done, total, percent);
  if (!std::isfinite(seconds_left)) return text;
  const auto left = static_cast<long>(std::ceil(seconds_left));
  if (left >= 3600)
    return text + fmt::format(", {}:{:02}:{:02} left", left / 3600, left / 60 % 60, left % 60);
  return text + fmt::format(", {}:{:02} left", left / 60, left % 60);
}

ConsoleProgress::ConsoleProgress(bool quiet) : quiet_(quiet), rewrite_(isatty(STDERR_FILENO) == 1) {}

ConsoleProgress::~ConsoleProgress() { clear(); }

void ConsoleProgress::clear() {
  if (shown_ && rewrite_) std::fputs("\r\x1b[K", stderr);
  shown_ = false;
}

bool ConsoleProgress::is_due(Clock::time_point now) const {
  if (quiet_ || now - start_ < kPatience) return false;
  return !shown_ || now - last_ >= (rewrite_ ? Clock::duration(kRewritePause) : Clock::duration(kLinePause));
}

void ConsoleProgress::update(std::string_view stage, std::size_t done, std::size_t total) {
  const auto now = Clock::now();
  if (stage != stage_) {
    stage_ = stage;
    stage_start_ = now;
    stage_first_ = done;
  }
  if (!is_due(now)) return;
  double left = std::numeric_limits<double>::infinity();
  if (done > stage_first_) {
    const double elapsed = std::chrono::duration<double>(now - stage_start_).count();
    left = elapsed / static_cast<double>(done - stage_first_) * static_cast<double>(total - done);
  }
  const std::string text = progress_text(stage, done, total, left);
  std::fputs(rewrite_ ? fmt::format("\r{}\x1b[K", text).c_str() : fmt::format("{}\n", text).c_str(), stderr);
  shown_ = true;
  last_ = now;
}

bool ConsoleProgress::cancelled() const noexcept { return interrupted(); }

}  // namespace proofmass::cli
