// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/csv.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/record/csv/fields.hpp"
#include "proofmass/record/csv/layout.hpp"
#include "proofmass/record/csv/lenient.hpp"
#include "proofmass/record/csv/lines.hpp"
#include "proofmass/record/csv/notes.hpp"
#include "proofmass/record/csv/preamble.hpp"
#include "proofmass/record/csv/rows.hpp"
#include "proofmass/record/csv/units.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kMostExpected = std::size_t{1} << 24;  // most rows to reserve memory for in advance

// Reads the chunks of a file by several threads, and joins their rows in the order of the file.
class RowReader {
 public:
  RowReader(ChunkReader& chunks, const RowFormat& format) : chunks_(chunks), format_(format) {}

  // The rows from a byte of the first chunk on. Throws what goes wrong first in the order of the file.
  RowBlock read(const Chunk& first, std::size_t begin, std::size_t line, std::size_t threads) {
    RowParser rows(format_, all_);
    rows.parse(std::string_view(first.text).substr(begin), line);
    // Memory in advance, with a small margin, avoids copies of the columns as they grow.
    const double expected = 1.05 * chunks_.growth() * static_cast<double>(all_.rows.line.size());
    rows.reserve(std::min(static_cast<std::size_t>(expected), kMostExpected));
    std::vector<std::jthread> helpers;
    const auto chunks = static_cast<std::size_t>(chunks_.growth());
    try {
      for (std::size_t k = 1; k < std::min(threads, chunks); ++k) helpers.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      // The system gives no more threads: those there are will do.
    }
    work();
    helpers.clear();  // waits for them
    if (failure_) std::rethrow_exception(failure_);
    return std::move(all_);
  }

 private:
  // The next chunk and its number; empty when there is none, or when something went wrong.
  std::optional<std::pair<Chunk, std::size_t>> take() {
    const std::lock_guard lock(taking_);
    if (stopped_) return std::nullopt;
    try {
      if (auto chunk = chunks_.next()) return std::pair(std::move(*chunk), taken_++);
    } catch (...) {
      fail(taken_);
    }
    stopped_ = true;
    return std::nullopt;
  }

  // Keeps the error of the chunk that comes first in the file.
  void fail(std::size_t number) {
    const std::lock_guard lock(joining_);
    if (!failure_ || number < failed_) {
      failure_ = std::current_exception();
      failed_ = number;
    }
  }

  void stop() {
    const std::lock_guard lock(taking_);
    stopped_ = true;
  }

  void join(std::size_t number, RowBlock&& block) {
    const std::lock_guard lock(joining_);
    waiting_.emplace(number, std::move(block));
    for (auto next = waiting_.find(joined_); next != waiting_.end(); next = waiting_.find(joined_)) {
      all_.append(std::move(next->second));
      waiting_.erase(next);
      ++joined_;
    }
  }

  void work() {
    while (auto taken = take()) {
      try {
        RowBlock block;
        RowParser rows(format_, block);
        rows.reserve(taken->first.lines);
        rows.parse(taken->first.text, taken->first.first_line);
        join(taken->second, std::move(block));
      } catch (...) {
        fail(taken->second);
        stop();
      }
    }
  }

  ChunkReader& chunks_;
  const RowFormat& format_;
  std::mutex taking_;   // guards chunks_, taken_, stopped_
  std::mutex joining_;  // guards all that follows
  std::size_t taken_ = 0;
  bool stopped_ = false;
  RowBlock all_;
  std::map<std::size_t, RowBlock> waiting_;
  std::size_t joined_ = 0;
  std::exception_ptr failure_;
  std::size_t failed_ = 0;
};

// Whether the numbers of the first chunk have decimal commas: then none has a point.
bool has_decimal_commas(const Chunk& chunk, const Preamble& preamble,
                        const std::vector<PlacedColumn>& placed) {
  const Separation& separation = preamble.header.separation;
  bool comma = false;
  bool point = false;
  for_each_line(std::string_view(chunk.text).substr(preamble.data_begin), preamble.data_line,
                [&](std::string_view line, std::size_t) {
                  const std::string marked = separated_by_marks(line, separation);
                  const auto fields = split_fields(marked, separation.mark);
                  for (const PlacedColumn& p : placed) {
                    const bool measured =
                        p.column != Column::mount && p.column != Column::t && p.column != Column::T;
                    if (!measured || p.index >= fields.size()) continue;
                    const std::string field = unquoted(fields[p.index]).value_or("");
                    if (!looks_like_number(field)) continue;
                    comma = comma || field.find(',') != std::string::npos;
                    point = point || field.find('.') != std::string::npos;
                  }
                  return !point;
                });
  return comma && !point;
}

bool uses_decimal_comma(const ReadOptions& options, const Chunk& chunk, const Preamble& preamble,
                        const std::vector<PlacedColumn>& placed) {
  if (options.decimal != DecimalMark::automatic) return options.decimal == DecimalMark::comma;
  return has_decimal_commas(chunk, preamble, placed);
}

// A column without a unit whose first cell has one: "-3.65 V".
void take_cell_units(const Chunk& chunk, Preamble& preamble, const std::vector<PlacedColumn>& placed) {
  for_each_line(std::string_view(chunk.text).substr(preamble.data_begin), preamble.data_line,
                [&](std::string_view line, std::size_t) {
                  const std::string marked = separated_by_marks(line, preamble.header.separation);
                  const auto fields = split_fields(marked, preamble.header.separation.mark);
                  if (line.starts_with('#') || fields.size() < placed.size()) return true;
                  for (const PlacedColumn& p : placed) {
                    if (p.declared || p.column == Column::mount || p.index >= fields.size()) continue;
                    const std::string field = unquoted(fields[p.index]).value_or("");
                    LenientNumber number = read_lenient(field, false);
                    if (number.fault != NumberFault::none) number = read_lenient(field, true);
                    if (number.fault == NumberFault::none && !number.unit.empty())
                      preamble.header.cells[p.index].unit = number.unit;
                  }
                  return false;
                });
}

std::optional<Encoding> asked_encoding(const ReadOptions& options) {
  if (options.encoding.empty()) return std::nullopt;
  const auto encoding = find_encoding(options.encoding);
  if (!encoding) {
    throw usage_error(message("encoding: {}", message("found '{}', expected {}", excerpt(options.encoding),
                                                      message("one of {}", known_encodings()))));
  }
  return encoding;
}

void declare_units(Dataset& record, const std::vector<PlacedColumn>& placed) {
  for (const PlacedColumn& p : placed) {
    if (p.column == Column::mount || measured_by(p.column)) continue;
    unit_of(record, p.column) = p.unit;
    if (p.column == Column::E) record.output_unit_declared = p.declared;
    if (p.column == Column::Ai) record.acceleration_unit_declared = p.declared;
  }
}

}  // namespace

Dataset read_record(const std::filesystem::path& path, const ReadOptions& options) {
  SilentProgress nobody;
  return read_record(path, options, nobody);
}

Dataset read_record(const std::filesystem::path& path, const ReadOptions& options, Progress& progress) {
  ChunkReader chunks(path, asked_encoding(options), progress);
  const auto first = chunks.next();
  if (!first) {
    throw bad_data({.file = chunks.name()}, "an empty file", expected_header());
  }
  Preamble preamble = read_preamble(chunks.name(), *first, options);
  take_cell_units(*first, preamble, place_columns(preamble.header, options));
  RowFormat format{.header = preamble.header, .placed = lay_out(preamble.header, options)};
  format.decimal_comma = uses_decimal_comma(options, *first, preamble, format.placed);
  format.leave_out_overloads = options.overload == OverloadPolicy::leave_out;

  RowReader reader(chunks, format);
  RowBlock block = reader.read(*first, preamble.data_begin, preamble.data_line, options.threads);
  Dataset record = std::move(block.rows);
  record.source = chunks.name();
  if (record.rows() == 0) {
    throw bad_data({.file = format.header.file, .row = format.header.row, .column = {}}, "a header alone",
                   "data rows below it");
  }
  declare_units(record, format.placed);
  settle_optional_columns(record, block.notes);
  settle_decimals(record, format, block.notes, options);
  record.ignored = ignored_columns(format.header, options, format.placed);
  add_reading_findings(record, chunks, preamble, format, block.notes);
  record.source_sha256 = chunks.sha256();
  return record;
}

}  // namespace proofmass
