// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/coefficient_text.hpp"

#include <fmt/format.h>

#include "proofmass/report/number_text.hpp"
#include "proofmass/report/readable_units.hpp"

namespace proofmass {

std::string reading_unit(Term term, const Unit& output) {
  return output.is_acceleration() ? readable_unit(term).symbol : coefficient_unit(term, output);
}

std::string readable_number(const Coefficient& c, const Unit& output) {
  const ReadableUnit unit = output.is_acceleration() ? readable_unit(c.term) : ReadableUnit{};
  const double value = (c.value - unit.offset) * unit.factor;
  if (value == 0.0 && !c.standard_error) return "0";
  return c.standard_error ? plus_minus_text(value, *c.standard_error * unit.factor)
                          : significant_text(value, 6);
}

std::string readable_text(const Coefficient& c, const Unit& output) {
  const std::string label = output.is_acceleration() && c.term == Term::Ki ? "Ki-1 = " : "";
  return fmt::format("{}{} {}", label, readable_number(c, output), reading_unit(c.term, output));
}

std::string readable_interval(const Coefficient& c, const Unit& output) {
  if (!c.ci95 || !c.standard_error) return {};
  const ReadableUnit unit = output.is_acceleration() ? readable_unit(c.term) : ReadableUnit{};
  const double low = (c.ci95->low - unit.offset) * unit.factor;
  const double high = (c.ci95->high - unit.offset) * unit.factor;
  return interval_text((c.value - unit.offset) * unit.factor, *c.standard_error * unit.factor, low, high);
}

}  // namespace proofmass
