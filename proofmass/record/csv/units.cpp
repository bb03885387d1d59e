// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

constexpr std::array kAcceleration{Quantity::acceleration};
constexpr std::array kTemperature{Quantity::temperature};
constexpr std::array kTime{Quantity::time};
constexpr std::array kOutput{Quantity::acceleration, Quantity::voltage, Quantity::current, Quantity::count,
                             Quantity::frequency};

// The quantities that a column may hold, the default first. Empty for text.
std::span<const Quantity> quantities(Column column) {
  switch (measured_by(column).value_or(column)) {
    case Column::E:
      return kOutput;
    case Column::T:
      return kTemperature;
    case Column::t:
      return kTime;
    case Column::mount:
      return {};
    default:
      return kAcceleration;
  }
}

Message units_allowed(Column column) {
  if (column == Column::mount) return message("no unit");
  std::string list;
  for (const Quantity quantity : quantities(column))
    list += (list.empty() ? "" : ", ") + known_units(quantity);
  return message("a unit among {}", list);
}

Unit default_unit(Column column) {
  const Dataset record;
  return unit_of(record, column);
}

// The header's own words may look like a unit and be none: "Voltage (Ch 2)".
std::vector<Remedy> unit_remedy(const Header& header, Column column, std::size_t index) {
  if (column == Column::mount || header.cells[index].text.find('[') != std::string::npos) return {};
  return {{"map", fmt::format("{}={}[{}]", column_name(column), excerpt(header.cells[index].text),
                              default_unit(column).symbol)}};
}

PlacedColumn& placed_as(std::vector<PlacedColumn>& placed, Column column) {
  return *std::find_if(placed.begin(), placed.end(),
                       [column](const PlacedColumn& p) { return p.column == column; });
}

Error mixed(const Header& header, const PlacedColumn& odd, const PlacedColumn& other) {
  return bad_data(
      {.file = header.file, .row = header.row, .column = std::string(column_name(odd.column))}, odd.header,
      message("the unit of {}, [{}], not mixed units", column_name(other.column), other.unit.symbol));
}

// Only the sigmas of accelerations are converted; other quantities keep the unit written.
bool convertible(const Unit& from, const Unit& to) {
  return from.symbol == to.symbol || (from.is_acceleration() && to.is_acceleration());
}

}  // namespace

bool may_have_unit(Column column, const std::optional<std::string>& unit) {
  if (!unit) return true;
  const auto known = find_unit(*unit);
  const auto allowed = quantities(column);
  return known && std::find(allowed.begin(), allowed.end(), known->quantity) != allowed.end();
}

PlacedColumn place_column(const Header& header, Column column, std::size_t index,
                          const std::optional<std::string>& unit) {
  PlacedColumn placed{
      .column = column, .index = index, .unit = default_unit(column), .header = header.cells[index].text};
  if (!unit) {
    placed.declared = false;
    if (measured_by(column)) placed.unit.symbol.clear();
    return placed;
  }
  if (!may_have_unit(column, unit)) {
    throw bad_data({.file = header.file, .row = header.row, .column = std::string(column_name(column))},
                   "[" + *unit + "]", units_allowed(column), unit_remedy(header, column, index));
  }
  placed.unit = *find_unit(*unit);
  return placed;
}

void settle_units(const Header& header, std::vector<PlacedColumn>& placed) {
  const PlacedColumn& input = placed_as(placed, Column::Ai);
  for (PlacedColumn& p : placed) {
    const bool cross_axis = p.column == Column::Ao || p.column == Column::Ap;
    if (cross_axis && p.unit.symbol != input.unit.symbol) throw mixed(header, p, input);
    const auto measured = measured_by(p.column);
    if (!measured) continue;
    const PlacedColumn& quantity = placed_as(placed, *measured);
    if (p.unit.symbol.empty()) p.unit = quantity.unit;
    if (!convertible(p.unit, quantity.unit)) throw mixed(header, p, quantity);
  }
}

}  // namespace proofmass
