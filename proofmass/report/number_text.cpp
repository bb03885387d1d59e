// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace proofmass {
namespace {

int decade(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

bool has_decade(double value) { return value != 0.0 && std::isfinite(value); }

// With so many decimals; below zero, rounded to tens, hundreds and so on. What rounds to zero has no sign.
std::string rounded_text(double value, int decimals) {
  const double step = std::pow(10.0, std::max(-decimals, 0));
  const double rounded = decimals < 0 ? std::round(value / step) * step : value;
  const std::string text = fmt::format("{:.{}f}", rounded, std::max(decimals, 0));
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  return zero && text.starts_with('-') ? text.substr(1) : text;
}

// How a value, its standard error and its interval are written alike: to two digits of the error, and by a
// common power of ten where they are very small or large.
struct Digits {
  int power = 0;
  int decimals = 0;
  [[nodiscard]] std::string text(double value) const {
    return rounded_text(value / std::pow(10.0, power), decimals);
  }
  [[nodiscard]] std::string with_power(const std::string& text) const {
    if (power == 0) return text;
    const bool bracketed = text.starts_with('[');
    return fmt::format("{}{}{}e{:+03d}", bracketed ? "" : "(", text, bracketed ? "" : ")", power);
  }
};

// Nothing where the error is none, or so small beside the value that two digits of it need too many.
std::optional<Digits> digits_of(double value, double standard_error) {
  constexpr int kLeastDecade = -4;
  constexpr int kMostDecade = 8;
  constexpr int kMostDecimals = 12;
  if (!has_decade(standard_error) || !std::isfinite(value)) return std::nullopt;
  const int size = decade(std::max(std::abs(value), standard_error));
  const int power = size < kLeastDecade || size > kMostDecade ? size : 0;
  const int decimals = 1 - decade(standard_error) + power;
  if (decimals > kMostDecimals) return std::nullopt;
  return Digits{.power = power, .decimals = decimals};
}

}  // namespace

std::string significant_text(double value, int digits) {
  std::string text = fmt::format("{:#.{}g}", value, digits);
  // fmt adds ".0" to a number whose digits end at the decimal point: one digit more than was asked.
  const bool whole = text.ends_with(".0") && std::abs(value) >= std::pow(10.0, digits - 1) * (1.0 - 1e-15);
  return whole ? text.substr(0, text.size() - 2) : text;
}

std::string uncertain_text(double value, const std::optional<double>& standard_error) {
  if (!has_decade(value)) return fmt::format("{}", value);
  if (!standard_error || !has_decade(*standard_error)) return significant_text(value, 6);
  return significant_text(value, std::clamp(decade(value) - decade(*standard_error) + 2, 3, 15));
}

std::string plus_minus_text(double value, double standard_error) {
  const auto digits = digits_of(value, standard_error);
  if (!digits) return fmt::format("{:.6g} ± {:.2g}", value, standard_error);
  return digits->with_power(digits->text(value).append(" ± ").append(digits->text(standard_error)));
}

std::string interval_text(double value, double standard_error, double low, double high) {
  const auto digits = digits_of(value, standard_error);
  if (!digits)
    return fmt::format("[{}, {}]", uncertain_text(low, standard_error), uncertain_text(high, standard_error));
  return digits->with_power(
      std::string("[").append(digits->text(low)).append(", ").append(digits->text(high)).append("]"));
}

std::string determination_text(double r2) {
  constexpr double kClose = 1e-4;
  const double lacking = 1.0 - r2;
  if (lacking > 0.0 && lacking < kClose) return fmt::format("1 - {:.3g}", lacking);
  return fmt::format("{:.6g}", r2);
}

}  // namespace proofmass
