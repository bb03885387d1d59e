// SPDX-License-Identifier: Apache-2.0
// Every bad record causes one error with the file, the row, the column, what was found and what was expected.
#include <gtest/gtest.h>

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/record/csv/csv.hpp"
#include "support/temporary_folder.hpp"

namespace proofmass {
namespace {

// The message of the bad-data error that reading throws.
std::string message_of(const std::filesystem::path& path, const ReadOptions& options = {}) {
  try {
    const Dataset record = read_record(path, options);
    ADD_FAILURE() << path << " was read: " << record.rows() << " rows";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data) << error.what();
    return error.what();
  }
  return {};
}

struct BadRecord {
  std::string name;
  std::string text;
  std::string rest;  // of the message, after the file name
  std::map<std::string, std::string> rename = {};
};

std::string name_of(const ::testing::TestParamInfo<BadRecord>& info) { return info.param.name; }

void PrintTo(const BadRecord& bad, std::ostream* out) { *out << bad.name; }

class BadRecords : public ::testing::TestWithParam<BadRecord> {};

TEST_P(BadRecords, AreNamedExactly) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("run.csv", GetParam().text);
  EXPECT_EQ(message_of(path, {.rename = GetParam().rename}), path.string() + GetParam().rest);
}

const std::string kUnitsOfAcceleration = "g, mg, ug, m/s^2, mm/s^2, cm/s^2, Gal, mGal, ft/s^2";
const std::string kNeedsHeader = "expected a header line that names the columns Ai Ao Ap E";
const std::string kSeparators = "; columns are separated by comma, semicolon, tab, | or blanks";

INSTANTIATE_TEST_SUITE_P(
    Columns, BadRecords,
    ::testing::Values(
        BadRecord{"missing_input", "Ao,E\n1,2\n",
                  ":1: column 'Ai': found 'Ao E', expected a column named Ai" + kSeparators},
        BadRecord{"missing_output", "#\nAi,Ao\n1,2\n",
                  ":2: column 'E': found 'Ai Ao', expected a column named E" + kSeparators},
        BadRecord{
            "no_header", "1,2\n3,4\n",
            ":1: found '1,2', " + kNeedsHeader + "; without one, say which column is which, and the units"},
        BadRecord{"header_below_data", "1,2\n3,4\nAi,E\n5,6\n",
                  ":3: found 'Ai,E', expected the header above all rows of numbers; line 1 looks like one"},
        BadRecord{"another_header", "Ai,E\n1,2\nE,Ai\n3,4\n",
                  ":3: found 'E,Ai', expected rows under the header of line 1; this looks like another "
                  "header: put what "
                  "follows into a file of its own"},
        BadRecord{
            "another_header_in_a_comment", "Ai[g],E[V]\n1,2\n# Ai[m/s^2],E[V]\n3,4\n",
            ":3: found '# Ai[m/s^2],E[V]', expected rows under the header of line 1; this looks like another "
            "header: put what follows into a file of its own"},
        BadRecord{"other_unit_than_the_file_states",
                  "Ai,E [mV]\n1,2\n",
                  ":1: column 'E [mV]': found 'V', expected the unit that the file states, mV",
                  {{"E", "#2[V]"}, {"Ai", "#1"}}},
        BadRecord{"a_field_missing_between_blanks", "Ai Ao E T\n1 2 3 20\n1   3 20\n",
                  ":3: found '1   3 20', expected 4 fields as in the header, not 3"},
        BadRecord{"thousands_in_every_number", "Ai;E\n1;16,384\n2;32,767\n",
                  ":2: column 'E': found '16,384', expected numbers whose comma is decimal for certain: here "
                  "each has "
                  "three digits after it or none at all, as thousands do. Take the commas out if they part "
                  "thousands"},
        BadRecord{"position_beyond",
                  "Ai,E\n1,2\n",
                  ":1: column '#3': found 'Ai E', expected a column named #3 (it was to be read as Ai)" +
                      kSeparators,
                  {{"Ai", "#3"}}},
        BadRecord{"angles", "angle[deg],E\n0,1\n1,2\n",
                  ":1: column 'Ai': found 'angle[deg] E', expected a column named Ai" + kSeparators +
                      "; 'angle[deg]' is an angle: with the input axis at that angle from the vertical, Ai = "
                      "cos(angle) "
                      "and the cross axis sin(angle), in g. Add such columns"},
        BadRecord{"missing_renamed",
                  "Ai,E\n1,2\n",
                  ":1: column 'ax': found 'Ai E', expected a column named ax (it was to be read as Ai)" +
                      kSeparators,
                  {{"Ai", "ax"}}},
        BadRecord{"renamed_away",
                  "Ai,x\n1,2\n",
                  ":1: column 'Ai': found 'Ai x', expected a column named Ai" + kSeparators,
                  {{"E", "Ai"}}},
        BadRecord{"duplicate", "Ai,Ai,E\n1,2,3\n",
                  ":1: column 'Ai': found 'Ai', expected one column named Ai, not a duplicate"},
        BadRecord{"duplicate_with_unit", "Ai,Ai[mg],E\n1,2,3\n",
                  ":1: column 'Ai': found 'Ai[mg]', expected one column named Ai, not a duplicate"},
        BadRecord{"duplicate_renamed",
                  "ax,ax,E\n1,2,3\n",
                  ":1: column 'ax': found 'ax', expected one column named ax, not a duplicate",
                  {{"Ai", "ax"}}},
        BadRecord{"unmatched_header_quote", "Ai,\"E\n1,2\n",
                  ":1: found '\"E', expected a column name with matching quotes"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Units, BadRecords,
    ::testing::Values(
        BadRecord{"unknown_unit", "Ai[parsec],E\n1,2\n",
                  ":1: column 'Ai': found '[parsec]', expected a unit among " + kUnitsOfAcceleration},
        BadRecord{"empty_unit", "Ai[],E\n1,2\n",
                  ":1: column 'Ai': found '[]', expected a unit among " + kUnitsOfAcceleration},
        BadRecord{"wrong_quantity", "Ai,Ao[mA],E\n1,2,3\n",
                  ":1: column 'Ao': found '[mA]', expected a unit among " + kUnitsOfAcceleration},
        BadRecord{"unit_of_a_label", "Ai,E,mount[g]\n1,2,a\n",
                  ":1: column 'mount': found '[g]', expected no unit"},
        BadRecord{"mixed_units", "Ai[g],Ao[m/s^2],E\n1,2,3\n",
                  ":1: column 'Ao': found 'Ao[m/s^2]', expected the unit of Ai, [g], not mixed units"},
        BadRecord{"mixed_with_default", "Ai[m/s^2],Ap,E\n1,2,3\n",
                  ":1: column 'Ap': found 'Ap', expected the unit of Ai, [m/s^2], not mixed units"},
        BadRecord{
            "mixed_sigma", "Ai,E[mA],sigma_E[uA]\n1,2,3\n",
            ":1: column 'sigma_E': found 'sigma_E[uA]', expected the unit of E, [mA], not mixed units"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Fields, BadRecords,
    ::testing::Values(
        BadRecord{"word", "Ai,E\n1,2\nabc,4\n", ":3: column 'Ai': found 'abc', expected a number"},
        BadRecord{"trailing_garbage", "Ai,E\n1,2x\n", ":2: column 'E': found '2x', expected a number"},
        BadRecord{"hexadecimal", "Ai,E\n0x10,2\n", ":2: column 'Ai': found '0x10', expected a number"},
        BadRecord{"two_signs", "Ai,E\n+-1,2\n", ":2: column 'Ai': found '+-1', expected a number"},
        BadRecord{"empty_field", "Ai,E\n1,\n", ":2: column 'E': expected a number, not an empty field"},
        BadRecord{"nan", "Ai,E\n1,NaN\n", ":2: column 'E': found 'NaN', expected a finite number"},
        BadRecord{"infinity", "Ai,E\n-inf,1\n", ":2: column 'Ai': found '-inf', expected a finite number"},
        BadRecord{"overflow", "Ai,E\n1,1e999\n",
                  ":2: column 'E': found '1e999', expected a number within the range of double precision"},
        BadRecord{
            "decimal_comma", "Ai;E\n1.5;2\n1,5;2\n",
            ":3: column 'Ai': found '1,5', expected a number with a decimal point, not a decimal comma"},
        BadRecord{"thousands", "Ai;E\n1;16.384\n2;86\n",
                  ":2: column 'E': found '16.384', expected numbers whose point is decimal for certain: here "
                  "each has "
                  "three digits after it or none at all, as thousands do. Take the points out if they part "
                  "thousands"},
        BadRecord{"overload", "Ai,E\n1,2\n1,-9.9e37\n",
                  ":3: column 'E': found '-9.9e37', expected a measured value; this is a meter's mark for "
                  "one beyond "
                  "its range"},
        BadRecord{"overload_word", "Ai,E\n1,2\nOVLD,3\n",
                  ":3: column 'Ai': found 'OVLD', expected a measured value; this is a meter's mark for one "
                  "beyond its "
                  "range"},
        BadRecord{"spreadsheet_error", "Ai,E\n1,2\n#N/A,3\n",
                  ":3: column 'Ai': found '#N/A', expected a number"},
        BadRecord{"other_unit_in_a_cell", "Ai,E\n1,2 V\n1,3 mV\n",
                  ":3: column 'E': found '3 mV', expected a number, or one in the unit of the column, V"},
        BadRecord{
            "negative_sigma", "Ai,E,sigma_E\n1,2,-0.5\n",
            ":2: column 'sigma_E': found '-0.5', expected a standard uncertainty, which is not negative"},
        BadRecord{
            "negative_quoted_sigma", "Ai,E,sigma_Ai\n1,2,\"-1\"\n",
            ":2: column 'sigma_Ai': found '\"-1\"', expected a standard uncertainty, which is not negative"},
        BadRecord{"unmatched_quote", "Ai,E,mount\n1,2,\"a\n",
                  ":2: column 'mount': found '\"a', expected a field with matching quotes"}),
    name_of);

using namespace std::string_literals;
INSTANTIATE_TEST_SUITE_P(
    Files, BadRecords,
    ::testing::Values(
        BadRecord{"empty", "", ": found 'an empty file', " + kNeedsHeader},
        BadRecord{"comments_alone", "# a\n\n",
                  ": found 'nothing but blank lines and comments', " + kNeedsHeader},
        BadRecord{"no_data_rows", "# a\nAi,E\n#b\n",
                  ":2: found 'a header alone', expected data rows below it"},
        BadRecord{"short_row", "Ai,Ao,E\n1,2,3\n4,5\n",
                  ":3: found '4,5', expected 3 fields as in the header, not 2"},
        BadRecord{"long_row", "Ai,E\n1,2,3\n",
                  ":2: found '1,2,3', expected 2 fields as in the header, not 3"},
        BadRecord{"other_separator", "Ai,E\n1;2\n",
                  ":2: found '1;2', expected 2 fields as in the header, not 1"},
        BadRecord{"nul_bytes", "Ai,E\n1,2\n1,\0\n"s,
                  ":3: found '1,\\x00', expected text without control characters, not a binary file"},
        BadRecord{"binary", "\x7f\x45LF\x02\x01\x01\x00"s,
                  ":1: found '\\x7fELF\\x02\\x01\\x01\\x00', expected text without control characters, not a "
                  "binary file"},
        BadRecord{"half_a_utf_16_character", "\xFF\xFE"s + "A\0i"s, ": expected text in UTF-16LE"},
        BadRecord{"carriage_returns_alone", "Ai,E\r1,2\r3,4\r",
                  ":1: found 'Ai,E\\x0d1,2\\x0d3,4', expected lines that end in LF or CRLF, not in CR alone"},
        BadRecord{"too_many_columns", "Ai,E" + std::string(1000, ',') + "x\n",
                  ":1: found '1002 columns', expected at most 1000 columns"}),
    name_of);

TEST(BadFiles, MissingFile) {
  EXPECT_EQ(message_of("/no/such/run.csv"), "cannot open /no/such/run.csv: no such file or directory");
}

TEST(BadFiles, Directory) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(message_of(folder.path()), "cannot open " + folder.path().string() + ": is a directory");
}

TEST(BadFiles, FileThatCannotBeRead) {
  const std::filesystem::path path =
      "/proc/self/mem";  // can be opened, but reading at address 0 fails, also for root
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  EXPECT_EQ(message_of(path),
            "/proc/self/mem: found 'Input/output error', expected a readable record (a CSV file)");
}

TEST(BadFiles, OneLineOf100Megabytes) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("run.csv", "Ai,E\n" + std::string(100'000'000, '7'));
  EXPECT_EQ(message_of(path), path.string() + ":2: found '" + std::string(60, '7') +
                                  "...', expected lines of at most 1048576 bytes");
}

TEST(BadFiles, AnEndlessLineEndsAtTheLimit) {
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "no /dev/zero";
  EXPECT_TRUE(message_of("/dev/zero").ends_with("expected lines of at most 1048576 bytes"));
}

}  // namespace
}  // namespace proofmass
