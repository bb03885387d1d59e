// SPDX-License-Identifier: Apache-2.0
// Records as loggers, spreadsheets and laboratories write them, read where they are. records/reference.csv
// holds what most of them hold.
#include <gtest/gtest.h>

#include <cctype>
#include <ostream>
#include <string>
#include <vector>

#include "support/command_line.hpp"
#include "support/reference_data.hpp"

namespace proofmass::test {
namespace {

struct RecordCase {
  std::string file;
  std::vector<std::string> flags{};
  double output_scale = 1.0;           // of the file's unit over V/g
  std::vector<std::string> codes{};    // findings of reading, all of them
  std::vector<std::string> refusal{};  // parts of the message; empty: read right
};

void PrintTo(const RecordCase& one, std::ostream* out) { *out << one.file; }

std::string name_of(const testing::TestParamInfo<RecordCase>& info) {
  std::string name;
  for (const char c : info.param.file) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name + "_" + std::to_string(info.index);
}

class RecordCases : public CommandLine, public testing::WithParamInterface<RecordCase> {
 protected:
  [[nodiscard]] Outcome identify(const std::string& path, const std::vector<std::string>& flags) const {
    std::vector<std::string> arguments{"identify", path, "--model", "linear",
                                       "--split",  "1",  "--json",  at("r.json")};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    return proofmass(arguments);
  }
};

TEST_P(RecordCases, AreReadRightOrRefused) {
  const auto folder = reference_data("../cases/records");
  if (!folder) GTEST_SKIP() << kNoReferenceData;
  const Outcome outcome = identify((*folder / GetParam().file).string(), GetParam().flags);
  if (!GetParam().refusal.empty()) {
    expect_failure(outcome, 3, GetParam().refusal);
    EXPECT_FALSE(exists("r.json"));
    return;
  }
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json found = read_json("r.json");
  ASSERT_EQ(identify((*folder / "reference.csv").string(), {}).exit_code, 0);
  const Json expected = read_json("r.json");
  for (std::size_t k = 0; k < 4; ++k) {
    const double value = expected["coefficients"][k]["value"].get<double>() * GetParam().output_scale;
    const double error =
        expected["coefficients"][k]["standard_error"].get<double>() * GetParam().output_scale;
    EXPECT_NEAR(found["coefficients"][k]["value"].get<double>(), value, 0.01 * error) << k;
  }
  std::vector<std::string> codes;
  for (const Json& finding : found["provenance"]["reading"]) codes.push_back(finding["code"]);
  EXPECT_EQ(codes, GetParam().codes);
}

const std::string kMark = "a meter's mark";
INSTANTIATE_TEST_SUITE_P(
    Benches, RecordCases,
    testing::Values(
        RecordCase{"units-in-parentheses.csv",
                   {"--map", "Ai=Acceleration x,Ao=Acceleration y,Ap=Acceleration z,E=Chan 201"},
                   1e3},
        RecordCase{"units-after-slash.csv", {}, 1e3},
        RecordCase{
            "units-suffix.csv",
            {},
            1e3,
            {"record_unit_in_name", "record_unit_in_name", "record_unit_in_name", "record_unit_in_name"}},
        RecordCase{"units-row.csv", {}, 1e3, {"record_units_line"}},
        RecordCase{"units-row-in-comment.csv", {}, 1e3, {"record_units_line"}},
        RecordCase{"header-in-comment.csv", {}, 1.0, {"record_header_in_comment", "record_units_assumed"}},
        RecordCase{"hash-labels.csv", {}, 1.0, {"record_labels_with_mark"}},
        RecordCase{"decimal-comma.csv", {}, 1.0, {"record_decimal_comma"}},
        RecordCase{"decimal-comma.tsv", {}, 1.0, {"record_decimal_comma"}},
        RecordCase{"decimal-comma.csv", {"--decimal", "point"}, 1.0, {}, {"decimal comma"}},
        RecordCase{"thousands-point.csv", {}, 1.0, {}, {"column 'E'", "--decimal point"}},
        RecordCase{"trailing-delimiter.csv"},
        RecordCase{"excel-blank-rows.csv", {}, 1.0, {"record_empty_rows_skipped"}},
        RecordCase{"excel-na.csv", {}, 1.0, {}, {":22: column 'Ai': found '#N/A'"}},
        RecordCase{"overload.csv", {}, 1.0, {}, {kMark, "--overload leave-out"}},
        RecordCase{"overload-word.csv", {}, 1.0, {}, {"'OVLD'", kMark, "--overload leave-out"}},
        RecordCase{"clock-column.csv", {}, 1.0, {"record_column_unusable", "record_times_converted"}},
        RecordCase{"iso-time-column.csv", {}, 1.0, {"record_times_converted"}},
        RecordCase{"gb18030.csv", {}, 1.0, {"record_decoded"}},
        RecordCase{"utf16-tab.txt", {}, 1.0, {"record_decoded"}},
        RecordCase{"cp1252.csv", {}, 1e3, {"record_decoded"}},
        RecordCase{"cp1252.csv", {"--encoding", "latin1"}, 1e3, {"record_decoded"}},
        RecordCase{"fullwidth.csv", {}, 1.0, {"record_fullwidth"}},
        RecordCase{"quoted-name-with-comma.csv", {"--map", "Ai=Specific force, X[g]"}},
        RecordCase{"quoted-name-with-comma.csv", {"--map", "Ai=#1[g]"}},
        RecordCase{"control-z.csv", {}, 1.0, {"record_end_mark"}}, RecordCase{"sep-line.csv"},
        RecordCase{"preamble.csv", {}, 1.0, {"record_preamble_skipped"}},
        RecordCase{"repeated-header.csv", {}, 1.0, {"record_headers_skipped"}}, RecordCase{"whitespace.dat"},
        RecordCase{"fortran-exponent.csv", {}, 1.0, {"record_numbers_converted"}},
        RecordCase{"unicode-minus.csv", {}, 1.0, {"record_numbers_converted"}},
        RecordCase{"unit-in-cells.csv", {}, 1.0, {"record_units_in_cells"}},
        RecordCase{"angles.csv", {}, 1.0, {}, {"Ai = cos(angle)"}}),
    name_of);

// Records that can be read and cannot be what they claim: what stands above their numbers.
struct NonsenseCase {
  std::string file;
  std::string code;
  std::string part;  // of the sentence
};

void PrintTo(const NonsenseCase& one, std::ostream* out) { *out << one.file; }

class NonsenseCases : public CommandLine, public testing::WithParamInterface<NonsenseCase> {};

TEST_P(NonsenseCases, AreWarnedOf) {
  const auto folder = reference_data("../cases/records");
  if (!folder) GTEST_SKIP() << kNoReferenceData;
  const Outcome outcome = proofmass({"identify", (*folder / GetParam().file).string(), "--model", "linear",
                                     "--wide", "--json", at("r.json")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  bool found = false;
  const Json result = read_json("r.json");
  for (const Json& finding : result["findings"]) {
    found = found || (finding["code"] == GetParam().code && finding["severity"] == "warning");
  }
  EXPECT_TRUE(found);
  // Above the table.
  const std::size_t at = outcome.out.find(GetParam().part);
  EXPECT_LT(at, outcome.out.find("std. error")) << outcome.out;
}

INSTANTIATE_TEST_SUITE_P(
    Benches, NonsenseCases,
    testing::Values(
        NonsenseCase{"no-units-but-si.csv", "scale_factor_unlike_one", "no unit is declared for E"},
        NonsenseCase{"output-in-milli-g.csv", "scale_factor_unlike_one", "E[mg]"},
        NonsenseCase{"counts-wrapped-16-bit.csv", "output_wrapped", "2^16 = 65536"},
        NonsenseCase{"sign-inverted.csv", "scale_factor_negative", "Ki is negative"},
        NonsenseCase{"axes-swapped.csv", "cross_axis_larger", "is larger than Ki"},
        NonsenseCase{"clipped.csv", "output_clipped", "lines 39, 78"},
        NonsenseCase{"stuck-output.csv", "output_held", "lines 32 to 46"},
        NonsenseCase{"warm-up-drift.csv", "residuals_follow_temperature", "the residuals follow T"}),
    [](const auto& param) { return param.param.code + "_" + std::to_string(param.index); });

// A tumble in 1 g whose inputs have three decimals.
using RoundedRecords = CommandLine;
TEST_F(RoundedRecords, NameTheTermsThatRoundingSetsApart) {
  const auto path = reference_data("../cases/records/tumble-rounded.csv");
  if (!path) GTEST_SKIP() << kNoReferenceData;
  expect_failure(proofmass({"identify", path->string(), "--model", "quadratic", "--split", "1"}), 4,
                 {"Koo is not identified: aliased with K0, Kii at the resolution of the record", "0.001 g"});
  const Outcome seen = proofmass({"inspect", path->string()});
  ASSERT_EQ(seen.exit_code, 0) << seen.err;
  EXPECT_NE(seen.out.find("Koo: aliased with K0, Kii"), std::string::npos) << seen.out;
}

// Rows that a meter marked are left out when that is asked for, and counted.
using OverloadedRecords = CommandLine;
TEST_F(OverloadedRecords, LeaveOutMarkedRows) {
  const auto folder = reference_data("../cases/records");
  if (!folder) GTEST_SKIP() << kNoReferenceData;
  for (const char* const file : {"overload.csv", "overload-word.csv"}) {
    const Outcome outcome = proofmass({"identify", (*folder / file).string(), "--model", "linear", "--split",
                                       "1", "--overload", "leave-out", "--json", at("r.json")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json result = read_json("r.json");
    EXPECT_EQ(result["metrics"]["train"]["n"], 80);
    EXPECT_NEAR(result["coefficients"][1]["value"].get<double>(), 1.25, 1e-3);
    EXPECT_EQ(result["provenance"]["reading"][0]["code"], "record_overloads_left_out");
    EXPECT_EQ(result["provenance"]["options"]["overload"], "leave-out");
  }
}

}  // namespace
}  // namespace proofmass::test
