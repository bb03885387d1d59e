// SPDX-License-Identifier: Apache-2.0
// Faults put into clean records, and what is said of each; scripts/false-alarms.sh counts what is said of
// records without fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "proofmass/assess/diagnosis/diagnosis.hpp"
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

void to_counts(Dataset& record, double per_g) {
  record.output_unit = find_unit("counts").value();
  record.output_sigma.clear();
  for (double& e : record.output) e = std::nearbyint(per_g * e);
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
      {Code::input_far_off, "mark_across",
       [](Dataset& r) {
         r.acceleration[1][20] = -999.0;
         r.acceleration[1][70] = -999.0;
       }},
      {Code::magnitude_unlike_others, "position_in_si",
       [](Dataset& r) {
         tumble(r, 1.0);
         // Three readings of one position, in m/s².
         for (const std::size_t row : {42U, 41U, 40U}) {
           for (std::vector<double>& axis : r.acceleration) axis[row] = kStandardGravity * axis[40];
           r.output[row] = r.output[40];
         }
       },
       linear_terms()},
      {Code::output_far_off, "overload",
       [](Dataset& r) {
         r.output[20] = 99'999.0;
         r.output[70] = -99'999.0;
       }},
      {Code::sigma_output_far_off, "mark", [](Dataset& r) { r.output_sigma[20] = 999.0; }},
      {Code::square_larger, "squared",
       [](Dataset& r) {
         for (double& e : r.output) e *= e;
       }},
      {Code::inputs_in_other_unit, "one_axis_of_a_tumble",
       [](Dataset& r) {
         tumble(r, 1.0);
         for (double& a : r.acceleration[1]) a *= kStandardGravity;
       },
       linear_terms()},
      {Code::cross_axis_large, "six_degrees_in_volts",
       [](Dataset& r) {
         r.output_unit = find_unit("V").value();
         add_to_output(r, [&](std::size_t row) { return 0.1 * r.acceleration[2][row]; });
       }},
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
      {Code::residuals_follow_inputs, "hysteresis",
       [](Dataset& r) {
         const std::vector<double> a = r.acceleration[0];
         add_to_output(r, [&a](std::size_t row) { return row > 0 && a[row] > a[row - 1] ? 2e-4 : 0.0; });
       }},
      {Code::residuals_follow_inputs, "other",
       [](Dataset& r) {
         add_to_output(r, [&](std::size_t row) { return 3e-5 * std::cos(r.acceleration[0][row]); });
       }},
      {Code::rows_far_off, "many",
       [](Dataset& r) { scale_output(r, [](std::size_t row) { return row * 7 % 10 < 3 ? 1e-2 : 0.0; }); }},
      {Code::rows_far_off, "two_fifths",
       [](Dataset& r) { scale_output(r, [](std::size_t row) { return row * 7 % 10 < 4 ? 1e-2 : 0.0; }); }},
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
         for (std::size_t row = 0; row < r.rows(); row += 5) r.output_sigma[row] *= 0.1;
       }},
      {Code::sigma_inputs_unused, "one_axis",
       [](Dataset& r) { r.acceleration_sigma[0].assign(r.rows(), kNoise); }},
  };
}

INSTANTIATE_TEST_SUITE_P(Faults, Diagnosis, testing::ValuesIn(faults()), name_of);

}  // namespace
}  // namespace proofmass
