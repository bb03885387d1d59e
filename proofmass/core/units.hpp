// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace proofmass {

inline constexpr double kStandardGravity = 9.80665;  // m/s², exact by definition (CGPM 1901)

enum class Quantity { acceleration, voltage, current, count, frequency, time, temperature };

// A unit as written in a record's header. `to_canonical` converts a value into the canonical unit of its
// quantity, so that results do not depend on the units of a record. The canonical unit of acceleration is g.
// Other quantities keep their unit (factor 1), because it does not change the meaning of any term.
struct Unit {
  Quantity quantity = Quantity::acceleration;
  std::string symbol = "g";
  double to_canonical = 1.0;
  [[nodiscard]] bool is_acceleration() const noexcept { return quantity == Quantity::acceleration; }
  // "g" for accelerations, otherwise the symbol itself.
  [[nodiscard]] std::string canonical_symbol() const { return is_acceleration() ? "g" : symbol; }
};

// Knows g, mg, ug (µg), m/s^2 (m/s2, m/s²), mm/s^2, cm/s^2, Gal, mGal, ft/s^2; V mV uV; A mA uA nA; counts
// (count, LSB); Hz kHz; s ms; degC (°C, C), K. Case matters where it distinguishes units. Empty when the unit
// is unknown.
[[nodiscard]] std::optional<Unit> find_unit(std::string_view text);

// A list of the known symbols of a quantity, for error messages.
[[nodiscard]] std::string known_units(Quantity quantity);

}  // namespace proofmass
