// SPDX-License-Identifier: Apache-2.0
#include "proofmass/pipeline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "proofmass/assess/metrics.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/core/version.hpp"
#include "proofmass/report/json/json.hpp"
#include "proofmass/report/text/en.hpp"
#include "proofmass/split.hpp"
#include "support/findings.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::Contains;
using testing::Pair;
using testing::StartsWith;

std::vector<std::size_t> together(const Split& split) {
  std::vector<std::size_t> rows = split.training;
  rows.insert(rows.end(), split.validation.begin(), split.validation.end());
  rows.insert(rows.end(), split.test.begin(), split.test.end());
  std::sort(rows.begin(), rows.end());
  return rows;
}

RC_GTEST_PROP(SplitRows, PutsEveryRowInOnePart, ()) {
  const auto rows = *rc::gen::inRange<std::size_t>(10, 500);
  const double fraction = *rc::gen::inRange(30, 101) / 100.0;
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const double validation = *rc::gen::element(0.0, 0.15);
  const SplitOptions options{.training_fraction = fraction, .validation_fraction = validation};
  const Split split = split_rows(rows, options, seed);

  std::vector<std::size_t> all(rows);
  std::iota(all.begin(), all.end(), std::size_t{0});
  RC_ASSERT(together(split) == all);
  for (const auto* part : {&split.training, &split.validation, &split.test}) {
    RC_ASSERT(std::is_sorted(part->begin(), part->end()));
  }
  const auto n = static_cast<double>(rows);
  const auto count = [n](double part) { return static_cast<std::size_t>(std::llround(part * n)); };
  RC_ASSERT(split.training.size() + split.validation.size() == count(fraction));
  RC_ASSERT(split.validation.size() == count(validation));

  SplitOptions other = options;
  other.validation_fraction = 0.15 - validation;
  const Split again = split_rows(rows, other, seed);
  RC_ASSERT(again.test == split.test);
}

TEST(SplitRows, ValidationRowsComeOutOfTheTrainingRows) {
  const Split without = split_rows(200, {}, 5);
  const Split with = split_rows(200, {.validation_fraction = 0.15}, 5);
  EXPECT_EQ(without.training.size(), 140U);
  EXPECT_TRUE(without.validation.empty());
  EXPECT_EQ(with.training.size(), 110U);
  EXPECT_EQ(with.validation.size(), 30U);
  const auto& pool = without.training;
  EXPECT_TRUE(std::includes(pool.begin(), pool.end(), with.validation.begin(), with.validation.end()));
  EXPECT_TRUE(std::includes(pool.begin(), pool.end(), with.training.begin(), with.training.end()));
}

TEST(SplitRows, DependsOnTheSeed) {
  EXPECT_EQ(split_rows(100, {}, 1).test, split_rows(100, {}, 1).test);
  EXPECT_NE(split_rows(100, {}, 1).test, split_rows(100, {}, 2).test);
}

TEST(SplitRows, AFractionOfOneTakesAllRows) {
  const Split split = split_rows(31, {.training_fraction = 1.0}, 1);
  EXPECT_EQ(split.training.size(), 31U);
  EXPECT_TRUE(split.test.empty());
}

std::vector<std::string> labels(std::size_t rows, std::size_t mounts) {
  std::vector<std::string> names;
  for (std::size_t row = 0; row < rows; ++row) names.push_back("M" + std::to_string(row * row % mounts));
  return names;
}

RC_GTEST_PROP(SplitMounts, KeepsTheRowsOfAMountTogether, ()) {
  const auto rows = *rc::gen::inRange<std::size_t>(30, 300);
  const std::vector<std::string> mounts = labels(rows, *rc::gen::inRange<std::size_t>(11, 25));
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const double validation = *rc::gen::element(0.0, 0.15);
  const Split split = split_mounts(mounts, {.validation_fraction = validation}, seed);
  std::vector<std::size_t> all(rows);
  std::iota(all.begin(), all.end(), std::size_t{0});
  RC_ASSERT(together(split) == all);
  std::map<std::string, int> part_of;
  for (const auto* part : {&split.training, &split.validation, &split.test}) {
    const int number = part == &split.training ? 1 : part == &split.test ? 2 : 3;
    for (const std::size_t row : *part) {
      int& own = part_of[mounts[row]];
      RC_ASSERT(own == 0 || own == number);
      own = number;
    }
  }
  RC_ASSERT(!split.training.empty() && !split.test.empty());
  RC_ASSERT(split.validation.empty() == (validation == 0.0));
  // The test part is the same for every method.
  RC_ASSERT(split_mounts(mounts, {}, seed).test == split.test);
  RC_ASSERT(split_mounts(mounts, {.training_fraction = 1.0}, seed).training.size() == rows);
}

// A mount with most of the rows moves no row of the test part.
RC_GTEST_PROP(SplitMounts, SeesTheSameTestRowsBesideADominantMount, ()) {
  const auto rows = *rc::gen::inRange<std::size_t>(30, 300);
  const auto mounts = *rc::gen::inRange<std::size_t>(3, 12);
  std::vector<std::string> names;
  for (std::size_t row = 0; row < rows; ++row)
    names.push_back("M" + std::to_string(row < rows * 7 / 10 ? 0 : row % mounts));
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const Split split = split_mounts(names, {.validation_fraction = 0.15}, seed);
  RC_ASSERT(split_mounts(names, {}, seed).test == split.test);
  RC_ASSERT(!split.training.empty() && !split.validation.empty() && !split.test.empty());
}

TEST(SplitMounts, ComesNearTheFraction) {
  std::vector<std::string> mounts;
  for (int row = 0; row < 240; ++row) mounts.push_back(std::to_string(row / 10));
  EXPECT_EQ(split_mounts(mounts, {}, 1).training.size(), 170U);
  EXPECT_NE(split_mounts(mounts, {}, 1).test, split_mounts(mounts, {}, 2).test);
  EXPECT_THROW((void)split_mounts(std::vector<std::string>(20, "one"), {}, 1), Error);
}

TEST(Identify, TakesTermsInAnyOrder) {
  const Dataset record = test::make_twin({.rows = 60});
  const auto named = [&record](const TermList& terms) {
    std::map<Term, double> values;
    for (const Coefficient& c : identify(record, Ols{}, {.terms = terms}).identification.coefficients)
      values[c.term] = c.value;
    return values;
  };
  EXPECT_EQ(named({Term::Kiii, Term::Ko, Term::K0, Term::Ki, Term::Kii, Term::Ki}),
            named({Term::K0, Term::Ki, Term::Kii, Term::Kiii, Term::Ko}));
}

TEST(SplitRows, RefusesFractionsThatMakeNoSense) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::vector<SplitOptions> bad;
  for (const double fraction : {0.0, -0.1, 1.01, kNan}) bad.push_back({.training_fraction = fraction});
  for (const double fraction : {0.7, 0.9, -0.1, kNan}) bad.push_back({.validation_fraction = fraction});
  bad.push_back({.training_fraction = 0.04});    // no row of ten
  bad.push_back({.validation_fraction = 0.68});  // seven rows of seven
  bad.push_back({.validation_fraction = 0.04});  // some, but no row of ten
  for (const SplitOptions& options : bad) {
    try {
      (void)split_rows(10, options, 1);
      ADD_FAILURE() << options.training_fraction << ", " << options.validation_fraction;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

// A fraction below 1 asks for rows to test on.
TEST(SplitRows, RefusesAFractionThatLeavesNoRowForTesting) {
  for (const auto& [rows, fraction, most] : {std::tuple{2U, 0.8, "0.5"},
                                             {3U, 0.9, "0.6"},
                                             {10U, 0.95, "0.9"},
                                             {15U, 0.999, "0.93"},
                                             {1000U, 0.9999, "0.999"},
                                             {1001U, 0.9999, "0.999"}}) {
    try {
      (void)split_rows(rows, {.training_fraction = fraction}, 1);
      ADD_FAILURE() << rows;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      ASSERT_EQ(error.remedies().size(), 2U);
      EXPECT_EQ(error.remedies()[0].value, "1");
      EXPECT_EQ(error.remedies()[1].value, most);
      EXPECT_EQ(std::string(error.what()).find("--"), std::string::npos) << "flags are the program's";
    }
    EXPECT_EQ(split_rows(rows, {.training_fraction = 1.0}, 1).training.size(), rows);
    EXPECT_GE(split_rows(rows, {.training_fraction = std::stod(most)}, 1).test.size(), 1U);
  }
}

TEST(PaperPreset, StopsEarly) {
  Method method = PsoBp{};
  ASSERT_TRUE(apply_paper_preset(method));
  EXPECT_TRUE(network_options(method)->early_stopping);
  EXPECT_EQ(training_fraction(method, {}), 0.7);
  EXPECT_EQ(training_fraction(method, {.split = 0.5}), 0.5);
  EXPECT_EQ(training_fraction(Ols{}, {}), 1.0);
  EXPECT_EQ(training_fraction(Ols{}, {.split_by = SplitBy::mount}), 0.7);
  EXPECT_EQ(std::get<PsoBp>(method).particles, 50U);
}

Bp small_network() {
  Bp method;
  method.network.hidden = 3;
  method.network.training.epochs = 60;
  return method;
}

// The method with what it needs for the records here, and no larger than it must be.
Method small(Method method) {
  if (NetworkOptions* const network = network_options(method)) *network = small_network().network;
  if (auto* const swarm = std::get_if<PsoBp>(&method)) {
    swarm->grow_to = 0;
    swarm->particles = 6;
    swarm->iterations = 3;
  }
  const UncertaintyOptions uncertainty{.input = 2e-4, .output = 3e-4};
  if (auto* const tls = std::get_if<Tls>(&method)) tls->uncertainty = uncertainty;
  if (auto* const eiv = std::get_if<Eiv>(&method)) eiv->uncertainty = uncertainty;
  return method;
}

// Likewise; the networks set rows aside.
Method small_and_early(Method method) {
  method = small(std::move(method));
  if (NetworkOptions* const network = network_options(method)) network->early_stopping = true;
  return method;
}

std::vector<double> values_of(const Identification& result) {
  std::vector<double> values;
  for (const Coefficient& c : result.coefficients) values.push_back(c.value);
  return values;
}

class Identify : public testing::TestWithParam<std::string_view> {
 protected:
  [[nodiscard]] static Method method() { return find_method(GetParam()); }
};

std::vector<std::string_view> names_of_methods() {
  std::vector<std::string_view> names;
  for (const Method& method : methods()) names.push_back(info(method).name);
  return names;
}

// Rows that training must not see may hold anything.
TEST_P(Identify, TestRowsTouchNothingButTheirOwnScore) {
  const Dataset record = test::make_twin();
  const Method early = small_and_early(method());
  const IdentifyOptions options{.split = kTrainingFraction};
  const auto run = identify(record, early, options);
  Dataset spoilt = record;
  for (const std::size_t row : run.split.test) {
    spoilt.output[row] = 1e6;
    spoilt.acceleration[0][row] = -400.0;
  }
  const Identification& a = run.identification;
  const Identification b = identify(spoilt, early, options).identification;
  EXPECT_EQ(values_of(a), values_of(b));
  EXPECT_EQ(a.train->rmse, b.train->rmse);
  EXPECT_EQ(a.validation.has_value(), info(early).predicts_by_network);
  if (a.validation) {
    EXPECT_EQ(a.validation->rmse, b.validation->rmse);
  }
  EXPECT_GT(b.test->rmse, 1e3 * a.test->rmse);
}

TEST_P(Identify, ScoresEveryPartInTheDeclaredUnit) {
  Dataset record = test::make_twin();
  record.output_unit = find_unit("mV").value();
  const auto run = identify(record, small_and_early(method()), {.split = kTrainingFraction});
  const Identification& result = run.identification;
  const auto expect_score = [&](const std::optional<Metrics>& found, const std::vector<std::size_t>& rows) {
    ASSERT_TRUE(found.has_value());
    const Dataset part = record.select(rows);
    const std::vector<double> predicted = predict(result, part);
    double square = 0.0;
    for (std::size_t row = 0; row < predicted.size(); ++row) {
      square += std::pow((part.output[row] - predicted[row]) / record.output_unit.to_canonical, 2);
    }
    EXPECT_EQ(found->n, rows.size());
    EXPECT_NEAR(found->mse, square / static_cast<double>(rows.size()), 1e-12 * found->mse);
  };
  expect_score(result.train, run.split.training);
  if (!run.split.validation.empty()) expect_score(result.validation, run.split.validation);
  expect_score(result.test, run.split.test);
}

TEST_P(Identify, SplitIsTheOneThatWasUsed) {
  const Dataset record = test::make_twin();
  const Method early = small_and_early(method());
  const IdentifyOptions options{.seed = 5, .split = 0.6};
  const auto run = identify(record, early, options);
  const Split& split = run.split;
  std::vector<std::size_t> all(record.rows());
  std::iota(all.begin(), all.end(), std::size_t{0});
  EXPECT_EQ(together(split), all);
  EXPECT_EQ(split.training.size() + split.validation.size(), 180U);
  EXPECT_EQ(split.validation.size(), info(early).predicts_by_network ? 45U : 0U);
  EXPECT_EQ(split.test, split_rows(300, {.training_fraction = 0.6}, 5).test) << "the same for every method";

  SilentProgress progress;
  const Identification again =
      fit(early, record.select(split.training), record.select(split.validation), options, progress);
  EXPECT_EQ(values_of(again), values_of(run.identification));
}

TEST_P(Identify, FittingAllRowsLeavesNothingToTest) {
  const Identification result = identify(test::make_twin(), small(method()), {.split = 1.0}).identification;
  EXPECT_EQ(result.train->n, 300U);
  EXPECT_FALSE(result.validation.has_value());
  EXPECT_FALSE(result.test.has_value());
  for (const Coefficient& c : result.coefficients) {
    // A search over models may leave terms out.
    EXPECT_TRUE(c.ci95.has_value() || !c.identified) << name(c.term);
  }
}

// A sentence that lacks a figure would be the finding's code and what figures there are.
TEST_P(Identify, FindsWhatHasASentence) {
  const Identification result = identify(test::make_twin(), small(method())).identification;
  EXPECT_FALSE(result.findings.empty());
  for (const Finding& finding : result.findings) {
    EXPECT_THAT(english(finding), testing::Not(StartsWith(std::string(to_string(finding.code)))));
  }
}

INSTANTIATE_TEST_SUITE_P(AllMethods, Identify, testing::ValuesIn(names_of_methods()), [](const auto& method) {
  std::string label(method.param);
  std::replace(label.begin(), label.end(), '-', '_');
  return label;
});

TEST(IdentifyOls, SaysWhenTestRowsAreUnlikeTheOthers) {
  Dataset record = test::make_twin();
  const IdentifyOptions options{.split = kTrainingFraction};
  const auto alike = identify(record, Ols{}, options);
  EXPECT_FALSE(test::has(alike.identification, Code::test_error_larger));
  for (const std::size_t row : alike.split.test) record.output[row] *= 1.01;
  const Identification unlike = identify(record, Ols{}, options).identification;
  const Finding& finding = test::finding_of(unlike, Code::test_error_larger);
  EXPECT_EQ(finding.severity, Severity::warning);
  EXPECT_EQ(test::number(finding, "test"), unlike.test->rmse);
  EXPECT_EQ(test::number(finding, "train"), unlike.train->rmse);
  EXPECT_DOUBLE_EQ(test::number(finding, "ratio"), unlike.test->rmse / unlike.train->rmse);
  EXPECT_GT(test::number(finding, "ratio"), 3.0);
  EXPECT_EQ(test::word(finding, "unit"), "g");
}

TEST(IdentifyOls, ProvenanceIsEnoughToMakeTheResultAgain) {
  Dataset record = test::make_twin();
  record.source = "bench.csv";
  record.source_sha256 = "0123";
  const Provenance provenance =
      identify(record, Ols{}, {.terms = linear_terms(), .seed = 5, .split = 0.8}).provenance;
  EXPECT_EQ(provenance.version, version());
  EXPECT_FALSE(provenance.version.empty());
  EXPECT_EQ(provenance.input, "bench.csv");
  EXPECT_EQ(provenance.input_sha256, "0123");
  EXPECT_THAT(provenance.options, testing::IsSupersetOf({Pair("method", "ols"), Pair("model", "linear"),
                                                         Pair("seed", "5"), Pair("split", "0.8")}));
}

TEST(IdentifyBp, ProvenanceHasTheOptionsAsTheyWereAskedFor) {
  Bp method = small_network();
  method.network.early_stopping = true;
  method.network.validation_fraction = 0.2;
  const auto given = identify(test::make_twin(), method).provenance.options;
  EXPECT_THAT(given,
              testing::IsSupersetOf({Pair("method", "bp"), Pair("model", "paper"), Pair("seed", "1"),
                                     Pair("split", "0.7"), Pair("hidden", "3"), Pair("epochs", "60"),
                                     Pair("early-stopping", "on"), Pair("validation-fraction", "0.2")}));

  // Not the size that the search came to: repeating it must search again.
  method.network.hidden.reset();
  method.network.search_repeats = 2;
  method.network.training.epochs = 2;
  EXPECT_THAT(identify(test::make_twin(), method).provenance.options, Contains(Pair("hidden", "search")));
}

TEST(IdentifyBp, SearchesOnTheRowsOfTheSplitThatItFits) {
  Bp fixed = small_network();
  fixed.network.training.epochs = 2;
  Bp searching = fixed;
  searching.network.hidden.reset();
  searching.network.search_repeats = 2;
  for (const bool early : {false, true}) {
    fixed.network.early_stopping = searching.network.early_stopping = early;
    const Split expected = identify(test::make_twin(), fixed).split;
    const Split split = identify(test::make_twin(), searching).split;
    EXPECT_EQ(split.training, expected.training);
    EXPECT_EQ(split.validation, expected.validation);
    EXPECT_EQ(split.validation.empty(), !early);
    EXPECT_EQ(split.test, expected.test);
  }
}

TEST(IdentifyBp, IsTheSameWithoutProgress) {
  const Dataset record = test::make_twin();
  const IdentifyOptions options{.terms = quadratic_terms(), .seed = 3};
  SilentProgress progress;
  const auto watched = identify(record, small_network(), options, progress);
  const auto alone = identify(record, small_network(), options);
  EXPECT_EQ(to_json(alone), to_json(watched));
  EXPECT_EQ(alone.split.training, watched.split.training);
  EXPECT_EQ(alone.split.test, watched.split.test);
}

TEST(IdentifyBp, StopsWhenTheCallerAsks) {
  test::CancelAfter progress(0);
  try {
    (void)identify(test::make_twin(), small_network(), {}, progress);
    ADD_FAILURE() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
}

TEST(IdentifyBp, RefusesAFractionThatLeavesNoValidationRows) {
  Bp method = small_network();
  for (const double fraction : {1e-4, 0.9}) {
    method.network.validation_fraction = fraction;
    method.network.early_stopping = true;
    try {
      (void)identify(test::make_twin(), method);
      ADD_FAILURE() << "no error at " << fraction;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
    // Without early stopping nobody asks for validation rows.
    method.network.early_stopping = false;
    EXPECT_NO_THROW((void)identify(test::make_twin(), method));
  }
}

// The scaling too is learned from the rows that train.
TEST(IdentifyBp, LearnsItsScalingFromTheTrainingRows) {
  const Dataset record = test::make_twin();
  Bp method = small_network();
  method.network.early_stopping = true;
  const auto run = identify(record, method);
  const Identification& result = run.identification;
  ASSERT_FALSE(run.split.validation.empty());
  const Dataset training = record.select(run.split.training);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] =
        std::minmax_element(training.acceleration[k].begin(), training.acceleration[k].end());
    EXPECT_EQ(result.network->input_range[k].low, *low);
    EXPECT_EQ(result.network->input_range[k].high, *high);
  }
  const auto [low, high] = std::minmax_element(training.output.begin(), training.output.end());
  EXPECT_EQ(result.network->output_range.low, *low);
  EXPECT_EQ(result.network->output_range.high, *high);
}

}  // namespace
}  // namespace proofmass
