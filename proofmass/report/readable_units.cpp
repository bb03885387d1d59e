// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/readable_units.hpp"

namespace proofmass {

ReadableUnit readable_unit(Term term) {
  constexpr double kMillion = 1e6;
  if (term == Term::Ki) return {.offset = 1.0, .factor = kMillion, .symbol = "ppm"};
  if (term == Term::Ko || term == Term::Kp) return {.factor = kMillion, .symbol = "µrad"};
  switch (info(term).order()) {
    case 0:
      return {.factor = kMillion, .symbol = "µg"};
    case 2:
      return {.factor = kMillion, .symbol = "µg/g²"};
    default:
      return {.factor = kMillion, .symbol = "µg/g³"};
  }
}

std::string coefficient_unit(Term term, const Unit& output) {
  const int order = info(term).order();
  std::string symbol = output.canonical_symbol();
  if (order == 0) return symbol;
  if (order == 1) return symbol + "/g";
  return symbol + "/g^" + std::to_string(order);
}

double to_declared(double canonical, const Unit& output) noexcept { return canonical / output.to_canonical; }

}  // namespace proofmass
