// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/eiv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/regression/static_surface.hpp"
#include "support/process.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::Contains;
using testing::HasSubstr;

IdentifyOptions options_for(const TermList& terms, ChiSquareScaling scaling = ChiSquareScaling::given) {
  IdentifyOptions options;
  options.terms = terms;
  options.uncertainty.scaling = scaling;
  return options;
}

Identification fit(const Dataset& record, const IdentifyOptions& options) {
  SilentProgress progress;
  return identify_eiv(record, {}, options, progress);
}

Dataset noisy_twin() {
  Dataset record = test::make_twin();
  for (auto& sigma : record.acceleration_sigma) sigma.assign(record.rows(), 2e-4);
  record.output_sigma.assign(record.rows(), 3e-4);
  return record;
}

// --- Against SciPy's ODR -----------------------------------------------------------------------------------

constexpr const char* kPython = "/usr/bin/python3";

// What the reference program prints; empty where SciPy is missing.
std::string reference_output() {
  if (!std::filesystem::exists(kPython)) return {};
  if (test::run_process({.command = {kPython, "-c", "import scipy.odr"}}).exit_code != 0) return {};
  const std::string program = std::string(PROOFMASS_SOURCE_DIR) + "/tests/oracle/odr_reference.py";
  const test::Outcome outcome = test::run_process({.command = {kPython, program}});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.out;
}

Dataset record_of(const nlohmann::json& set) {
  Dataset record;
  record.source = set["name"];
  for (std::size_t axis = 0; axis < set["x"].size(); ++axis) {
    record.acceleration[axis] = set["x"][axis].get<std::vector<double>>();
    record.acceleration_sigma[axis] = set["sigma_x"][axis].get<std::vector<double>>();
  }
  record.output = set["y"].get<std::vector<double>>();
  record.output_sigma = set["sigma_y"].get<std::vector<double>>();
  return record;
}

TermList terms_of(const nlohmann::json& set) {
  std::string names;
  for (const std::string name : set["terms"]) names += (names.empty() ? "" : ",") + name;
  return parse_terms(names);
}

TEST(Eiv, AgreesWithScipyOdr) {
  const std::string output = reference_output();
  if (output.empty()) GTEST_SKIP() << "no SciPy for " << kPython << " (Debian package python3-scipy)";
  const auto sets = nlohmann::json::parse(output);
  ASSERT_EQ(sets.size(), 5U);
  for (const auto& set : sets) {
    SCOPED_TRACE(set["name"].get<std::string>());
    const Dataset record = record_of(set);
    const auto given = fit(record, options_for(terms_of(set)));
    const auto scaled = fit(record, options_for(terms_of(set), ChiSquareScaling::scaled));
    ASSERT_EQ(given.coefficients.size(), set["beta"].size());
    for (std::size_t k = 0; k < given.coefficients.size(); ++k) {
      const double beta = set["beta"][k];
      const double sd = set["sd_beta"][k];
      const double unscaled = std::sqrt(set["cov_beta"][k][k].get<double>());
      EXPECT_NEAR(given.coefficients[k].value, beta, 1e-6 * std::abs(beta))
          << name(given.coefficients[k].term);
      EXPECT_EQ(given.coefficients[k].value, scaled.coefficients[k].value);
      EXPECT_NEAR(*given.coefficients[k].standard_error, unscaled, 1e-6 * unscaled);
      EXPECT_NEAR(*scaled.coefficients[k].standard_error, sd, 1e-6 * sd);
    }
    EXPECT_NEAR(given.history.at(0).values.back(), set["sum_square"].get<double>(),
                1e-6 * set["sum_square"].get<double>());
  }
}

// --- The model's surface -----------------------------------------------------------------------------------

TEST(StaticSurface, IsTheModelAndItsDerivatives) {
  const TermList terms = parse_terms("full");
  std::vector<double> coefficients;
  for (std::size_t k = 0; k < terms.size(); ++k) coefficients.push_back(0.3 + 0.1 * static_cast<double>(k));
  const StaticModel model{.terms = terms, .coefficients = coefficients};
  const StaticSurface surface(terms, {Axis::input, Axis::output, Axis::pendulous});
  SurfaceBlock block(3, terms.size());
  const std::array<Acceleration, 3> points{Acceleration{1.5, -0.7, 0.4}, {-2.0, 0.3, 1.1}, {0.0, 0.5, -0.6}};
  for (std::size_t r = 0; r < points.size(); ++r) {
    block.x(r, 0) = points[r].i;
    block.x(r, 1) = points[r].o;
    block.x(r, 2) = points[r].p;
  }
  surface.evaluate(coefficients, points.size(), block);
  for (std::size_t r = 0; r < points.size(); ++r) {
    const Acceleration& a = points[r];
    EXPECT_NEAR(block.value[r], model.output(a), 1e-13);
    constexpr double h = 3e-8;
    EXPECT_NEAR(block.by_input(r, 0),
                (model.output({a.i + h, a.o, a.p}) - model.output({a.i - h, a.o, a.p})) / (2 * h), 1e-7);
    EXPECT_NEAR(block.by_input(r, 1),
                (model.output({a.i, a.o + h, a.p}) - model.output({a.i, a.o - h, a.p})) / (2 * h), 1e-7);
    EXPECT_NEAR(block.by_input(r, 2),
                (model.output({a.i, a.o, a.p + h}) - model.output({a.i, a.o, a.p - h})) / (2 * h), 1e-7);
    for (std::size_t k = 0; k < terms.size(); ++k) {
      EXPECT_NEAR(block.by_parameter(r, k), regressor(terms[k], a), 1e-14) << name(terms[k]);
    }
  }
}

// --- What it says and refuses ------------------------------------------------------------------------------

void expect_refusal(const Dataset& record, const IdentifyOptions& options, const std::string& advice) {
  try {
    (void)fit(record, options);
    ADD_FAILURE() << "no refusal";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr(advice));
  }
}

TEST(Eiv, RefusesWithoutUncertaintiesSayingWhatToGive) {
  const IdentifyOptions options = options_for(parse_terms("quadratic"));
  Dataset record = noisy_twin();
  record.output_sigma.clear();
  expect_refusal(record, options, "a column sigma_E in the record, or --sigma-output-ug");
  record = noisy_twin();
  for (auto& sigma : record.acceleration_sigma) sigma.assign(record.rows(), 0.0);
  expect_refusal(record, options, "columns sigma_Ai, sigma_Ao, sigma_Ap in the record, or --sigma-input-ug");
  Dataset bare = record;
  bare.output_sigma.clear();
  expect_refusal(bare, options,
                 "--sigma-output-ug, referred to the input; and the uncertainty of at least one input");
  // An axis that no term uses does not count.
  record.acceleration_sigma[1].assign(record.rows(), 1e-4);
  expect_refusal(record, options_for(parse_terms("K0,Ki,Kii")), "that the model uses");
}

TEST(Eiv, NamesTheRowWhoseOutputIsSaidToBeExact) {
  Dataset record = noisy_twin();
  record.output_sigma[17] = 0.0;
  try {
    (void)fit(record, options_for(parse_terms("linear")));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_THAT(error.what(), HasSubstr("18"));
    EXPECT_THAT(error.what(), HasSubstr("sigma_E"));
  }
}

TEST(Eiv, ConstantsStandForColumns) {
  const Dataset record = noisy_twin();
  IdentifyOptions options = options_for(parse_terms("paper"));
  const Identification by_columns = fit(record, options);
  options.uncertainty.input = 2e-4;
  options.uncertainty.output = 3e-4 / 0.999979;
  const Identification by_constants = fit(record, options);
  for (std::size_t k = 0; k < by_columns.coefficients.size(); ++k) {
    const double error = *by_columns.coefficients[k].standard_error;
    EXPECT_NEAR(by_constants.coefficients[k].value, by_columns.coefficients[k].value, 1e-4 * error);
    EXPECT_NEAR(*by_constants.coefficients[k].standard_error, error, 1e-4 * error);
  }
  EXPECT_THAT(by_constants.diagnostics.notes, Contains(HasSubstr("takes the place of the record's sigma_E")));
  EXPECT_THAT(by_columns.diagnostics.notes, Contains(HasSubstr("independent from row to row")));
  EXPECT_EQ(by_columns.ending.status, EndingStatus::converged);
}

TEST(Eiv, RefusesWithTooFewIterations) {
  IdentifyOptions options = options_for(parse_terms("paper"));
  options.uncertainty.iterations = 1;
  Dataset record = noisy_twin();
  for (double& value : record.acceleration[0]) value += 0.05 * std::sin(1e3 * value);
  for (auto& sigma : record.acceleration_sigma) sigma.assign(record.rows(), 0.05);
  expect_refusal(record, options, "--eiv-iterations");
}

}  // namespace
}  // namespace proofmass
