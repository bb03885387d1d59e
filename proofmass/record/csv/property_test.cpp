// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/record/csv/csv.hpp"
#include "proofmass/record/csv/lenient.hpp"
#include "proofmass/record/csv/writer.hpp"
#include "support/temporary_folder.hpp"

namespace proofmass {
namespace {

using Column = std::vector<double>;

// Doubles of every magnitude below the marks of meters, including subnormal numbers and both zeros.
rc::Gen<double> any_double() {
  return rc::gen::suchThat(rc::gen::map(rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>()),
                                        [](std::uint64_t bits) { return std::bit_cast<double>(bits); }),
                           [](double value) { return std::abs(value) < kOverload; });
}

Column any_column(std::size_t rows) { return *rc::gen::container<Column>(rows, any_double()); }

Column magnitudes(Column values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

std::vector<std::uint64_t> bits(const Column& values) {
  std::vector<std::uint64_t> list;
  for (const double value : values) list.push_back(std::bit_cast<std::uint64_t>(value));
  return list;
}

Dataset any_record() {
  const auto rows = *rc::gen::inRange<std::size_t>(1, 20);
  Dataset record;
  record.acceleration[0] = any_column(rows);
  if (*rc::gen::arbitrary<bool>()) record.acceleration[1] = any_column(rows);
  if (*rc::gen::arbitrary<bool>()) record.acceleration_sigma[0] = magnitudes(any_column(rows));
  record.output = any_column(rows);
  if (*rc::gen::arbitrary<bool>()) record.output_sigma = magnitudes(any_column(rows));
  if (*rc::gen::arbitrary<bool>()) {
    const auto label = rc::gen::container<std::string>(rc::gen::elementOf(std::string("aB1 ,;\t\"#'[]")));
    record.mount = *rc::gen::container<std::vector<std::string>>(rows, label);
  }
  if (*rc::gen::arbitrary<bool>()) record.time = any_column(rows);
  record.output_unit = *find_unit(*rc::gen::elementOf(std::vector<std::string>{"g", "mg", "mA", "counts"}));
  return record;
}

std::string written(const Dataset& record, const WriteOptions& options = {}) {
  std::ostringstream out;
  write_record(out, record, options);
  return out.str();
}

RC_GTEST_PROP(Record, ReadsBackTheSameBits, ()) {
  const Dataset record = any_record();
  const test::TemporaryFolder folder;
  write_record(folder.path() / "run.csv", record, {.comments = {"a comment", "Ai,E"}});
  const Dataset back = read_record(folder.path() / "run.csv");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    RC_ASSERT(bits(back.acceleration[axis]) == bits(record.acceleration[axis]));
    RC_ASSERT(bits(back.acceleration_sigma[axis]) == bits(record.acceleration_sigma[axis]));
  }
  RC_ASSERT(bits(back.output) == bits(record.output));
  RC_ASSERT(bits(back.output_sigma) == bits(record.output_sigma));
  RC_ASSERT(bits(back.time) == bits(record.time));
  RC_ASSERT(back.mount == record.mount);
  RC_ASSERT(written(back) == written(record));
}

// A record read in other units keeps its bits when it is written in these units and read again.
RC_GTEST_PROP(Record, DeclaredUnitsKeepTheBitsOfWhatWasRead, ()) {
  const auto symbol =
      *rc::gen::elementOf(std::vector<std::string>{"mg", "ug", "m/s^2", "mm/s^2", "mGal", "ft/s^2"});
  const auto values = *rc::gen::nonEmpty(rc::gen::arbitrary<std::vector<std::int64_t>>());
  std::string text = "Ai[" + symbol + "],E[" + symbol + "]\n";
  for (const auto value : values) text += std::to_string(value) + "," + std::to_string(value) + ".125\n";
  const test::TemporaryFolder folder;
  const Dataset record = read_record(folder.write("run.csv", text));
  write_record(folder.path() / "again.csv", record, {.units = RecordUnits::declared});
  const Dataset back = read_record(folder.path() / "again.csv");
  RC_ASSERT(back.acceleration_unit.symbol == symbol);
  RC_ASSERT(bits(back.acceleration[0]) == bits(record.acceleration[0]));
  RC_ASSERT(bits(back.output) == bits(record.output));
}

RC_GTEST_PROP(Record, SeparatorsAndLineEndsDoNotMatter, ()) {
  const auto rows = *rc::gen::inRange<std::size_t>(1, 20);
  const Column inputs = any_column(rows);
  const Column outputs = any_column(rows);
  const auto separator = *rc::gen::elementOf(std::string(",;\t"));
  const auto line_end = *rc::gen::elementOf(std::vector<std::string>{"\n", "\r\n"});
  const auto padding = *rc::gen::elementOf(std::vector<std::string>{"", " ", "   "});
  std::ostringstream text;
  text.precision(17);
  text << "Ai" << padding << separator << padding << "E" << line_end;
  for (std::size_t k = 0; k < rows; ++k)
    text << inputs[k] << padding << separator << padding << outputs[k] << line_end;
  const test::TemporaryFolder folder;
  const Dataset record = read_record(folder.write("run.csv", text.str()));
  RC_ASSERT(bits(record.acceleration[0]) == bits(inputs));
  RC_ASSERT(bits(record.output) == bits(outputs));
}

// Whatever the bytes, reading returns a record or throws an Error.
void read_or_refuse(const std::string& bytes) {
  const test::TemporaryFolder folder;
  try {
    const Dataset record = read_record(folder.write("run.csv", bytes));
    RC_ASSERT(record.rows() > 0U);
    for (const Column* column : {&record.acceleration[0], &record.output, &record.output_sigma}) {
      RC_ASSERT(column->empty() || column->size() == record.rows());
      for (const double value : *column) RC_ASSERT(std::isfinite(value));
    }
  } catch (const Error& error) {
    RC_ASSERT(error.kind() == ErrorKind::bad_data);
  }
}

RC_GTEST_PROP(Record, RandomBytesAreReadOrRefused, (const std::string& bytes)) {
  read_or_refuse(bytes);
  read_or_refuse("Ai,E,sigma_E,mount\n1,2,3,a\n" + bytes);
}

RC_GTEST_PROP(Record, AlmostRecordsAreReadOrRefused, ()) {
  const auto piece = rc::gen::elementOf(std::vector<std::string>{
      "Ai",   "E",     "Ao",  "sigma_E", "mount", "[g]",          "[mA]", ",",    ",", ",",
      ";",    "\t",    "\n",  "\n",      "\r\n",  "\r",           "\"",   "\"\"", "#", "1",
      "-2.5", "1e400", "nan", " ",       "+",     "\xEF\xBB\xBF", "\xFF"});
  const auto pieces = *rc::gen::container<std::vector<std::string>>(piece);
  std::string tail;
  for (const std::string& p : pieces) tail += p;
  read_or_refuse("Ai,E" + tail);
  read_or_refuse("Ai,E,sigma_E,mount\n" + tail);
}

}  // namespace
}  // namespace proofmass
