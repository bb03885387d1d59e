// SPDX-License-Identifier: Apache-2.0
// Faults put into clean records, and what is said of each; scripts/false-alarms.sh counts what is said of
// records without fault.
#include "proofmass/assess/diagnosis/diagnosis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"
#include "support/findings.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

constexpr double kNoise = 1e-5;  // g

// 300 rows in random directions, 1 to 20 g, with a clock, a steady room, six mounts and right uncertainties.
Dataset clean_record(std::uint64_t seed = 3) {
  Dataset record = test::make_twin({.noise = kNoise, .seed = seed});
  RandomStream random(seed, stream_id("room"));
  for (std::size_t row = 0; row < record.rows(); ++row) {
    record.time.push_back(5.0 * static_cast<double>(row));
    record.temperature.push_back(22.0 + 0.1 * random.normal());
    record.mount.push_back("P" + std::to_string(random.index(6)));
    record.output_sigma.push_back(kNoise);
    record.line.push_back(row + 2);
  }
  return record;
}

Run diagnosed(const Dataset& record, const Method& method = Ols{}, const TermList& terms = paper_terms()) {
  return identify(record, method, {.terms = terms, .on_rank_loss = RankLossPolicy::drop});
}

std::vector<Code> warnings(const Identification& result) {
  std::vector<Code> codes;
  for (const Finding& finding : result.findings) {
    if (finding.severity == Severity::warning) codes.push_back(finding.code);
  }
  return codes;
}

struct Fault {
  Code code;
  std::string name;
  std::function<void(Dataset&)> put_into;
  TermList terms = paper_terms();
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

std::string name_of(const testing::TestParamInfo<Fault>& info) {
  return std::string(to_string(info.param.code)) + "_" + info.param.name;
}

class Diagnosis : public testing::TestWithParam<Fault> {};

TEST_P(Diagnosis, SaysWhatIsWrongAndNothingOfACleanRecord) {
  for (const std::uint64_t seed : {3U, 4U, 5U}) {
    Dataset record = clean_record(seed);
    EXPECT_EQ(warnings(diagnosed(record).identification), std::vector<Code>()) << seed;
    GetParam().put_into(record);
    const Identification result = diagnosed(record, Ols{}, GetParam().terms).identification;
    EXPECT_TRUE(test::has(result, GetParam().code)) << seed;
    EXPECT_EQ(test::finding_of(result, GetParam().code).severity, Severity::warning) << seed;
  }
}

// In 1 g: a dividing head that turns about one axis, then another.
void tumble(Dataset& record, double one_g) {
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const double angle = 0.1 * static_cast<double>(row);
    const bool about_pa = row % 2 == 0;
    const Acceleration a{
        .i = std::cos(angle), .o = about_pa ? std::sin(angle) : 0.0, .p = about_pa ? 0.0 : std::sin(angle)};
    record.output[row] = 0.01 + a.i + 1e-4 * a.o;
    for (const Axis axis : kAxes) {
      const double along = axis == Axis::input ? a.i : axis == Axis::output ? a.o : a.p;
      record.acceleration[static_cast<std::size_t>(axis)][row] = one_g * along;
    }
  }
}

void to_counts(Dataset& record, double per_g) {
  record.output_unit = find_unit("counts").value();
  record.output_sigma.clear();
  for (double& e : record.output) e = std::nearbyint(per_g * e);
}

void clip(Dataset& record, double limit) {
  for (double& e : record.output) e = std::clamp(e, -limit, limit);
}

template <typename Function>
void add_to_output(Dataset& record, const Function& function) {
  for (std::size_t row = 0; row < record.rows(); ++row) record.output[row] += function(row);
}

void wander(Dataset& record) {
  RandomStream random(9, stream_id("wander"));
  double state = 0.0;
  add_to_output(record, [&](std::size_t) { return state = 0.5 * state + 2.0 * kNoise * random.normal(); });
}

// A meter whose reading saturates, or folds back, with noise of its own.
void saturate(Dataset& record, double limit, double beyond) {
  RandomStream random(11, stream_id("saturate"));
  for (double& e : record.output) {
    if (std::abs(e) > limit)
      e = std::copysign(limit + beyond * (std::abs(e) - limit), e) + kNoise * random.normal();
  }
}

// A converter whose range is `span` about zero, or from zero up.
void run_over(Dataset& record, double span, bool is_signed) {
  record.output_sigma.clear();
  for (double& e : record.output) e -= span * std::floor(e / span + (is_signed ? 0.5 : 0.0));
}

void scale_output(Dataset& record, const std::function<double(std::size_t)>& change) {
  for (std::size_t row = 0; row < record.rows(); ++row) record.output[row] *= 1.0 + change(row);
}

void repeat_rows(Dataset& record) {
  std::vector<std::size_t> rows(record.rows());
  for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = row < 280 ? row : row - 200;
  record = record.select(rows);
}

// 20 positions with three readings each, and the whole record once more.
void repeat_readings(Dataset& record) {
  for (std::size_t row = 0; row < 60; ++row) {
    const std::size_t position = row - row % 3;
    for (std::vector<double>& axis : record.acceleration) {
      record.output[row] += axis[position] - axis[row];
      axis[row] = axis[position];
    }
  }
  std::vector<std::size_t> rows(120);
  for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = row % 60;
  record = record.select(rows);
}

void shift_outputs(Dataset& record) {
  std::rotate(record.output.begin(), record.output.begin() + 2, record.output.end());
}

// Six mounts of 50 rows, each with one radial axis, whose outputs are those of the row before.
void shift_mounts(Dataset& record) {
  RandomStream random(8, stream_id("mounts"));
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const std::size_t mount = row / 50;
    record.mount[row] = "P" + std::to_string(mount);
    for (std::vector<double>& axis : record.acceleration) axis[row] = 0.0;
    record.acceleration[mount % 3][row] = (mount < 3 ? 1.0 : -1.0) * static_cast<double>(1 + row % 50);
    record.acceleration[(mount + 1) % 3][row] = 1.0;
    record.output[row] = 0.001 + record.acceleration[0][row] + kNoise * random.normal();
  }
  std::rotate(record.output.begin(), record.output.end() - 1, record.output.end());
}

// A dividing head's angles; `unit` of them is a degree.
void as_angles(Dataset& record, double unit) {
  RandomStream random(7, stream_id("angles"));
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const double degrees = 15.0 * static_cast<double>(random.index(24));
    record.acceleration[0][row] = degrees * unit;
    record.output[row] = 1.25 * std::cos(degrees * std::numbers::pi / 180.0) + kNoise * random.normal();
  }
  record.acceleration[1].clear();
  record.acceleration[2].clear();
}

std::vector<Fault> faults() {
  const auto scale = [](double factor) {
    return [factor](Dataset& r) {
      for (double& e : r.output) e *= factor;
      for (double& s : r.output_sigma) s *= std::abs(factor);
    };
  };
  const auto drop_sigma = [](Dataset& r) { r.output_sigma.clear(); };
  return {
      {Code::inputs_in_other_unit, "si_in_g", [](Dataset& r) { tumble(r, kStandardGravity); },
       linear_terms()},
      {Code::inputs_in_other_unit, "g_in_si",
       [](Dataset& r) {
         r.acceleration_unit = find_unit("m/s^2").value();
         tumble(r, 1.0 / kStandardGravity);
       },
       linear_terms()},
      {Code::output_clipped, "both", [](Dataset& r) { clip(r, 14.0); }},
      {Code::output_clipped, "coarse",
       [](Dataset& r) {
         to_counts(r, 100.0);
         clip(r, 1500.0);
       }},
      {Code::output_saturated, "noisy", [](Dataset& r) { saturate(r, 14.0, 0.0); }},
      {Code::output_saturated, "folds_back", [](Dataset& r) { saturate(r, 14.0, -1.0); }},
      {Code::output_stuck, "noisy",
       [](Dataset& r) {
         RandomStream random(12, stream_id("stuck"));
         for (std::size_t row = 60; row < 70; ++row) r.output[row] = r.output[60] + kNoise * random.normal();
       }},
      {Code::output_repeated, "zero_in_every_second_row",
       [](Dataset& r) {
         for (std::size_t row = 1; row < r.rows(); row += 2) r.output[row] = 0.0;
       }},
      {Code::output_held, "stuck", [](Dataset& r) { std::fill_n(r.output.begin() + 40, 8, r.output[40]); }},
      {Code::output_held, "pairs",
       [](Dataset& r) {
         for (std::size_t row = 1; row < r.rows(); row += 2) r.output[row] = r.output[row - 1];
       }},
      {Code::output_wrapped, "unsigned_16_bits",
       [](Dataset& r) {
         to_counts(r, 1500.0);
         for (double& e : r.output) e += e < 0.0 ? 65'536.0 : 0.0;
       }},
      {Code::output_wrapped, "unsigned_24_bits",
       [](Dataset& r) {
         to_counts(r, 300'000.0);
         for (double& e : r.output) e += e < 0.0 ? 16'777'216.0 : 0.0;
       }},
      {Code::output_wrapped, "means_of_12_bits",
       [](Dataset& r) {
         to_counts(r, 90.0);
         for (double& e : r.output) e += e < 0.0 ? 4096.25 : 0.25;
       }},
      {Code::output_wrapped, "signed_16_bits",
       [](Dataset& r) {
         to_counts(r, 2200.0);
         run_over(r, 65'536.0, true);
       }},
      {Code::output_wrapped, "unsigned_32_bits",
       [](Dataset& r) {
         to_counts(r, 9e7);
         run_over(r, 4'294'967'296.0, false);
       }},
      {Code::output_wrapped, "volts", [](Dataset& r) { run_over(r, 20.0, true); }},
      {Code::output_wrapped, "several_turns", [](Dataset& r) { run_over(r, 6.0, true); }},
      {Code::rows_duplicated, "block", repeat_rows},
      {Code::rows_duplicated, "readings_of_positions", repeat_readings},
      {Code::time_backwards, "once", [](Dataset& r) { r.time[100] = 1.0; }},
      {Code::time_standing, "stopped",
       [](Dataset& r) { std::fill(r.time.begin() + 200, r.time.end(), 1000.0); }},
      {Code::time_standing, "twice", [](Dataset& r) { r.time[100] = r.time[99]; }},
      {Code::scale_factor_negative, "any", scale(-1.0)},
      {Code::scale_factor_unlike_one, "milli", scale(1000.0)},
      {Code::cross_axis_larger, "swapped",
       [](Dataset& r) { std::swap(r.acceleration[0], r.acceleration[2]); }},
      {Code::few_degrees_of_freedom, "three",
       [](Dataset& r) {
         std::vector<std::size_t> rows(18);
         for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = row;
         r = r.select(rows);
       }},
      {Code::rows_shifted, "two_up", shift_outputs},
      {Code::rows_shifted, "one_down_by_mounts", shift_mounts},
      {Code::inputs_are_angles, "degrees", [](Dataset& r) { as_angles(r, 1.0); }, {Term::K0, Term::Ki}},
      {Code::inputs_are_angles,
       "radians",
       [](Dataset& r) { as_angles(r, std::numbers::pi / 180.0); },
       {Term::K0, Term::Ki}},
      {Code::output_unsigned, "rectified",
       [](Dataset& r) {
         for (double& e : r.output) e = std::abs(e);
       }},
      {Code::output_copies_input, "ai", [](Dataset& r) { r.acceleration[0] = r.output; }},
      {Code::inputs_too_large, "micro_g",
       [](Dataset& r) {
         for (std::vector<double>& axis : r.acceleration) {
           for (double& a : axis) a *= 1e6;
         }
       }},
      {Code::magnitude_unlike_others, "mistyped_ai",
       [](Dataset& r) {
         tumble(r, 1.0);
         r.acceleration[0][40] += 0.1;
       },
       linear_terms()},
      {Code::magnitude_unlike_others, "mistyped_ao",
       [](Dataset& r) {
         tumble(r, 1.0);
         r.acceleration[1][40] += 0.05;
       },
       linear_terms()},
      {Code::temperature_implausible, "mark", [](Dataset& r) { r.temperature[7] = -999.0; }},
      {Code::gross_misfit, "two_units",
       [](Dataset& r) {
         for (std::size_t row = 0; row < r.rows(); row += 3) {
           for (std::vector<double>& axis : r.acceleration) axis[row] *= kStandardGravity;
         }
       }},
      {Code::rows_far_off, "one", [](Dataset& r) { r.output[7] += 1000.0 * kNoise; }},
      {Code::rows_far_off, "sign", [](Dataset& r) { r.output[7] *= -1.0; }},
      {Code::rows_far_off, "a_tenth",
       [](Dataset& r) { add_to_output(r, [](std::size_t row) { return row % 10 == 7 ? 1e-2 : 0.0; }); }},
      {Code::model_too_short, "linear", drop_sigma, linear_terms()},
      {Code::model_too_short, "quadratic", drop_sigma, quadratic_terms()},
      {Code::residuals_follow_time, "drift",
       [](Dataset& r) { add_to_output(r, [&](std::size_t row) { return 2e-8 * r.time[row]; }); }},
      {Code::residuals_follow_time, "warm_up",
       [](Dataset& r) {
         add_to_output(r, [&](std::size_t row) { return 5e-5 * std::exp(-r.time[row] / 200.0); });
       }},
      {Code::residuals_follow_temperature, "slope",
       [](Dataset& r) {
         add_to_output(r, [&](std::size_t row) { return 5e-5 * (r.temperature[row] - 22.0); });
       }},
      {Code::residuals_follow_order, "drift",
       [](Dataset& r) {
         r.time.clear();
         add_to_output(r, [](std::size_t row) { return 1e-7 * static_cast<double>(row); });
       }},
      {Code::residuals_follow_mount, "one",
       [](Dataset& r) {
         add_to_output(r, [&](std::size_t row) { return r.mount[row] == "P2" ? 2.0 * kNoise : 0.0; });
       }},
      {Code::residuals_follow_mount, "each",
       [](Dataset& r) {
         add_to_output(r, [&](std::size_t row) { return kNoise * (r.mount[row][1] % 3 - 1.0); });
       }},
      {Code::scale_factor_follows_time, "drift",
       [](Dataset& r) { scale_output(r, [&](std::size_t row) { return 4e-9 * r.time[row]; }); }},
      {Code::scale_factor_follows_temperature, "slope",
       [](Dataset& r) {
         scale_output(r, [&](std::size_t row) { return 1e-5 * (r.temperature[row] - 22.0); });
       }},
      {Code::scale_factor_follows_order, "drift",
       [](Dataset& r) {
         r.time.clear();
         scale_output(r, [](std::size_t row) { return 2e-8 * static_cast<double>(row); });
       }},
      {Code::scale_factor_follows_mount, "one",
       [](Dataset& r) {
         scale_output(r, [&](std::size_t row) { return r.mount[row] == "P2" ? 1e-5 : 0.0; });
       }},
      {Code::alignment_follows_mount, "one",
       [](Dataset& r) {
         add_to_output(
             r, [&](std::size_t row) { return r.mount[row] == "P2" ? 1e-5 * r.acceleration[1][row] : 0.0; });
       }},
      {Code::residuals_follow_inputs, "gain_by_sign",
       [](Dataset& r) {
         add_to_output(r, [&](std::size_t row) { return 2e-5 * std::max(0.0, r.acceleration[0][row]); });
       }},
      {Code::residuals_follow_inputs, "step_across",
       [](Dataset& r) {
         add_to_output(r, [&](std::size_t row) { return std::copysign(2e-5, r.acceleration[2][row]); });
       }},
      {Code::residuals_follow_inputs, "other",
       [](Dataset& r) {
         add_to_output(r, [&](std::size_t row) { return 3e-5 * std::cos(r.acceleration[0][row]); });
       }},
      {Code::rows_far_off, "many",
       [](Dataset& r) { scale_output(r, [](std::size_t row) { return row * 7 % 10 < 3 ? 1e-2 : 0.0; }); }},
      {Code::residuals_correlated, "wanders", wander},
      {Code::sigma_output_too_small, "by_0_7",
       [](Dataset& r) {
         for (double& s : r.output_sigma) s *= 0.7;
       }},
      {Code::sigma_output_too_large, "by_1_4",
       [](Dataset& r) {
         for (double& s : r.output_sigma) s *= 1.4;
       }},
      {Code::sigma_output_uneven, "a_fifth_too_large",
       [](Dataset& r) {
         for (std::size_t row = 0; row < r.rows(); row += 5) r.output_sigma[row] *= 1000.0;
       }},
      {Code::sigma_output_uneven, "a_fifth_too_small",
       [](Dataset& r) {
         for (std::size_t row = 0; row < r.rows(); row += 5) r.output_sigma[row] *= 1e-3;
       }},
      {Code::sigma_inputs_unused, "one_axis",
       [](Dataset& r) { r.acceleration_sigma[0].assign(r.rows(), kNoise); }},
  };
}

INSTANTIATE_TEST_SUITE_P(Faults, Diagnosis, testing::ValuesIn(faults()), name_of);

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
  EXPECT_EQ(reason([](Dataset& r) { r.output[7] = 400.0; }, paper_terms()), "rows");
}

TEST(DiagnosisOfShift, NamesRowsAndDirection) {
  Dataset record = clean_record();
  shift_outputs(record);
  const Finding up = test::finding_of(diagnosed(record).identification, Code::rows_shifted);
  EXPECT_EQ(test::number(up, "shift"), 2.0);
  EXPECT_EQ(test::word(up, "direction"), "above");
  EXPECT_FALSE(test::has(diagnosed(record).identification, Code::gross_misfit));
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
