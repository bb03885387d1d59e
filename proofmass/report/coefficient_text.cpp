// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/coefficient_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "proofmass/report/number_text.hpp"
#include "proofmass/report/readable_units.hpp"

namespace proofmass {

std::string readable_text(const Coefficient& coefficient, const Unit& output) {
  if (!output.is_acceleration()) {
    const std::string unit = coefficient_unit(coefficient.term, output);
    return coefficient.standard_error
               ? fmt::format("{} ± {} {}", uncertain_text(coefficient.value, coefficient.standard_error),
                             significant_text(*coefficient.standard_error, 2), unit)
               : fmt::format("{} {}", significant_text(coefficient.value, 6), unit);
  }
  const ReadableUnit unit = readable_unit(coefficient.term);
  const double value = (coefficient.value - unit.offset) * unit.factor;
  const std::string label = coefficient.term == Term::Ki ? "Ki-1 = " : "";
  const std::string number = coefficient.standard_error
                                 ? plus_minus_text(value, *coefficient.standard_error * unit.factor)
                                 : significant_text(value, 6);
  return fmt::format("{}{} {}", label, number, unit.symbol);
}

std::string readable_interval(const Coefficient& c, const Unit& output) {
  if (!c.ci95 || !c.standard_error) return {};
  const ReadableUnit unit = output.is_acceleration() ? readable_unit(c.term) : ReadableUnit{};
  const double low = (c.ci95->low - unit.offset) * unit.factor;
  const double high = (c.ci95->high - unit.offset) * unit.factor;
  const double error = *c.standard_error * unit.factor;
  constexpr int kMostDecimals = 9;
  const int decimals = error > 0.0 ? 1 - static_cast<int>(std::floor(std::log10(error))) : kMostDecimals + 1;
  if (decimals > kMostDecimals)
    return fmt::format("[{}, {}]", uncertain_text(low, error), uncertain_text(high, error));
  return fmt::format("[{:.{}f}, {:.{}f}]", low, std::max(decimals, 0), high, std::max(decimals, 0));
}

}  // namespace proofmass
