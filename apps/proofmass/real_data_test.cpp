// SPDX-License-Identifier: Apache-2.0
// Records that nobody simulated, read where they are.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "support/command_line.hpp"
#include "support/nist.hpp"
#include "support/reference_data.hpp"
#include "support/temporary_folder.hpp"

namespace proofmass::test {
namespace {

using RealData = CommandLine;

// A column of a table whose first row names the columns.
std::vector<double> column(const std::vector<std::vector<std::string>>& table, const std::string& name) {
  const auto at = std::find(table[0].begin(), table[0].end(), name) - table[0].begin();
  std::vector<double> values;
  for (std::size_t row = 1; row < table.size(); ++row) {
    values.push_back(std::stod(table[row].at(static_cast<std::size_t>(at))));
  }
  return values;
}

// Each axis of a MEMS triad in turn as the input axis. With plus and minus one unit along three orthogonal
// axes the columns of the linear model are orthogonal, so least squares are plain means and half differences.
TEST_F(RealData, IdentifiesEveryAxisOfALabelledTriad) {
  const auto path = reference_data("positions/imucal_ferraris_6pos.csv");
  if (!path) GTEST_SKIP() << kNoReferenceData;
  const std::array<std::string, 3> axes{"x", "y", "z"};
  const auto table = cells(read_file(*path));
  ASSERT_EQ(table.size(), 7U);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string map = fmt::format("Ai=ref_g{0},Ao=ref_g{1},Ap=ref_g{2},E=a{0}_raw[counts]", axes[k],
                                        axes[(k + 1) % 3], axes[(k + 2) % 3]);
    const Outcome fit = proofmass({"identify", path->string(), "--map", map, "--model", "linear", "--split",
                                   "1", "--json", at("r.json")});
    ASSERT_EQ(fit.exit_code, 0) << fit.err;
    EXPECT_NE(fit.out.find("Referred to input"), std::string::npos);
    const Json result = read_json("r.json");
    const auto value = [&result](std::size_t c) { return result["coefficients"][c]["value"].get<double>(); };
    const std::vector<double> raw = column(table, "a" + axes[k] + "_raw");
    const double mean = std::accumulate(raw.begin(), raw.end(), 0.0) / 6;
    const auto half_difference = [&](std::size_t axis) { return (raw[2 * axis] - raw[2 * axis + 1]) / 2; };
    EXPECT_EQ(result["coefficients"][1]["unit"], "counts/g");
    EXPECT_NEAR(value(0), mean, 1e-9);
    EXPECT_NEAR(value(1), half_difference(k), 1e-9);
    EXPECT_NEAR(value(2), half_difference((k + 1) % 3), 1e-9);
    EXPECT_NEAR(value(3), half_difference((k + 2) % 3), 1e-9);
    EXPECT_EQ(result["input_referred"][0]["unit"], "g");
    EXPECT_EQ(result["units"]["output"], "counts");
  }
}

TEST_F(RealData, ReproducesTheCertifiedLoadCellThroughMap) {
  const auto path = reference_data("nist/linear/Pontius.dat");
  if (!path) GTEST_SKIP() << kNoReferenceData;
  const NistProblem pontius = read_nist(*path);
  std::string text = "deflection;load\n";
  for (std::size_t row = 0; row < pontius.y.size(); ++row) {
    text += fmt::format("{};{}\n", pontius.y[row], pontius.x[0][row]);
  }
  const Outcome fit = proofmass({"identify", write("pontius.csv", text), "--map", "Ai=load,E=deflection",
                                 "--terms", "K0,Ki,Kii", "--split", "1", "--json", "-"});
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  const Json result = Json::parse(fit.out);
  for (std::size_t k = 0; k < 3; ++k) {
    const Json& coefficient = result["coefficients"][k];
    EXPECT_GE(correct_digits(coefficient["value"].get<double>(), pontius.certified[k]), 12.0);
    EXPECT_GE(correct_digits(coefficient["standard_error"].get<double>(), pontius.certified_sd[k]), 12.0);
  }
}

}  // namespace
}  // namespace proofmass::test
