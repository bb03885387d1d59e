// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace proofmass {

inline constexpr double kStandardGravity = 9.80665;  // m/s², exact by definition (CGPM 1901)

enum class Quantity { acceleration, voltage, current, count, frequency, time, temperature };

// A unit as a record's header writes it. `to_canonical` multiplies a value into the canonical unit of its
// quantity, so that results do not depend on the units a record happens to use: g for accelerations; other
// quantities stay in the unit written (factor 1), for no accelerometer term changes meaning with it.
struct Unit {
  Quantity quantity = Quantity::acceleration;
  std::string symbol = "g";
  double to_canonical = 1.0;
  [[nodiscard]] bool is_acceleration() const noexcept { return quantity == Quantity::acceleration; }
  // "g" for accelerations, otherwise the symbol itself.
  [[nodiscard]] std::string canonical_symbol() const { return is_acceleration() ? "g" : symbol; }
};

// Knows g, mg, ug (µg), m/s^2 (m/s2, m/s²), mm/s^2, cm/s^2, Gal, mGal, ft/s^2; V mV uV; A mA uA nA; counts
// (count, LSB); Hz kHz; s ms; degC (°C, C), K. Case matters where it distinguishes units. Returns nothing
// when unknown.
[[nodiscard]] std::optional<Unit> find_unit(std::string_view text);

// A list of the known symbols of a quantity, for error messages.
[[nodiscard]] std::string known_units(Quantity quantity);

}  // namespace proofmass
