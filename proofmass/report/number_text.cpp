// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace proofmass {
namespace {

int decade(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

bool has_decade(double value) { return value != 0.0 && std::isfinite(value); }

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
  if (!has_decade(standard_error)) return fmt::format("{:.6g} ± {:.3g}", value, standard_error);
  const int decimals = 1 - decade(standard_error);
  if (decimals > 9 || decade(standard_error) > 6)
    return fmt::format("{:.6g} ± {:.2g}", value, standard_error);
  return fmt::format("{:.{}f} ± {:.{}f}", value, std::max(decimals, 0), standard_error,
                     std::max(decimals, 0));
}

std::string determination_text(double r2) {
  constexpr double kClose = 1e-4;
  const double lacking = 1.0 - r2;
  if (lacking > 0.0 && lacking < kClose) return fmt::format("1 - {:.3g}", lacking);
  return fmt::format("{:.6g}", r2);
}

}  // namespace proofmass
