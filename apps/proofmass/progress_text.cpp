// SPDX-License-Identifier: Apache-2.0
#include "progress_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace proofmass::cli {
namespace {

constexpr double kFractionForForecast = 0.1;

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string progress_text(const StageProgress& progress, std::size_t width) {
  const auto& [stage, first, done, total, seconds] = progress;
  std::string time = fmt::format("{} so far", clock_text(seconds));
  if (total <= 1) return fmt::format("{}: {}", stage, time).substr(0, width);
  const auto made = static_cast<double>(done) - static_cast<double>(first);
  const auto all = static_cast<double>(total) - static_cast<double>(first);
  if (made >= kFractionForForecast * all && made > 0.0)
    time = fmt::format("{} left", clock_text(seconds / made * (all - made)));
  const std::size_t percent = done * 100 / total;
  std::string text = fmt::format("{}: {} of {} ({} %), {}", stage, done, total, percent, time);
  if (text.size() <= width) return text;
  return fmt::format("{}: {} %, {}", stage, percent, time).substr(0, width);
}

}  // namespace proofmass::cli
