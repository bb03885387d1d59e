// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/columns.hpp"

#include <algorithm>
#include <utility>

namespace proofmass {
namespace {

constexpr std::array<std::string_view, kColumns.size()> kNames{
    "Ai", "Ao", "Ap", "E", "sigma_E", "sigma_Ai", "sigma_Ao", "sigma_Ap", "mount", "T", "t"};

// Names in Chinese records.
constexpr std::array kOtherNames{
    std::pair<std::string_view, Column>{"\u8F93\u5165\u8F74\u6BD4\u529B",
                                        Column::Ai},  // specific force along IA
    std::pair<std::string_view, Column>{"\u8F93\u51FA\u8F74\u6BD4\u529B", Column::Ao},  // along OA
    std::pair<std::string_view, Column>{"\u6446\u8F74\u6BD4\u529B", Column::Ap},        // along PA
    std::pair<std::string_view, Column>{"\u8F93\u51FA", Column::E},                     // output
    std::pair<std::string_view, Column>{"\u6E29\u5EA6", Column::T},                     // temperature
    std::pair<std::string_view, Column>{"\u65F6\u95F4", Column::t},                     // time
};

// Works for const and non-const data sets: `Record` is Dataset or const Dataset.
template <typename Record>
auto& numbers_of(Record& record, Column column) {
  switch (column) {
    case Column::Ai:
      return record.acceleration[0];
    case Column::Ao:
      return record.acceleration[1];
    case Column::Ap:
      return record.acceleration[2];
    case Column::sigma_E:
      return record.output_sigma;
    case Column::sigma_Ai:
      return record.acceleration_sigma[0];
    case Column::sigma_Ao:
      return record.acceleration_sigma[1];
    case Column::sigma_Ap:
      return record.acceleration_sigma[2];
    case Column::T:
      return record.temperature;
    case Column::t:
      return record.time;
    case Column::E:
    case Column::mount:
      break;
  }
  return record.output;
}

template <typename Record>
auto& declared_unit(Record& record, Column column) {
  switch (measured_by(column).value_or(column)) {
    case Column::E:
      return record.output_unit;
    case Column::T:
      return record.temperature_unit;
    case Column::t:
      return record.time_unit;
    default:
      return record.acceleration_unit;
  }
}

}  // namespace

std::string_view column_name(Column column) noexcept { return kNames[static_cast<std::size_t>(column)]; }

std::optional<Column> find_column(std::string_view name) noexcept {
  for (const auto& [other, column] : kOtherNames) {
    if (name == other) return column;
  }
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return kColumns[static_cast<std::size_t>(found - kNames.begin())];
}

std::optional<Column> measured_by(Column sigma) noexcept {
  switch (sigma) {
    case Column::sigma_E:
      return Column::E;
    case Column::sigma_Ai:
      return Column::Ai;
    case Column::sigma_Ao:
      return Column::Ao;
    case Column::sigma_Ap:
      return Column::Ap;
    default:
      return std::nullopt;
  }
}

std::vector<double>& numbers(Dataset& record, Column column) { return numbers_of(record, column); }
const std::vector<double>& numbers(const Dataset& record, Column column) {
  return numbers_of(record, column);
}

Unit& unit_of(Dataset& record, Column column) { return declared_unit(record, column); }
const Unit& unit_of(const Dataset& record, Column column) { return declared_unit(record, column); }

}  // namespace proofmass
