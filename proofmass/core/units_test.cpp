// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/units.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace proofmass {
namespace {

TEST(Units, AccelerationsConvertToStandardGravity) {
  // 1 g in each unit, from the definitions of the unit and of standard gravity.
  const std::pair<const char*, double> one_g[] = {
      {"g", 1.0},         {"mg", 1e3},         {"ug", 1e6},
      {"m/s^2", 9.80665}, {"mm/s^2", 9806.65}, {"cm/s^2", 980.665},
      {"Gal", 980.665},   {"mGal", 980665.0},  {"ft/s^2", 9.80665 / 0.3048}};
  for (const auto& [symbol, value] : one_g) {
    const auto unit = find_unit(symbol);
    ASSERT_TRUE(unit) << symbol;
    EXPECT_TRUE(unit->is_acceleration());
    EXPECT_EQ(unit->canonical_symbol(), "g");
    EXPECT_NEAR(value * unit->to_canonical, 1.0, 2 * std::numeric_limits<double>::epsilon()) << symbol;
  }
}

TEST(Units, OtherQuantitiesStayAsWritten) {
  for (const char* symbol :
       {"V", "mV", "uV", "A", "mA", "uA", "nA", "counts", "Hz", "kHz", "s", "ms", "degC", "K"}) {
    const auto unit = find_unit(symbol);
    ASSERT_TRUE(unit) << symbol;
    EXPECT_FALSE(unit->is_acceleration());
    EXPECT_EQ(unit->canonical_symbol(), symbol);
    EXPECT_EQ(unit->to_canonical, 1.0);
  }
}

TEST(Units, SpellingsOfOneUnitAgree) {
  const std::pair<const char*, const char*> spellings[] = {
      {"\u00B5g", "ug"}, {"\u03BCg", "ug"},        {"\u00B5V", "uV"},   {"m/s\u00B2", "m/s^2"},
      {"m/s2", "m/s^2"}, {"mm/s\u00B2", "mm/s^2"}, {"\u00B0C", "degC"}, {"C", "degC"},
      {"LSB", "counts"}, {"count", "counts"},      {"gn", "g"},         {"VDC", "V"},
      {"mADC", "mA"},    {"cnts", "counts"}};
  for (const auto& [written, symbol] : spellings) {
    const auto unit = find_unit(written);
    ASSERT_TRUE(unit) << written;
    EXPECT_EQ(unit->symbol, symbol);
  }
}

TEST(Units, UnknownAndWronglyCasedAreNotFound) {
  for (const char* text : {"", "furlong", "G", "Mg", "MA", "gal", "m/s", "m/s^3", " g", "g "}) {
    EXPECT_FALSE(find_unit(text)) << text;
  }
}

RC_GTEST_PROP(Units, EveryListedUnitIsFoundAndConvertsBack, (double value)) {
  for (const Quantity quantity :
       {Quantity::acceleration, Quantity::voltage, Quantity::current, Quantity::count, Quantity::frequency,
        Quantity::time, Quantity::temperature}) {
    std::istringstream list(known_units(quantity));
    RC_ASSERT(!list.str().empty());
    for (std::string symbol; std::getline(list >> std::ws, symbol, ',');) {
      const auto unit = find_unit(symbol);
      RC_ASSERT(unit.has_value());
      RC_ASSERT(unit->quantity == quantity);
      const double back = value * unit->to_canonical / unit->to_canonical;
      RC_ASSERT(std::abs(back - value) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(value));
    }
  }
}

}  // namespace
}  // namespace proofmass
