// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <ostream>
#include <string_view>

#include "proofmass/core/error.hpp"
#include "proofmass/files/atomic_file.hpp"
#include "proofmass/record/columns.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kFlushSize = std::size_t{1} << 16;  // bytes

struct OutputColumn {
  Column column = Column::Ai;
  const std::vector<double>* values = nullptr;  // null for mount
  double to_canonical = 1.0;                    // of the unit written
};

void append_number(std::string& text, double value) {
  if (!std::isfinite(value)) throw usage_error("the numbers of a record must be finite");
  std::array<char, 32> digits{};  // the longest number has 24 characters
  const auto [end, status] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  static_cast<void>(status);  // cannot fail: the array is large enough
  text.append(digits.data(), end);
}

// The value that gives `canonical` when it is multiplied by `factor` on reading; the nearest quotient if
// there is none.
double in_unit(double canonical, double factor) {
  if (factor == 1.0) return canonical;
  const double quotient = canonical / factor;
  double below = quotient;
  double above = quotient;
  for (int step = 0; step <= 2; ++step) {
    if (below * factor == canonical) return below;
    if (above * factor == canonical) return above;
    below = std::nextafter(below, -std::numeric_limits<double>::infinity());
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
  }
  return quotient;
}

void require_one_line(const std::string& text) {
  const bool fits = std::none_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; });
  if (!fits) throw usage_error(message("text of a record must fit on one line: '{}'", text));
}

void append_label(std::string& text, const std::string& label) {
  require_one_line(label);
  const bool plain = label.find_first_of("\",;\t") == std::string::npos &&
                     (label.empty() || (label.front() != ' ' && label.back() != ' '));
  if (plain) {
    text += label;
    return;
  }
  text += '"';
  for (const char c : label) text.append(c == '"' ? 2 : 1, c);
  text += '"';
}

std::vector<OutputColumn> columns_of(const Dataset& record, RecordUnits units) {
  std::vector<OutputColumn> columns;
  for (const Column column : kColumns) {
    if (column == Column::mount) {
      if (!record.mount.empty())
        columns.push_back({.column = column, .values = nullptr, .to_canonical = 1.0});
      continue;
    }
    const auto& values = numbers(record, column);
    if (values.empty()) continue;
    const double factor = units == RecordUnits::declared ? unit_of(record, column).to_canonical : 1.0;
    columns.push_back({.column = column, .values = &values, .to_canonical = factor});
  }
  if (columns.empty() || columns.front().column != Column::Ai)
    throw usage_error("a record needs the column Ai");
  return columns;
}

std::string header_of(const Dataset& record, const std::vector<OutputColumn>& columns,
                      const WriteOptions& options) {
  std::string text;
  for (const std::string& comment : options.comments) {
    require_one_line(comment);
    text += "# " + comment + "\n";
  }
  for (const OutputColumn& c : columns) {
    if (&c != &columns.front()) text += ',';
    text += column_name(c.column);
    if (c.column == Column::mount) continue;
    const Unit& unit = unit_of(record, c.column);
    text += "[" + (options.units == RecordUnits::declared ? unit.symbol : unit.canonical_symbol()) + "]";
  }
  return text + "\n";
}

void append_row(std::string& text, const Dataset& record, const std::vector<OutputColumn>& columns,
                std::size_t row) {
  for (const OutputColumn& c : columns) {
    if (&c != &columns.front()) text += ',';
    if (c.values == nullptr) {
      append_label(text, record.mount[row]);
    } else {
      append_number(text, in_unit((*c.values)[row], c.to_canonical));
    }
  }
  text += '\n';
}

}  // namespace

void write_record(std::ostream& out, const Dataset& record, const WriteOptions& options) {
  const std::vector<OutputColumn> columns = columns_of(record, options.units);
  std::string text = header_of(record, columns, options);
  for (std::size_t row = 0; row < record.rows(); ++row) {
    append_row(text, record, columns, row);
    if (text.size() < kFlushSize) continue;
    out << text;
    text.clear();
  }
  out << text;
}

void write_record(const std::filesystem::path& path, const Dataset& record, const WriteOptions& options) {
  AtomicFile file(path);
  write_record(file.stream(), record, options);
  file.commit();
}

}  // namespace proofmass
