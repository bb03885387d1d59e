// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/eiv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/regression/static_surface.hpp"
#include "support/endings.hpp"
#include "support/findings.hpp"
#include "support/process.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

Identification fitted(const Dataset& record, const TermList& terms, const Eiv& method = {}) {
  SilentProgress progress;
  return fit(method, record, {.terms = terms}, progress);
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
    const auto given = fitted(record, terms_of(set));
    const auto scaled =
        fitted(record, terms_of(set),
               {.uncertainty = {.input = {}, .output = {}, .scaling = ChiSquareScaling::scaled}});
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

// `remedies`: the options that the error says may help.
void expect_refusal(const Dataset& record, const TermList& terms, const std::string& advice,
                    const std::vector<std::string>& remedies = {}, const Eiv& method = {}) {
  try {
    (void)fitted(record, terms, method);
    ADD_FAILURE() << "no refusal";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what() + sentence(error.ending(), Language::en), HasSubstr(advice));
    std::vector<std::string> options;
    for (const Remedy& remedy : error.remedies()) options.push_back(remedy.option);
    EXPECT_EQ(options, remedies);
  }
}

TEST(Eiv, RefusesWithoutUncertaintiesSayingWhatToGive) {
  const TermList terms = parse_terms("quadratic");
  Dataset record = noisy_twin();
  record.output_sigma.clear();
  expect_refusal(record, terms, "a column sigma_E in the record, or a constant", {"sigma-output-ug"});
  record = noisy_twin();
  for (auto& sigma : record.acceleration_sigma) sigma.assign(record.rows(), 0.0);
  expect_refusal(record, terms, "columns sigma_Ai, sigma_Ao, sigma_Ap in the record, or a constant",
                 {"sigma-input-ug"});
  Dataset bare = record;
  bare.output_sigma.clear();
  expect_refusal(bare, terms, "a constant referred to the input; and the uncertainty of at least one input",
                 {"sigma-output-ug", "sigma-input-ug"});
  // An axis that no term uses does not count.
  record.acceleration_sigma[1].assign(record.rows(), 1e-4);
  expect_refusal(record, parse_terms("K0,Ki,Kii"), "that the model uses", {"sigma-input-ug"});
}

TEST(Eiv, NamesTheRowWhoseOutputIsSaidToBeExact) {
  Dataset record = noisy_twin();
  record.output_sigma[17] = 0.0;
  try {
    (void)fitted(record, parse_terms("linear"));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_THAT(error.what(), HasSubstr("18"));
    EXPECT_THAT(error.what(), HasSubstr("sigma_E"));
  }
}

Dataset points_of(std::vector<double> x, std::vector<double> sigma_x, std::vector<double> y,
                  std::vector<double> sigma_y) {
  Dataset record;
  record.acceleration = {std::move(x), std::vector<double>(y.size()), std::vector<double>(y.size())};
  record.acceleration_sigma[0] = std::move(sigma_x);
  record.output = std::move(y);
  record.output_sigma = std::move(sigma_y);
  return record;
}

// The three points of SciPy's issue 12105. Through them runs a line of any slope nearly as well as another:
// the least sum of squares over all slopes is 0.68919064 at a slope of 10.987, and it tends to 0.75382 for a
// line parallel to the output axis, where least squares (slope -0.48) leads.
TEST(Eiv, FindsTheFiniteMinimumThatLeastSquaresDoesNotLeadTo) {
  const Dataset record = points_of({30.120348566300354, 36.218214083626386, 52.86998374096616},
                                   {9.143516964542775, 13.139914563620316, 25.52829979507901},
                                   {83.47033171149137, 129.10207165602722, 85.59465198231146},
                                   {4.466601663162877, 6.1119669024770085, 23.009080364235516});
  const Identification result = fitted(record, parse_terms("K0,Ki"));
  EXPECT_NEAR(result.coefficients[0].value, -273.51, 0.01);
  EXPECT_NEAR(result.coefficients[1].value, 10.98710, 1e-4);
  EXPECT_NEAR(*result.coefficients[1].standard_error, 41.9, 0.1);
  EXPECT_NEAR(result.history.at(0).values.back(), 0.68919064, 1e-8);
  EXPECT_THAT(test::said(result.ending),
              HasSubstr("gave this, the best result: the first start ended elsewhere"));
}

// Nearly one output for opposite inputs, which are a thousandth of their uncertainty: the larger Ki, the
// better.
TEST(Eiv, ARunawayIsNotConvergence) {
  const Dataset record = points_of({1e-3, -1e-3}, {1.0, 1.0}, {10.0, 11.0}, {1.0, 1.0});
  expect_refusal(record, parse_terms("Ki"), "the coefficients grow without end");
}

TEST(Eiv, ConstantsStandForColumns) {
  const Dataset record = noisy_twin();
  const Identification by_columns = fitted(record, paper_terms());
  const Identification by_constants =
      fitted(record, paper_terms(), {.uncertainty = {.input = 2e-4, .output = 3e-4 / 0.999979}});
  for (std::size_t k = 0; k < by_columns.coefficients.size(); ++k) {
    const double error = *by_columns.coefficients[k].standard_error;
    EXPECT_NEAR(by_constants.coefficients[k].value, by_columns.coefficients[k].value, 1e-4 * error);
    EXPECT_NEAR(*by_constants.coefficients[k].standard_error, error, 1e-4 * error);
  }
  EXPECT_TRUE(test::has(by_constants, Code::sigma_output_replaced));
  EXPECT_FALSE(test::has(by_columns, Code::sigma_output_replaced));
  EXPECT_TRUE(test::has(by_columns, Code::independent_errors_assumed));
  EXPECT_EQ(by_columns.ending.status, EndingStatus::converged);
}

TEST(Eiv, RefusesWithTooFewIterations) {
  Dataset record = noisy_twin();
  for (double& value : record.acceleration[0]) value += 0.05 * std::sin(1e3 * value);
  for (auto& sigma : record.acceleration_sigma) sigma.assign(record.rows(), 0.05);
  expect_refusal(record, paper_terms(), "or the iterations too few", {"eiv-iterations"},
                 {.uncertainty = {}, .iterations = 1});
}

}  // namespace
}  // namespace proofmass
