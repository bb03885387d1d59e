// SPDX-License-Identifier: Apache-2.0
// Faults in records of stands, planned as they are: that the cause is named, and not what it looks like.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "proofmass/assess/diagnosis/diagnosis.hpp"
#include "support/diagnosed.hpp"
#include "support/findings.hpp"

namespace proofmass {
namespace {

using test::clean_record;
using test::diagnosed;
using test::finding_of;
using test::has;
using test::kNoise;
using test::warnings;
using NamedCodes = std::vector<Code>;
using NamedLines = std::vector<std::size_t>;

double response(const Acceleration& a) {
  return 1e-3 + 1.0007 * a.i + 1e-4 * a.o - 2e-4 * a.p + 2e-5 * a.i * a.i + 1e-5 * a.i * a.o;
}

Dataset record_of(const std::vector<Acceleration>& inputs, std::uint64_t seed = 3, double noise = kNoise) {
  Dataset record;
  record.output_unit = find_unit("g").value();
  record.output_unit_declared = true;
  record.acceleration_resolution.fill(1e-9);
  RandomStream random(seed, stream_id("planned record"));
  for (const Acceleration& a : inputs) {
    record.acceleration[0].push_back(a.i);
    record.acceleration[1].push_back(a.o);
    record.acceleration[2].push_back(a.p);
    record.output.push_back(response(a) + noise * random.normal());
    record.line.push_back(record.line.size() + 2);
  }
  return record;
}

// Positions of a dividing head at equal angles, in the plane of IA and OA.
std::vector<Acceleration> plane(int positions) {
  std::vector<Acceleration> inputs;
  for (int k = 0; k < positions; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / positions;
    inputs.push_back({.i = std::cos(angle), .o = std::sin(angle), .p = 0.0});
  }
  return inputs;
}

// The same, and then in that of IA and PA.
std::vector<Acceleration> two_planes(int positions) {
  std::vector<Acceleration> inputs = plane(positions);
  for (const Acceleration& a : plane(positions)) inputs.push_back({.i = a.i, .o = 0.0, .p = a.o});
  return inputs;
}

// A dividing head, then a centrifuge with its arm along seven directions.
std::vector<Acceleration> head_and_centrifuge() {
  std::vector<Acceleration> inputs = two_planes(24);
  for (const double level : {2.0, 5.0, 10.0, 15.0, 20.0, 30.0}) {
    for (const Acceleration& a : {Acceleration{1.0, 0.0, 0.0},
                                  {-1.0, 0.0, 0.0},
                                  {0.6, 0.8, 0.0},
                                  {-0.6, 0.8, 0.0},
                                  {0.6, 0.0, 0.8},
                                  {-0.6, 0.0, 0.8},
                                  {0.0, 0.6, 0.8}})
      inputs.push_back({.i = level * a.i, .o = level * a.o, .p = level * a.p});
  }
  return inputs;
}

Identification judged(const Dataset& record, const Method& method = Ols{},
                      const TermList& terms = quadratic_terms()) {
  return diagnosed(record, method, terms).identification;
}

TEST(DiagnosisOfCauses, SaysNothingOfTheRecordsAsTheyAre) {
  for (const std::uint64_t seed : {3U, 4U, 5U}) {
    EXPECT_EQ(warnings(judged(record_of(plane(24), seed))), NamedCodes()) << seed;
    EXPECT_EQ(warnings(judged(record_of(two_planes(36), seed))), NamedCodes()) << seed;
    EXPECT_EQ(warnings(judged(record_of(head_and_centrifuge(), seed))), NamedCodes()) << seed;
  }
}

TEST(DiagnosisOfMarks, NamesTheirLines) {
  for (const double mark : {9999.0, 99'999.0, -999.0}) {
    Dataset record = record_of(two_planes(24));
    record.output[5] = mark;
    record.output[30] = mark;
    const Identification result = judged(record);
    EXPECT_EQ(warnings(result), NamedCodes{Code::output_far_off}) << mark;
    EXPECT_EQ(finding_of(result, Code::output_far_off).lines, (NamedLines{7, 32})) << mark;
  }
}

TEST(DiagnosisOfMarks, TakesNoReadingForOne) {
  // The one reading in an acceleration that no other row has.
  std::vector<Acceleration> inputs(30, Acceleration{.i = 0.5, .o = 0.0, .p = 0.0});
  for (std::size_t row = 0; row < inputs.size(); ++row) inputs[row].i = 0.1 * static_cast<double>(row % 10);
  inputs.push_back({.i = 60.0, .o = 0.0, .p = 0.0});
  EXPECT_FALSE(has(judged(record_of(inputs), Ols{}, {Term::K0, Term::Ki}), Code::output_far_off));
}

TEST(DiagnosisOfMarks, SaysThatSigmaIsOne) {
  for (const double mark : {999.0, 1e-12}) {
    Dataset record = record_of(two_planes(24));
    record.output_sigma.assign(record.rows(), kNoise);
    EXPECT_EQ(warnings(judged(record, Wls{})), NamedCodes());
    record.output_sigma[9] = mark;
    const Identification result = judged(record, Wls{});
    EXPECT_EQ(warnings(result), NamedCodes{Code::sigma_output_far_off}) << mark;
    EXPECT_EQ(finding_of(result, Code::sigma_output_far_off).lines, NamedLines{11}) << mark;
  }
}

TEST(DiagnosisOfMixedUnits, NamesThemWhicheverRowsTheyAre) {
  const auto mixed = [](const std::vector<Acceleration>& inputs,
                        const std::function<bool(std::size_t)>& other, bool of_inputs) {
    Dataset record = record_of(inputs);
    for (std::size_t row = 0; row < record.rows(); ++row) {
      if (!other(row)) continue;
      if (!of_inputs) record.output[row] *= kStandardGravity;
      for (std::vector<double>& axis : record.acceleration) axis[row] *= of_inputs ? kStandardGravity : 1.0;
    }
    return judged(record);
  };
  const auto second_part = [](std::size_t row) { return row >= 48; };
  const auto some = [](std::size_t row) { return row * 7 % 10 < 5; };
  for (const bool of_inputs : {false, true}) {
    for (const Identification& result :
         {mixed(head_and_centrifuge(), second_part, of_inputs), mixed(two_planes(36), some, of_inputs)}) {
      ASSERT_EQ(warnings(result), NamedCodes{Code::gross_misfit}) << of_inputs;
      EXPECT_EQ(test::word(finding_of(result, Code::gross_misfit), "reason"), "mixed") << of_inputs;
      EXPECT_FALSE(finding_of(result, Code::gross_misfit).lines.empty()) << of_inputs;
    }
  }
}

TEST(DiagnosisOfSquares, TakesNoPositionsForAngles) {
  for (const std::vector<Acceleration>& inputs : {plane(24), two_planes(36), head_and_centrifuge()}) {
    Dataset record = record_of(inputs);
    for (double& e : record.output) e *= e;
    EXPECT_EQ(warnings(judged(record)), NamedCodes{Code::square_larger}) << inputs.size();
  }
}

TEST(DiagnosisOfWraps, KnowsRowsThatAreWrongAmongOthers) {
  // Two rows, each with the output of the other.
  Dataset record = record_of(two_planes(36));
  std::swap(record.output[3], record.output[16]);
  const Identification result = judged(record);
  EXPECT_FALSE(has(result, Code::output_wrapped));
  EXPECT_EQ(finding_of(result, Code::gross_misfit).lines, (NamedLines{5, 18}));
}

TEST(DiagnosisOfClipping, SeesNarrowEnds) {
  const auto clipped = [](const std::vector<Acceleration>& inputs, double noise) {
    Dataset record = record_of(inputs);
    double limit = 0.0;
    for (const double e : record.output) limit = std::max(limit, 0.95 * std::abs(e));
    RandomStream random(5, stream_id("ends"));
    for (double& e : record.output) {
      if (std::abs(e) > limit) e = std::copysign(limit, e) + noise * random.normal();
    }
    return warnings(judged(record));
  };
  EXPECT_EQ(clipped(two_planes(36), 0.0), (NamedCodes{Code::output_clipped, Code::output_clipped}));
  EXPECT_EQ(clipped(plane(24), kNoise), NamedCodes{Code::output_saturated});
  EXPECT_EQ(clipped(two_planes(24), kNoise), NamedCodes{Code::output_saturated});
  EXPECT_EQ(clipped(head_and_centrifuge(), 0.0), NamedCodes{Code::output_saturated});
}

TEST(DiagnosisOfJumps, NamesTheRowWhereTheBiasChanges) {
  for (const auto& [inputs, first] : {std::pair{two_planes(24), std::size_t{24}},
                                      {two_planes(36), 30U},
                                      {plane(24), 8U},
                                      {head_and_centrifuge(), 48U}}) {
    Dataset record = record_of(inputs);
    for (std::size_t row = first; row < record.rows(); ++row) record.output[row] += 1e-3;
    const Identification result = judged(record);
    ASSERT_EQ(warnings(result), NamedCodes{Code::residuals_follow_order}) << first;
    const Finding& finding = finding_of(result, Code::residuals_follow_order);
    EXPECT_EQ(test::word(finding, "course"), "jump") << first;
    EXPECT_EQ(test::number(finding, "first"), static_cast<double>(first + 2)) << first;
    EXPECT_NEAR(test::number(finding, "change"), 1e-3, 5e-5) << first;
  }
}

TEST(DiagnosisOfJumps, NamesAGainAndABlock) {
  Dataset record = record_of(plane(24));
  for (std::size_t row = 12; row < 24; ++row) record.output[row] *= 1.001;
  Identification result = judged(record);
  ASSERT_EQ(warnings(result), NamedCodes{Code::scale_factor_follows_order});
  EXPECT_EQ(test::word(finding_of(result, Code::scale_factor_follows_order), "course"), "factor_jump");
  record = record_of(plane(24));
  for (std::size_t row = 12; row < 18; ++row) record.output[row] *= 1.01;
  result = judged(record);
  ASSERT_EQ(warnings(result), NamedCodes{Code::scale_factor_follows_order});
  const Finding& block = finding_of(result, Code::scale_factor_follows_order);
  EXPECT_EQ(test::word(block, "course"), "factor_stretch");
  EXPECT_NEAR(test::number(block, "change"), 0.01, 5e-4);
}

TEST(DiagnosisOfHysteresis, GoesByTheDirectionOfApproach) {
  Dataset record = clean_record();
  const std::vector<double>& a = record.along(Axis::input);
  for (std::size_t row = 1; row < record.rows(); ++row)
    record.output[row] += a[row] > a[row - 1] ? 15.0 * kNoise : -15.0 * kNoise;
  const Identification result = judged(record, Ols{}, paper_terms());
  ASSERT_TRUE(has(result, Code::residuals_follow_inputs));
  const Finding& finding = finding_of(result, Code::residuals_follow_inputs);
  EXPECT_EQ(test::word(finding, "shape"), "direction");
  EXPECT_NEAR(test::number(finding, "change"), 30.0 * kNoise, kNoise);
}

TEST(DiagnosisOfMagnitude, NamesMistypedInputsWithoutTheirConsequences) {
  std::vector<Acceleration> inputs;
  for (const Acceleration& a : two_planes(24)) inputs.insert(inputs.end(), 3, a);
  Dataset record = record_of(inputs);
  for (const std::size_t row : {10U, 61U, 100U}) record.acceleration[0][row] = -999.0;
  EXPECT_EQ(warnings(judged(record)), NamedCodes{Code::magnitude_unlike_others});
  record = record_of(inputs);
  for (const std::size_t row : {10U, 61U, 100U}) record.acceleration[0][row] += 0.1;
  EXPECT_EQ(warnings(judged(record)), NamedCodes{Code::magnitude_unlike_others});
}

TEST(DiagnosisOfUnits, KnowsOneAxisInAnother) {
  Dataset record = record_of(head_and_centrifuge());
  for (double& a : record.acceleration[1]) a *= kStandardGravity;
  Identification result = judged(record);
  ASSERT_EQ(warnings(result), NamedCodes{Code::inputs_in_other_unit});
  EXPECT_EQ(test::word(finding_of(result, Code::inputs_in_other_unit), "axis"), "Ao");
  EXPECT_EQ(test::word(finding_of(result, Code::inputs_in_other_unit), "written"), "m/s^2");
  // In random directions no |A| is to be expected.
  record = clean_record();
  for (double& a : record.acceleration[1]) a *= kStandardGravity;
  EXPECT_FALSE(has(judged(record, Ols{}, paper_terms()), Code::inputs_in_other_unit));
}

TEST(DiagnosisOfTime, NamesAMarkAndNotTheRowBelow) {
  Dataset record = clean_record();
  record.mount.clear();
  record.time[4] = 99'999.0;
  record.time[90] = 99'999.0;
  record.time[200] = 0.0;
  const Finding finding = finding_of(judged(record, Ols{}, paper_terms()), Code::time_backwards);
  EXPECT_EQ(finding.lines, (NamedLines{6, 92, 202}));
  // A clock that was set is named where it was.
  record = clean_record();
  record.mount.clear();
  for (std::size_t row = 150; row < 300; ++row) record.time[row] -= 750.0;
  EXPECT_EQ(finding_of(judged(record, Ols{}, paper_terms()), Code::time_backwards).lines, NamedLines{152});
}

TEST(DiagnosisOfRepetitions, KnowsPassesInCoarseSteps) {
  std::vector<Acceleration> inputs;
  for (int pass = 0; pass < 2; ++pass) {
    for (int level = -12; level <= 12; ++level)
      inputs.push_back({.i = 0.91 * level + 1e-3 * level * level, .o = 0.0, .p = 0.0});
  }
  const TermList terms{Term::K0, Term::Ki, Term::Kii};
  for (const double step : {1e-3, 1e-2}) {
    Dataset record = record_of(inputs);
    const double per_g = std::nearbyint(1.0 / step);
    for (double& e : record.output) e = std::nearbyint(e * per_g) / per_g;
    EXPECT_FALSE(has(judged(record, Ols{}, terms), Code::rows_duplicated)) << step;
  }
  Dataset pasted = record_of(inputs);
  for (std::size_t row = 25; row < 50; ++row) pasted.output[row] = pasted.output[row - 25];
  EXPECT_TRUE(has(judged(pasted, Ols{}, terms), Code::rows_duplicated));
}

// Positions whose inputs have errors of 1 mg, of which the record says nothing.
Dataset with_input_errors(std::uint64_t seed) {
  std::vector<Acceleration> inputs;
  for (const Acceleration& a : two_planes(24)) inputs.insert(inputs.end(), 2, a);
  Dataset record = record_of(inputs, seed);
  RandomStream random(seed, stream_id("input errors"));
  for (std::vector<double>& axis : record.acceleration) {
    for (double& a : axis) a += 1e-3 * random.normal();
  }
  return record;
}

TEST(DiagnosisOfConstants, GoesByTheUncertaintyOfTheOptions) {
  const Method eiv = Eiv{.uncertainty = {.input = 1e-3}};
  for (const std::uint64_t seed : {3U, 4U, 5U, 6U, 7U, 8U}) {
    Dataset record = with_input_errors(seed);
    record.output_sigma.assign(record.rows(), kNoise);
    EXPECT_EQ(warnings(judged(record, eiv)), NamedCodes()) << seed;
    // The output's noise differs between rows, and that of the inputs hides it.
    RandomStream random(seed, stream_id("uneven"));
    for (std::size_t row = 0; row < record.rows(); row += 2) {
      record.output_sigma[row] = 1e-3;
      record.output[row] += 1e-3 * random.normal();
    }
    EXPECT_EQ(warnings(judged(record, eiv)), NamedCodes()) << seed;
  }
}

TEST(DiagnosisOfFarRows, SeesTwoInFive) {
  for (const std::vector<Acceleration>& inputs : {plane(24), two_planes(24), two_planes(36)}) {
    Dataset record = record_of(inputs);
    std::size_t other = 0;
    for (std::size_t row = 0; row < record.rows(); ++row) {
      if (row * 7 % 10 >= 4) continue;
      record.output[row] *= 1.01;
      ++other;
    }
    const Identification result = judged(record);
    ASSERT_EQ(warnings(result), NamedCodes{Code::rows_far_off}) << inputs.size();
    EXPECT_GT(2 * finding_of(result, Code::rows_far_off).lines.size(), other) << inputs.size();
  }
}

TEST(DiagnosisOfFarRows, SaysByWhatARowWasTested) {
  Dataset record = clean_record();
  for (std::size_t row = 0; row < record.rows(); row += 2) {
    record.output_sigma[row] = 100.0 * kNoise;
    record.output[row] += 100.0 * kNoise * std::sin(static_cast<double>(row * row));
  }
  record.output[7] += 40.0 * kNoise;
  const Finding finding = finding_of(judged(record, Wls{}, paper_terms()), Code::rows_far_off);
  EXPECT_EQ(finding.lines, NamedLines{9});
  EXPECT_NEAR(test::number(finding, "residual"), 40.0 * kNoise, 10.0 * kNoise);
  EXPECT_LT(test::number(finding, "scale"), 3.0 * kNoise);
}

TEST(DiagnosisOfSigmas, SeesUnevenOnesBesideAFarRow) {
  Dataset record = clean_record();
  for (std::size_t row = 0; row < record.rows(); row += 3) record.output_sigma[row] *= 30.0;
  record.output[7] += 1000.0 * kNoise;
  const Identification result = judged(record, Ols{}, paper_terms());
  EXPECT_TRUE(has(result, Code::rows_far_off));
  EXPECT_TRUE(has(result, Code::sigma_output_uneven));
}

}  // namespace
}  // namespace proofmass
