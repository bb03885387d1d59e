// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/plot/scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "proofmass/report/typography.hpp"

namespace proofmass {
namespace {

constexpr double kEdge = 1e-9;  // of a decade: a value on its end is within it

}  // namespace

bool Scale::shows(double value) const { return std::isfinite(value) && (!log_ || value > 0.0); }

double Scale::raw(double value) const { return log_ ? std::log10(value) : value; }

void Scale::include(double value) {
  if (!shows(value)) return;
  const double r = raw(value);
  low_ = empty_ ? r : std::min(low_, r);
  high_ = empty_ ? r : std::max(high_, r);
  empty_ = false;
}

void Scale::finish(double margin) {
  if (!(high_ - low_ > 1e-12 * std::max(std::abs(low_), std::abs(high_)))) {
    const double half = low_ == 0.0 || log_ ? 0.5 : 0.5 * std::abs(low_);
    low_ -= half;
    high_ += half;
  } else if (!log_) {
    const double more = margin * (high_ - low_);
    low_ -= more;
    high_ += more;
  }
  if (log_) low_ = std::floor(low_ + kEdge), high_ = std::ceil(high_ - kEdge);
}

double Scale::place(double value) const {
  return from_ + (to_ - from_) * ((raw(value) - low_) / (high_ - low_));
}

std::vector<double> Scale::ticks(std::size_t about) const {
  const double rough = (high_ - low_) / static_cast<double>(about);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * (1.0 - 1e-9)) {
      step = factor * power;
      break;
    }
  }
  if (log_) step = std::max(1.0, std::ceil(step));
  std::vector<double> found;
  for (double k = std::ceil(low_ / step - 1e-9); k * step <= high_ + 1e-9 * step; k += 1.0) {
    const double tick = k == 0.0 ? 0.0 : k * step;
    found.push_back(log_ ? std::pow(10.0, tick) : tick);
  }
  return found;
}

std::vector<std::string> tick_texts(const Scale& scale, const std::vector<double>& ticks) {
  std::vector<std::string> texts;
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  const double largest = ticks.empty() ? 0.0 : std::max(std::abs(ticks.front()), std::abs(ticks.back()));
  const int decimals = static_cast<int>(std::ceil(-std::log10(std::abs(step)) - 1e-9));
  const int digits =
      std::clamp(static_cast<int>(std::ceil(std::log10(largest / std::abs(step)) + 1e-9)) + 1, 1, 15);
  constexpr double kPlainFrom = 1e-4, kPlainTo = 1e6;
  for (const double tick : ticks) {
    if (scale.log()) {
      texts.push_back(power_of_ten(static_cast<int>(std::lround(std::log10(tick)))));
    } else if (largest >= kPlainTo || step < kPlainFrom) {
      texts.push_back(typeset(fmt::format("{:.{}g}", tick, digits)));
    } else {
      texts.push_back(typeset(fmt::format("{:.{}f}", tick, std::max(decimals, 0))));
    }
  }
  return texts;
}

}  // namespace proofmass
