// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/shown_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "proofmass/report/typography.hpp"

namespace proofmass {
namespace {

struct Prefix {
  std::string_view symbol;
  int exponent;
};
constexpr std::array kPrefixes{Prefix{"M", 6},  Prefix{"k", 3},  Prefix{"", 0},   Prefix{"m", -3},
                               Prefix{"µ", -6}, Prefix{"n", -9}, Prefix{"p", -12}};

// A declared unit as a prefix and a unit that takes prefixes; the exponent of the prefix.
struct Parts {
  std::string base;
  int exponent = 0;
};

bool takes_prefixes(std::string_view base) {
  constexpr std::array<std::string_view, 5> kBases{"g", "m/s²", "V", "A", "Hz"};
  return std::find(kBases.begin(), kBases.end(), base) != kBases.end();
}

Parts parts_of(const std::string& symbol) {
  if (takes_prefixes(symbol)) return {symbol};
  for (const Prefix& prefix : kPrefixes) {
    if (!prefix.symbol.empty() && symbol.starts_with(prefix.symbol) &&
        takes_prefixes(std::string_view(symbol).substr(prefix.symbol.size())))
      return {symbol.substr(prefix.symbol.size()), prefix.exponent};
  }
  return {};
}

}  // namespace

ShownUnit shown_unit(const Unit& output, double largest) {
  constexpr double kTen = 10.0, kLeast = 0.1, kMost = 1000.0;
  const double to_declared = 1.0 / output.to_canonical;
  const std::string symbol = typeset_unit(output.symbol);
  const double declared = std::abs(largest) * to_declared;
  if (!(declared > 0.0) || !std::isfinite(declared)) return {to_declared, symbol};
  if (const Parts parts = parts_of(symbol); !parts.base.empty()) {
    for (const Prefix& prefix : kPrefixes) {
      const double factor = std::pow(kTen, parts.exponent - prefix.exponent);
      const bool last = prefix.exponent == kPrefixes.back().exponent;
      // Frequencies alone are spoken of in larger units than the declared one.
      if (prefix.exponent > std::max(parts.exponent, 0) && parts.base != "Hz") continue;
      if (declared * factor >= kLeast || last)
        return {to_declared * factor, std::string(prefix.symbol) + parts.base};
    }
  }
  if (declared >= kLeast && declared < kMost * kMost) return {to_declared, symbol};
  const int decade = 3 * static_cast<int>(std::floor(std::log10(declared) / 3.0));
  return {to_declared * std::pow(kTen, -decade), power_of_ten(decade) + " " + symbol};
}

ShownUnit shown_from_declared(const Unit& output, double largest) {
  const double known = largest > 0.0 && std::isfinite(largest) ? largest : 1.0;
  ShownUnit unit = shown_unit(output, known * output.to_canonical);
  unit.factor *= output.to_canonical;
  return unit;
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> out = values;
  for (double& v : out) v *= factor;
  return out;
}

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double v : values)
    if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
  return largest;
}

}  // namespace proofmass
