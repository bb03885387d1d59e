// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/units.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace proofmass {
namespace {

struct KnownUnit {
  Quantity quantity;
  std::string_view symbol;
  double to_canonical;
};

constexpr double kFoot = 0.3048;  // m, exact (international foot)

constexpr std::array kUnits{
    KnownUnit{Quantity::acceleration, "g", 1.0},
    KnownUnit{Quantity::acceleration, "mg", 1e-3},
    KnownUnit{Quantity::acceleration, "ug", 1e-6},
    KnownUnit{Quantity::acceleration, "m/s^2", 1.0 / kStandardGravity},
    KnownUnit{Quantity::acceleration, "mm/s^2", 1e-3 / kStandardGravity},
    KnownUnit{Quantity::acceleration, "cm/s^2", 1e-2 / kStandardGravity},
    KnownUnit{Quantity::acceleration, "Gal", 1e-2 / kStandardGravity},
    KnownUnit{Quantity::acceleration, "mGal", 1e-5 / kStandardGravity},
    KnownUnit{Quantity::acceleration, "ft/s^2", kFoot / kStandardGravity},
    KnownUnit{Quantity::voltage, "V", 1.0},
    KnownUnit{Quantity::voltage, "mV", 1.0},
    KnownUnit{Quantity::voltage, "uV", 1.0},
    KnownUnit{Quantity::current, "A", 1.0},
    KnownUnit{Quantity::current, "mA", 1.0},
    KnownUnit{Quantity::current, "uA", 1.0},
    KnownUnit{Quantity::current, "nA", 1.0},
    KnownUnit{Quantity::count, "counts", 1.0},
    KnownUnit{Quantity::frequency, "Hz", 1.0},
    KnownUnit{Quantity::frequency, "kHz", 1.0},
    KnownUnit{Quantity::time, "s", 1.0},
    KnownUnit{Quantity::time, "ms", 1.0},
    KnownUnit{Quantity::time, "min", 1.0},
    KnownUnit{Quantity::time, "h", 1.0},
    KnownUnit{Quantity::temperature, "degC", 1.0},
    KnownUnit{Quantity::temperature, "degF", 1.0},
    KnownUnit{Quantity::temperature, "K", 1.0},
};

// Alternative spellings of whole symbols, applied after the characters below have been replaced.
constexpr std::array kAliases{
    std::pair<std::string_view, std::string_view>{"m/s2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"mm/s2", "mm/s^2"},
    std::pair<std::string_view, std::string_view>{"cm/s2", "cm/s^2"},
    std::pair<std::string_view, std::string_view>{"ft/s2", "ft/s^2"},
    std::pair<std::string_view, std::string_view>{"count", "counts"},
    std::pair<std::string_view, std::string_view>{"LSB", "counts"},
    std::pair<std::string_view, std::string_view>{"C", "degC"},
    std::pair<std::string_view, std::string_view>{"F", "degF"},
    std::pair<std::string_view, std::string_view>{"ms2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"ms^2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m_s2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m_s^2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"mps2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m/s/s", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m/s**2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"ms-2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m s-2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m s^-2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m*s^-2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m*s-2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m s-^2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"m*s-^2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"ms-^2", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"cts", "counts"},
    std::pair<std::string_view, std::string_view>{"Counts", "counts"},
    std::pair<std::string_view, std::string_view>{"lsb", "counts"},
    std::pair<std::string_view, std::string_view>{"digits", "counts"},
    std::pair<std::string_view, std::string_view>{"Volt", "V"},
    std::pair<std::string_view, std::string_view>{"Volts", "V"},
    std::pair<std::string_view, std::string_view>{"volt", "V"},
    std::pair<std::string_view, std::string_view>{"volts", "V"},
    std::pair<std::string_view, std::string_view>{"VDC", "V"},
    std::pair<std::string_view, std::string_view>{"Vdc", "V"},
    std::pair<std::string_view, std::string_view>{"V DC", "V"},
    std::pair<std::string_view, std::string_view>{"mVDC", "mV"},
    std::pair<std::string_view, std::string_view>{"mADC", "mA"},
    std::pair<std::string_view, std::string_view>{"gn", "g"},
    std::pair<std::string_view, std::string_view>{"g_n", "g"},
    std::pair<std::string_view, std::string_view>{"g0", "g"},
    std::pair<std::string_view, std::string_view>{"cnt", "counts"},
    std::pair<std::string_view, std::string_view>{"cnts", "counts"},
    std::pair<std::string_view, std::string_view>{"sec", "s"},
    std::pair<std::string_view, std::string_view>{"hr", "h"},
};

// Non-ASCII characters in unit symbols, and their replacements.
constexpr std::array kCharacters{
    std::pair<std::string_view, std::string_view>{"\u00B5", "u"},    // micro sign
    std::pair<std::string_view, std::string_view>{"\u03BC", "u"},    // Greek small letter mu
    std::pair<std::string_view, std::string_view>{"\u00B2", "^2"},   // superscript two
    std::pair<std::string_view, std::string_view>{"\u00B0", "deg"},  // degree sign
    std::pair<std::string_view, std::string_view>{"\u207B", "-"},    // superscript minus
    std::pair<std::string_view, std::string_view>{"\u00B7", "*"},    // middle dot
    std::pair<std::string_view, std::string_view>{"\u22C5", "*"},    // dot operator
    std::pair<std::string_view, std::string_view>{"\u33A8", "m/s^2"},
    std::pair<std::string_view, std::string_view>{"\u2103", "degC"},
    std::pair<std::string_view, std::string_view>{"\u2109", "degF"},
};

std::string in_ascii(std::string_view text) {
  std::string ascii(text);
  for (const auto& [character, replacement] : kCharacters) {
    for (auto at = ascii.find(character); at != std::string::npos; at = ascii.find(character, at)) {
      ascii.replace(at, character.size(), replacement);
    }
  }
  return ascii;
}

}  // namespace

std::optional<Unit> find_unit(std::string_view text) {
  std::string symbol = in_ascii(text);
  const auto* const alias =
      std::find_if(kAliases.begin(), kAliases.end(), [&](const auto& a) { return a.first == symbol; });
  if (alias != kAliases.end()) symbol = alias->second;
  const auto* const unit =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const KnownUnit& u) { return u.symbol == symbol; });
  if (unit == kUnits.end()) return std::nullopt;
  return Unit{.quantity = unit->quantity, .symbol = symbol, .to_canonical = unit->to_canonical};
}

std::string known_units(Quantity quantity) {
  std::string list;
  for (const KnownUnit& unit : kUnits) {
    if (unit.quantity != quantity) continue;
    if (!list.empty()) list += ", ";
    list += unit.symbol;
  }
  return list;
}

}  // namespace proofmass
