// SPDX-License-Identifier: Apache-2.0
// Causes, lines and figures of what is said, and records that nothing is to be said of.
#include "proofmass/assess/diagnosis/diagnosis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "support/diagnosed.hpp"
#include "support/findings.hpp"

namespace proofmass {
namespace {

using test::add_to_output;
using test::clean_record;
using test::clip;
using test::diagnosed;
using test::kNoise;
using test::shift_outputs;
using test::tumble;
using test::warnings;

TEST(DiagnosisOfMisfit, NamesTheLikeliestReason) {
  const auto reason = [](const std::function<void(Dataset&)>& put_into, const TermList& terms) {
    Dataset record = clean_record();
    put_into(record);
    return test::word(test::finding_of(diagnosed(record, Ols{}, terms).identification, Code::gross_misfit),
                      "reason");
  };
  EXPECT_EQ(reason([](Dataset&) {}, {Term::K0, Term::Ko}), "terms");
  EXPECT_EQ(reason([](Dataset& r) { std::sort(r.output.begin(), r.output.end()); }, paper_terms()),
            "unrelated");
  EXPECT_EQ(reason([](Dataset& r) { r.output[7] = 150.0; }, paper_terms()), "rows");
}

TEST(DiagnosisOfShift, NamesRowsAndDirection) {
  Dataset record = clean_record();
  shift_outputs(record);
  const Finding up = test::finding_of(diagnosed(record).identification, Code::rows_shifted);
  EXPECT_EQ(test::number(up, "shift"), 2.0);
  EXPECT_EQ(test::word(up, "direction"), "above");
  EXPECT_FALSE(test::has(diagnosed(record).identification, Code::gross_misfit));
  Dataset other = clean_record();
  std::rotate(other.output.begin(), other.output.end() - 1, other.output.end());
  const Finding down = test::finding_of(diagnosed(other).identification, Code::rows_shifted);
  EXPECT_EQ(test::number(down, "shift"), 1.0);
  EXPECT_EQ(test::word(down, "direction"), "below");
}

// Few positions, exact or coarse, and no fault.
TEST(DiagnosisOfShift, SaysNothingOfShortAndCoarseRecords) {
  for (const std::size_t positions : {4U, 6U, 8U, 12U}) {
    for (const std::size_t readings : {1U, 2U, 6U}) {
      for (const double step : {0.0, 1e-4, 1e-3}) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
          RandomStream random(seed, stream_id("short"));
          Dataset record;
          for (std::size_t row = 0; row < positions * readings; ++row) {
            const double angle =
                2.0 * std::numbers::pi * static_cast<double>(row / readings) / static_cast<double>(positions);
            record.acceleration[0].push_back(std::cos(angle));
            record.acceleration[1].push_back(std::sin(angle));
            const double e = 0.01 + 0.999 * std::cos(angle) + 1e-4 * std::sin(angle) + 1e-5 * random.normal();
            record.output.push_back(step > 0.0 ? step * std::nearbyint(e / step) : e);
          }
          EXPECT_TRUE(diagnose_record(record).empty()) << positions << " " << readings << " " << step;
        }
      }
    }
  }
}

// Local gravity that is wrong in one plane is no shift by a quarter turn.
TEST(DiagnosisOfShift, TakesNoTurnForOne) {
  Dataset record = clean_record();
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const double angle = static_cast<double>(row % 36) * std::numbers::pi / 18.0;
    for (std::vector<double>& axis : record.acceleration) axis[row] = 0.0;
    record.acceleration[0][row] = std::cos(angle);
    record.acceleration[row < 150 ? 1 : 2][row] = std::sin(angle);
    record.output[row] = (row < 150 ? 1.0 : 1.0015) * std::cos(angle);
  }
  for (const Finding& finding : diagnose_record(record)) EXPECT_NE(finding.code, Code::rows_shifted);
}

// A turn by 6.8 degrees makes Ki 0.993: with Ki at 1 the response across has another cause.
TEST(DiagnosisOfScale, TakesNoSkewForATurn) {
  Dataset record = test::clean_record();
  for (std::size_t row = 0; row < record.rows(); ++row)
    record.output[row] += 0.12 * record.along(Axis::output)[row];
  const std::vector<Code> said = test::warnings(test::diagnosed(record).identification);
  EXPECT_EQ(std::count(said.begin(), said.end(), Code::scale_factor_unlike_one), 0);
  EXPECT_EQ(std::count(said.begin(), said.end(), Code::cross_axis_large), 1);
}

// A coarse reading of a good instrument equals its inputs.
TEST(DiagnosisOfCopies, JudgesFineOutputsOnly) {
  for (const double step : {1e-3, 1e-7}) {
    Dataset record = clean_record();
    tumble(record, 1.0);
    for (std::size_t row = 0; row < record.rows(); ++row) {
      for (std::vector<double>& axis : record.acceleration)
        axis[row] = step * std::nearbyint(axis[row] / step);
      record.output[row] = record.acceleration[0][row];
    }
    EXPECT_EQ(diagnose_record(record).size(), step < 1e-5 ? 1U : 0U) << step;
  }
}

TEST(DiagnosisOfTemperature, KnowsChambers) {
  for (const auto& plateaus :
       {std::vector<double>{-55.0, 25.0, 125.0}, std::vector<double>{-55.0, 125.0, 125.0}}) {
    Dataset record = clean_record();
    for (std::size_t row = 0; row < record.rows(); ++row) record.temperature[row] = plateaus[row / 100];
    EXPECT_TRUE(diagnose_record(record).empty());
    record.temperature.assign(record.rows(), -999.0);
    ASSERT_EQ(diagnose_record(record).size(), 1U);
    EXPECT_EQ(diagnose_record(record).front().lines.size(), record.rows());
  }
  Dataset kelvin = clean_record();
  kelvin.temperature_unit = find_unit("K").value();
  for (double& value : kelvin.temperature) value += 273.15;
  EXPECT_TRUE(diagnose_record(kelvin).empty());
  kelvin.temperature[5] = -1.0;
  EXPECT_EQ(diagnose_record(kelvin).front().lines, std::vector<std::size_t>{kelvin.line_of(5)});
}

// An axis without acceleration is in no order, and marks are no temperature.
TEST(DiagnosisOfTrends, SeesThemBesideAnEmptyAxis) {
  Dataset record = clean_record();
  std::fill(record.acceleration[2].begin(), record.acceleration[2].end(), 0.0);
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const Acceleration a = record.at(row);
    record.output[row] = 0.001 + a.i + 1e-4 * a.o + 1e-6 * static_cast<double>(row);
  }
  RandomStream random(1, stream_id("drift"));
  for (double& e : record.output) e += kNoise * random.normal();
  record.time.clear();
  EXPECT_TRUE(test::has(diagnosed(record).identification, Code::residuals_follow_order));
  record.temperature[3] = -999.0;
  EXPECT_FALSE(test::has(diagnosed(record).identification, Code::residuals_follow_temperature));
}

// A drift is named, and not the levels of an input that were measured in some order.
TEST(DiagnosisOfEffects, NamesTheSimplerCause) {
  for (const std::size_t rows : {300U, 3000U}) {
    Dataset record = test::make_twin({.rows = rows, .noise = kNoise, .seed = 3});
    constexpr std::array kLevels{5.0, -3.0, 0.0, 8.0, -8.0, 3.0, -5.0, 1.5, -1.5};
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t block = row * kLevels.size() / rows;
      record.output[row] -= 6.86924e-5 * record.acceleration[1][row];
      record.acceleration[1][row] = kLevels[block];
      const double part = static_cast<double>(row) / static_cast<double>(rows);
      record.output[row] =
          0.001 + record.acceleration[0][row] + 1e-4 * record.acceleration[1][row] + 1e-4 * part;
      record.time.push_back(static_cast<double>(row));
    }
    RandomStream random(rows, stream_id("levels"));
    for (double& e : record.output) e += kNoise * random.normal();
    const Identification result = diagnosed(record).identification;
    EXPECT_TRUE(test::has(result, Code::residuals_follow_time)) << rows;
    EXPECT_FALSE(test::has(result, Code::residuals_follow_inputs)) << rows;
  }
}

// sigma_E that is right is not blamed for what something else explains.
TEST(DiagnosisOfSigmas, BlamesNoneForOtherFaults) {
  for (const auto& fault : std::vector<std::function<void(Dataset&)>>{
           [](Dataset& r) { r.output[7] += 3e-3; },
           [](Dataset& r) {
             add_to_output(r, [&](std::size_t row) { return 2e-4 * r.time[row] / r.time.back(); });
           },
           [](Dataset& r) { clip(r, 10.0); }}) {
    Dataset record = clean_record();
    RandomStream random(2, stream_id("uneven"));
    for (std::size_t row = 0; row < record.rows(); ++row) {
      record.output_sigma[row] = kNoise * (row % 3 == 0 ? 3.0 : 1.0);
      record.output[row] +=
          std::sqrt(std::pow(record.output_sigma[row], 2) - kNoise * kNoise) * random.normal();
    }
    EXPECT_FALSE(test::has(diagnosed(record).identification, Code::sigma_output_uneven));
    fault(record);
    EXPECT_FALSE(test::has(diagnosed(record).identification, Code::sigma_output_uneven));
  }
}

TEST(DiagnosisOfTime, LetsAClockStartAnewWithAMount) {
  Dataset record = clean_record();
  for (std::size_t row = 0; row < record.rows(); ++row) {
    record.mount[row] = row < 150 ? "A" : "B";
    record.time[row] = static_cast<double>(row % 150);
  }
  EXPECT_TRUE(diagnose_record(record).empty());
  record.time[200] = 0.0;
  EXPECT_EQ(diagnose_record(record).front().code, Code::time_backwards);
}

// One wrong row of a tumble determines what the others leave aliased; it makes no stuck output and no shift.
TEST(DiagnosisOfMagnitude, NamesTheRowAlone) {
  for (const std::size_t wrong : {5U, 100U, 299U}) {
    for (const double by : {-2.0, 0.01, 0.1, 10.0}) {
      Dataset record = clean_record();
      tumble(record, 1.0);
      record.acceleration[0][wrong] += by;
      const std::vector<Finding> findings = diagnose_record(record);
      ASSERT_EQ(findings.size(), 1U) << wrong << " " << by;
      EXPECT_EQ(findings.front().code, Code::magnitude_unlike_others);
      EXPECT_EQ(findings.front().lines, std::vector<std::size_t>{record.line_of(wrong)});
    }
  }
}

// A tumble with a few rows in a centrifuge.
TEST(DiagnosisOfMagnitude, KnowsRowsAtOtherLevels) {
  for (const auto& levels : {std::vector<double>{10.0}, std::vector<double>{1.5, 3.0, 7.0},
                             std::vector<double>{1.01, 1.01, 1.01}}) {
    Dataset record = clean_record();
    tumble(record, 1.0);
    for (std::size_t k = 0; k < levels.size(); ++k) {
      const std::size_t row = 40 + 2 * k;
      for (std::vector<double>& axis : record.acceleration) axis[row] *= levels[k];
      record.output[row] = 0.01 + record.acceleration[0][row] + 1e-4 * record.acceleration[1][row];
    }
    EXPECT_TRUE(diagnose_record(record).empty()) << levels.size();
  }
}

// What residuals follow is said by its shape and size.
TEST(DiagnosisOfStructure, NamesAxisShapeAndSize) {
  const auto found = [](const std::function<double(const Acceleration&)>& added) {
    Dataset record = clean_record();
    add_to_output(record, [&](std::size_t row) { return added(record.at(row)); });
    return test::finding_of(diagnosed(record).identification, Code::residuals_follow_inputs);
  };
  const Finding slope = found([](const Acceleration& a) { return 1e-3 * std::max(0.0, a.o); });
  EXPECT_EQ(test::word(slope, "axis"), "Ao");
  EXPECT_EQ(test::word(slope, "shape"), "slope");
  EXPECT_NEAR(test::number(slope, "change"), 1e-3, 1e-5);
  const Finding step = found([](const Acceleration& a) { return a.p > 0.0 ? 1e-3 : 0.0; });
  EXPECT_EQ(test::word(step, "axis"), "Ap");
  EXPECT_EQ(test::word(step, "shape"), "step");
  EXPECT_NEAR(test::number(step, "change"), 1e-3, 1e-4);
  EXPECT_EQ(test::word(found([](const Acceleration& a) { return 1e-3 * std::cos(0.4 * a.i); }), "shape"),
            "other");
}

TEST(DiagnosisOfClipping, NamesTheLines) {
  Dataset record = clean_record();
  const auto largest = std::max_element(record.output.begin(), record.output.end());
  const auto at = static_cast<std::size_t>(largest - record.output.begin());
  record.output[at] = 15.0;
  clip(record, 15.0);
  const Identification result = diagnosed(record).identification;
  const Finding& finding = test::finding_of(result, Code::output_clipped);
  EXPECT_EQ(test::number(finding, "count"),
            static_cast<double>(
                std::count(record.output.begin(), record.output.end(), test::number(finding, "value"))));
  for (const std::size_t line : finding.lines) EXPECT_EQ(std::abs(record.output[line - 2]), 15.0) << line;
}

// A tumble of so few rows leaves little to judge by; effects far above the noise show all the same.
Dataset short_tumble(std::uint64_t seed) {
  RandomStream random(seed, stream_id("short tumble"));
  Dataset record;
  record.acceleration.fill(std::vector<double>(24, 0.0));
  for (std::size_t row = 0; row < 24; ++row) {
    const double angle = static_cast<double>(row % 12) * std::numbers::pi / 6.0;
    record.acceleration[0][row] = std::sin(angle);
    record.acceleration[row < 12 ? 1 : 2][row] = std::cos(angle);
    record.output.push_back(1e-5 + 0.9999 * record.acceleration[0][row] + 5e-5 * record.acceleration[1][row] +
                            kNoise * random.normal());
    record.mount.push_back(row < 12 ? "OA" : "PA");
  }
  return record;
}

std::vector<Code> of_tumble(const std::function<void(Dataset&)>& put_into, std::uint64_t seed) {
  Dataset record = short_tumble(seed);
  put_into(record);
  return warnings(diagnosed(record, Ols{}, linear_terms()).identification);
}

TEST(DiagnosisOfShortRecords, SeesWhatIsFarAboveTheNoise) {
  using Codes = std::vector<Code>;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    EXPECT_EQ(of_tumble([](Dataset&) {}, seed), Codes()) << seed;
    EXPECT_EQ(of_tumble(
                  [](Dataset& r) {
                    for (std::size_t row = 0; row < 24; ++row)
                      r.output[row] += 4e-5 * static_cast<double>(row);
                    r.mount.clear();
                  },
                  seed),
              Codes{Code::residuals_follow_order})
        << seed;
    EXPECT_EQ(of_tumble(
                  [](Dataset& r) {
                    for (std::size_t row = 12; row < 24; ++row) r.output[row] += 1e-3;
                  },
                  seed),
              Codes{Code::residuals_follow_mount})
        << seed;
    EXPECT_EQ(of_tumble([](Dataset& r) { r.output[5] += 1e-2; }, seed), Codes{Code::rows_far_off}) << seed;
    EXPECT_EQ(of_tumble([](Dataset& r) { r.output[5] += 1e-2, r.output[6] += 1e-2; }, seed),
              Codes{Code::rows_far_off})
        << seed;
    EXPECT_EQ(of_tumble(
                  [](Dataset& r) {
                    for (std::size_t row = 0; row < 24; ++row)
                      r.output[row] +=
                          1e-3 * r.acceleration[0][row] * (r.acceleration[0][row] + r.acceleration[1][row]);
                  },
                  seed),
              Codes{Code::model_too_short})
        << seed;
  }
}

// Uncertainties of the inputs that come from options are no part of the record.
TEST(DiagnosisOfSigmas, DoesNotJudgeByHalfOfThem) {
  Dataset record = clean_record();
  RandomStream random(3, stream_id("noisy inputs"));
  for (std::vector<double>& axis : record.acceleration) {
    for (double& a : axis) a += kNoise * random.normal();
  }
  const Method eiv = Eiv{.uncertainty = {.input = kNoise}};
  EXPECT_EQ(warnings(diagnosed(record, eiv).identification), std::vector<Code>());
}

// Records that a model explains to the last digit.
TEST(DiagnosisOfExactRecords, EndsWithoutAFault) {
  Dataset record;
  for (int k = 0; k < 10; ++k) {
    record.acceleration[0].push_back(k);
    record.acceleration[1].push_back(0.0);
    record.acceleration[2].push_back(1.0);
    record.output.push_back(k);
  }
  for (const Method& method : {Method(Ols{}), Method(Wls{}), Method(Robust{})})
    EXPECT_NO_THROW((void)diagnosed(record, method, linear_terms())) << info(method).name;
}

// Right uncertainties that differ from row to row are right for a method that takes no account of them, too.
TEST(DiagnosisOfSigmas, DoesNotBlameUncertaintiesThatDiffer) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Dataset record = test::make_twin({.rows = 60, .noise = 0.0, .seed = seed});
    RandomStream random(seed, stream_id("unequal noise"));
    for (std::size_t row = 0; row < record.rows(); ++row) {
      const double sigma = random.index(2) == 0 ? 1e-6 : 1e-4;
      record.output_sigma.push_back(sigma);
      record.output[row] += sigma * random.normal();
    }
    for (const Method& method : {Method(Ols{}), Method(Wls{}), Method(Robust{})}) {
      const Identification result = diagnosed(record, method).identification;
      EXPECT_FALSE(test::has(result, Code::sigma_output_too_small)) << info(method).name << " " << seed;
    }
  }
}

// What a saturated or otherwise degenerate output leaves to look at is little, or nothing.
TEST(DiagnosisOfDegenerateOutputs, EndsWithoutAFault) {
  for (const std::size_t values : {1U, 2U, 3U}) {
    for (const std::size_t rows : {2U, 3U, 6U, 8U, 40U}) {
      Dataset record = clean_record().select(std::vector<std::size_t>());
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::vector<double>& axis : record.acceleration)
          axis.push_back(std::cos(static_cast<double>(row * row)));
        record.output.push_back(static_cast<double>(row % values));
      }
      record.mount.clear();
      record.time.clear();
      record.temperature.clear();
      record.output_sigma.clear();
      EXPECT_NO_THROW((void)diagnose_record(record)) << values << " " << rows;
    }
  }
}

// Sizes and significances, of a drift that is known.
TEST(DiagnosisOfDrift, SaysHowLargeItIs) {
  Dataset record = clean_record();
  const double last = record.time.back();
  add_to_output(record, [&](std::size_t row) { return 1e-3 * record.time[row] / last; });
  const Identification result = diagnosed(record).identification;
  const Finding& finding = test::finding_of(result, Code::residuals_follow_time);
  EXPECT_NEAR(test::number(finding, "change"), 1e-3, 1e-5);
  EXPECT_GT(test::number(finding, "errors"), 50.0);
}

TEST(DiagnosisOfRecord, TakesRepeatedReadingsOfACounterForWhatTheyAre) {
  RandomStream random(5, stream_id("readings"));
  Dataset record;
  record.output_unit = find_unit("counts").value();
  for (std::size_t row = 0; row < 240; ++row) {
    const double angle = static_cast<double>(row / 10) * std::numbers::pi / 12.0;
    record.acceleration[0].push_back(std::cos(angle));
    record.acceleration[1].push_back(std::sin(angle));
    record.output.push_back(std::nearbyint(16'000.0 * std::cos(angle) + 0.7 * random.normal()));
    record.time.push_back(static_cast<double>(row / 4));  // a clock of seconds, four readings a second
  }
  EXPECT_TRUE(diagnose_record(record).empty());
  EXPECT_EQ(warnings(diagnosed(record, Ols{}, {Term::K0, Term::Ki, Term::Ko}).identification),
            std::vector<Code>());
}

// The same stage after every method.
TEST(DiagnosisOfMethods, SeesADriftWhateverTheMethod) {
  Dataset record = clean_record();
  add_to_output(record, [&](std::size_t row) { return 1e-7 * record.time[row]; });
  const UncertaintyOptions uncertainty{.input = 1e-7, .output = kNoise};
  for (const Method& method :
       {Method(Ols{}), Method(Wls{}), Method(Robust{}), Method(Tls{.uncertainty = uncertainty}),
        Method(Eiv{.uncertainty = uncertainty}), Method(Gmdh{}), Method(Hybrid{})}) {
    EXPECT_TRUE(test::has(diagnosed(record, method).identification, Code::residuals_follow_time))
        << info(method).name;
  }
}

}  // namespace
}  // namespace proofmass
