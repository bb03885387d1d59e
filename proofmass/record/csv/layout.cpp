// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/core/nearest.hpp"
#include "proofmass/core/units.hpp"
#include "proofmass/record/csv/fields.hpp"
#include "proofmass/record/csv/units.hpp"

namespace proofmass {
namespace {

std::string names_of(const Header& header) {
  std::string names;
  for (const HeaderCell& cell : header.cells) names += (names.empty() ? "" : " ") + cell.text;
  return names;
}

std::string letters_of(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return letters;
}

// The column whose name differs in case and punctuation alone.
std::string name_meant(std::string_view name) {
  const std::string letters = letters_of(name);
  if (letters.empty() || find_column(name)) return {};
  for (const Column column : kColumns) {
    if (column_name(column) != name && letters_of(column_name(column)) == letters)
      return std::string(column_name(column));
  }
  return {};
}

// The header's cell that looks like a slip of a column's name.
const HeaderCell* slip_of(const Header& header, Column column) {
  const auto like = [column](const HeaderCell& cell) { return name_meant(cell.name) == column_name(column); };
  const auto found = std::find_if(header.cells.begin(), header.cells.end(), like);
  return found == header.cells.end() ? nullptr : &*found;
}

// "Ai=AI,E=e": every cell that looks like a slip.
std::string slips_of(const Header& header) {
  std::string map;
  for (const HeaderCell& cell : header.cells) {
    const std::string meant = name_meant(cell.name);
    if (!meant.empty()) map += fmt::format("{}{}={}", map.empty() ? "" : ",", meant, excerpt(cell.text));
  }
  return map;
}

// The header's cell that holds angles.
const HeaderCell* angle_of(const Header& header) {
  const auto is_angle = [](const HeaderCell& cell) {
    return cell.unit && (*cell.unit == "deg" || *cell.unit == "rad" || *cell.unit == "\u00B0");
  };
  const auto found = std::find_if(header.cells.begin(), header.cells.end(), is_angle);
  return found == header.cells.end() ? nullptr : &*found;
}

// How a renaming asks for a cell: by what stands there, or by its position where that stands there twice.
std::string asked_for(const Header& header, const HeaderCell& cell) {
  const auto same = [&cell](const HeaderCell& other) { return other.text == cell.text; };
  if (std::count_if(header.cells.begin(), header.cells.end(), same) == 1) return excerpt(cell.text);
  return fmt::format("#{}", &cell - header.cells.data() + 1);
}

// What may stand in the place of a missing column: cells that are no column of Proofmass's and not renamed,
// in a unit that it may have; those that say such a unit where some do.
std::vector<std::string> candidates(const Header& header, Column column, const ReadOptions& options) {
  const auto renamed = [&](const HeaderCell& cell) {
    return std::any_of(options.rename.begin(), options.rename.end(), [&](const auto& renaming) {
      const auto position = position_of(renaming.second);
      return position ? &header.cells[std::min(*position, header.cells.size() - 1)] == &cell
                      : renaming.second == cell.text || renaming.second == cell.name;
    });
  };
  std::vector<std::string> names;
  std::vector<std::string> with_unit;
  for (const HeaderCell& cell : header.cells) {
    const bool known = find_column(cell.name) && !cell.loose;
    if (cell.text.empty() || known || renamed(cell) || !may_have_unit(column, cell.unit)) continue;
    names.push_back(asked_for(header, cell));
    if (cell.unit) with_unit.push_back(names.back());
  }
  return with_unit.empty() ? names : with_unit;
}

// Renamings to paste: the slips, the name nearest to the one asked for, or the few columns that there are. Of
// many nobody knows which is meant.
std::vector<Remedy> renamings(const Header& header, Column column, const std::string& wanted,
                              const ReadOptions& options) {
  constexpr std::size_t most = 3;
  const bool own = wanted == column_name(column);
  if (own && slip_of(header, column) != nullptr) return {{"map", slips_of(header)}};
  std::vector<std::string> names = candidates(header, column, options);
  const std::string nearest = nearest_name(wanted, std::vector<std::string_view>(names.begin(), names.end()));
  if (!own && !nearest.empty()) names = {nearest};
  if (names.empty() || names.size() > most) names = {"NAME"};
  std::vector<Remedy> remedies;
  remedies.reserve(names.size());
  for (const std::string& name : names)
    remedies.push_back({"map", fmt::format("{}={}", column_name(column), name)});
  return remedies;
}

Error missing(const Header& header, Column column, const std::string& wanted, const ReadOptions& options) {
  const bool own = wanted == column_name(column);
  const Message renamed = own ? Message() : message(" (it was to be read as {})", column_name(column));
  const HeaderCell* const angle = measured_by(column) || column == Column::E ? nullptr : angle_of(header);
  const Message advice =
      angle == nullptr ? Message()
                       : message(
                             "; '{}' is an angle: with the input axis at that angle from the vertical, Ai = "
                             "cos(angle) and the cross axis sin(angle), in g. Add such columns",
                             excerpt(angle->text));
  return bad_data(
      {.file = header.file, .row = header.row, .column = wanted}, names_of(header),
      message("a column named {}{}; columns are separated by comma, semicolon, tab, | or blanks{}", wanted,
              renamed, advice),
      angle == nullptr ? renamings(header, column, wanted, options) : std::vector<Remedy>{});
}

// The only cell that `matches`. Empty when there is none; throws an Error when there are more.
template <typename Predicate>
std::optional<std::size_t> only(const Header& header, const std::string& wanted, Predicate matches) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < header.cells.size(); ++k) {
    if (!matches(header.cells[k])) continue;
    if (found) {
      throw bad_data({.file = header.file, .row = header.row, .column = wanted}, header.cells[k].text,
                     message("one column named {}, not a duplicate", wanted));
    }
    found = k;
  }
  return found;
}

struct FoundColumn {
  std::size_t index = 0;
  std::optional<std::string> unit;
};

// The unit said in a renaming; the header's where none is said. Throws when both are units that differ.
std::optional<std::string> agreed_unit(const Header& header, std::size_t index,
                                       const std::optional<std::string>& said) {
  const std::optional<std::string>& own = header.cells[index].unit;
  if (!said) return own;
  const auto known = own ? find_unit(*own) : std::nullopt;
  const auto other = find_unit(*said);
  if (known && other && known->symbol != other->symbol) {
    throw bad_data({.file = header.file, .row = header.row, .column = header.cells[index].text}, *said,
                   message("the unit that the file states, {}", *own));
  }
  return said;
}

// The column of the file that a renaming asks for: by its whole header, its name, its position; the unit may
// be said besides where the header does not.
std::optional<FoundColumn> find_renamed(const Header& header, const std::string& asked) {
  const std::string wanted = plain_characters(asked);
  auto index = only(header, wanted, [&](const HeaderCell& cell) { return cell.text == wanted; });
  if (!index) index = only(header, wanted, [&](const HeaderCell& cell) { return cell.name == wanted; });
  if (index) return FoundColumn{*index, header.cells[*index].unit};
  const auto bracket = wanted.ends_with(']') ? wanted.rfind('[') : std::string::npos;
  std::optional<std::string> unit;
  std::string name = wanted;
  if (bracket != std::string::npos) {
    unit = wanted.substr(bracket + 1, wanted.size() - bracket - 2);
    name = trim(std::string_view(wanted).substr(0, bracket), ',');
  }
  if (const auto position = position_of(name)) {
    if (*position >= header.cells.size()) return std::nullopt;
    return FoundColumn{*position, agreed_unit(header, *position, unit)};
  }
  if (!unit) return std::nullopt;
  index = only(header, name, [&](const HeaderCell& cell) { return cell.text == name; });
  if (!index)
    index = only(header, name, [&](const HeaderCell& cell) { return cell.name == name && !cell.unit; });
  return index ? std::optional(FoundColumn{*index, agreed_unit(header, *index, unit)}) : std::nullopt;
}

PlacedColumn renamed_column(const Header& header, Column column, const std::string& wanted,
                            const ReadOptions& options) {
  const auto found = find_renamed(header, wanted);
  if (!found) throw missing(header, column, wanted, options);
  return place_column(header, column, found->index, found->unit);
}

std::vector<PlacedColumn> renamed_columns(const Header& header, const ReadOptions& options) {
  std::vector<PlacedColumn> placed;
  std::set<std::size_t> taken;
  for (const auto& [name, wanted] : options.rename) {
    const auto column = find_column(name);
    if (!column) {
      throw usage_error(
          message("cannot rename to '{}'; the columns of a record are Ai, Ao, Ap, E, sigma_E, sigma_Ai, "
                  "sigma_Ao, sigma_Ap, mount, T, t",
                  name));
    }
    placed.push_back(renamed_column(header, *column, wanted, options));
    if (!taken.insert(placed.back().index).second) {
      throw usage_error(
          message("column '{}' is renamed twice", excerpt(header.cells[placed.back().index].text)));
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
    const auto is_free = [&](const HeaderCell& cell) {
      return find_column(cell.name) == column && !was_renamed(cell);
    };
    auto index = only(header, name, [&](const HeaderCell& cell) { return is_free(cell) && !cell.loose; });
    // `E_s` is the output's only when nothing else is and it can be in that unit.
    if (!index) {
      index = only(header, name, [&](const HeaderCell& cell) {
        return is_free(cell) && cell.loose && may_have_unit(column, cell.unit);
      });
    }
    if (!index) continue;
    const auto& unit = header.cells[*index].unit;
    // A column that no method needs may be something else: T[Nm].
    if ((column == Column::T || column == Column::t) && !may_have_unit(column, unit)) continue;
    placed.push_back(place_column(header, column, *index, unit));
  }
}

bool holds(const std::vector<PlacedColumn>& placed, Column column) {
  return std::any_of(placed.begin(), placed.end(),
                     [column](const PlacedColumn& p) { return p.column == column; });
}

}  // namespace

std::optional<std::size_t> position_of(std::string_view name) {
  if (!name.starts_with('#')) return std::nullopt;
  std::size_t position = 0;
  const auto [end, status] = std::from_chars(name.data() + 1, name.data() + name.size(), position);
  if (status != std::errc() || end != name.data() + name.size() || position == 0) return std::nullopt;
  return position - 1;
}

bool has_column(const Header& header, Column column, const ReadOptions& options) {
  const auto renamed = options.rename.find(std::string(column_name(column)));
  if (renamed != options.rename.end()) {
    try {
      return find_renamed(header, renamed->second).has_value();
    } catch (const Error&) {
      return true;  // two of them: lay_out says so
    }
  }
  return std::any_of(header.cells.begin(), header.cells.end(), [column](const HeaderCell& cell) {
    return find_column(cell.name) == column && (!cell.loose || may_have_unit(column, cell.unit));
  });
}

std::vector<IgnoredColumn> ignored_columns(const Header& header, const ReadOptions& options,
                                           const std::vector<PlacedColumn>& placed) {
  std::vector<IgnoredColumn> ignored;
  for (std::size_t k = 0; k < header.cells.size(); ++k) {
    const auto is_here = [k](const PlacedColumn& column) { return column.index == k; };
    if (std::any_of(placed.begin(), placed.end(), is_here)) continue;
    const auto column = find_column(header.cells[k].name);
    // Where no output is asked for, a record may have one all the same.
    if (!options.require_output && (column == Column::E || column == Column::sigma_E)) continue;
    ignored.push_back({.header = header.cells[k].text, .nearest = name_meant(header.cells[k].name)});
  }
  return ignored;
}

std::vector<PlacedColumn> place_columns(const Header& header, const ReadOptions& options) {
  std::vector<PlacedColumn> placed = renamed_columns(header, options);
  add_named_columns(header, placed);
  if (!holds(placed, Column::Ai)) throw missing(header, Column::Ai, "Ai", options);
  if (options.require_output && !holds(placed, Column::E)) throw missing(header, Column::E, "E", options);
  // Where no output is needed, what stands in its place must not refuse the inputs.
  if (!options.require_output)
    std::erase_if(placed, [](const PlacedColumn& p) { return p.column == Column::E; });
  std::erase_if(placed, [&](const PlacedColumn& p) {
    const auto measured = measured_by(p.column);
    return measured && !holds(placed, *measured);
  });
  return placed;
}

std::vector<PlacedColumn> lay_out(const Header& header, const ReadOptions& options) {
  std::vector<PlacedColumn> placed = place_columns(header, options);
  settle_units(header, placed);
  return placed;
}

}  // namespace proofmass
