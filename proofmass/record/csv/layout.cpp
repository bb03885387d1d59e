// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "proofmass/core/error.hpp"
#include "proofmass/record/csv/units.hpp"

namespace proofmass {
namespace {

std::string names_of(const Header& header) {
  std::string names;
  for (const HeaderCell& cell : header.cells) names += (names.empty() ? "" : " ") + cell.text;
  return names;
}

Error missing(const Header& header, Column column, const std::string& wanted) {
  const std::string renamed =
      wanted == column_name(column) ? "" : fmt::format(" (it was to be read as {})", column_name(column));
  return bad_data(
      {.file = header.file, .row = header.row, .column = wanted}, names_of(header),
      fmt::format("a column named {}{}; columns are separated by comma, semicolon or tab", wanted, renamed));
}

// The only cell that `matches`. Empty when there is none; throws an Error when there are more.
template <typename Predicate>
std::optional<std::size_t> only(const Header& header, const std::string& wanted, Predicate matches) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < header.cells.size(); ++k) {
    if (!matches(header.cells[k])) continue;
    if (found) {
      throw bad_data({.file = header.file, .row = header.row, .column = wanted}, header.cells[k].text,
                     fmt::format("one column named {}, not a duplicate", wanted));
    }
    found = k;
  }
  return found;
}

PlacedColumn renamed_column(const Header& header, Column column, const std::string& wanted) {
  auto index = only(header, wanted, [&](const HeaderCell& cell) { return cell.text == wanted; });
  if (!index) index = only(header, wanted, [&](const HeaderCell& cell) { return cell.name == wanted; });
  if (index) return place_column(header, column, *index, header.cells[*index].unit);
  const HeaderCell named = parse_header_cell(wanted);
  if (named.unit) {
    index = only(header, named.name, [&](const HeaderCell& cell) { return cell.text == named.name; });
  }
  if (!index) throw missing(header, column, wanted);
  return place_column(header, column, *index, named.unit);
}

std::vector<PlacedColumn> renamed_columns(const Header& header, const ReadOptions& options) {
  std::vector<PlacedColumn> placed;
  std::set<std::size_t> taken;
  for (const auto& [name, wanted] : options.rename) {
    const auto column = find_column(name);
    if (!column) {
      throw usage_error(
          fmt::format("cannot rename to '{}'; the columns of a record are Ai, Ao, Ap, E, sigma_E, sigma_Ai, "
                      "sigma_Ao, sigma_Ap, mount, T, t",
                      name));
    }
    placed.push_back(renamed_column(header, *column, wanted));
    if (!taken.insert(placed.back().index).second) {
      throw usage_error(fmt::format("column '{}' is renamed twice", header.cells[placed.back().index].text));
    }
  }
  return placed;
}

// Columns found by Proofmass's own names. A column that was renamed is no longer found by its own name.
void add_named_columns(const Header& header, std::vector<PlacedColumn>& placed) {
  const std::vector<PlacedColumn> renamed = placed;
  const auto was_renamed = [&](const HeaderCell& cell) {
    return std::any_of(renamed.begin(), renamed.end(),
                       [&](const PlacedColumn& p) { return &header.cells[p.index] == &cell; });
  };
  for (const Column column : kColumns) {
    if (std::any_of(renamed.begin(), renamed.end(),
                    [&](const PlacedColumn& p) { return p.column == column; }))
      continue;
    const std::string name(column_name(column));
    const auto index =
        only(header, name, [&](const HeaderCell& cell) { return cell.name == name && !was_renamed(cell); });
    if (index) placed.push_back(place_column(header, column, *index, header.cells[*index].unit));
  }
}

bool holds(const std::vector<PlacedColumn>& placed, Column column) {
  return std::any_of(placed.begin(), placed.end(),
                     [column](const PlacedColumn& p) { return p.column == column; });
}

}  // namespace

std::vector<PlacedColumn> lay_out(const Header& header, const ReadOptions& options) {
  std::vector<PlacedColumn> placed = renamed_columns(header, options);
  add_named_columns(header, placed);
  if (!holds(placed, Column::Ai)) throw missing(header, Column::Ai, "Ai");
  if (options.require_output && !holds(placed, Column::E)) throw missing(header, Column::E, "E");
  std::erase_if(placed, [&](const PlacedColumn& p) {
    const auto measured = measured_by(p.column);
    return measured && !holds(placed, *measured);
  });
  settle_units(header, placed);
  return placed;
}

}  // namespace proofmass
