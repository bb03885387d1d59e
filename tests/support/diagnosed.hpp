// SPDX-License-Identifier: Apache-2.0
// A clean record, faults that tests of diagnosis put into it, and what is said of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"
#include "support/twin.hpp"

namespace proofmass::test {

inline constexpr double kNoise = 1e-5;  // g

// 300 rows in random directions, 1 to 20 g, with a clock, a steady room, six mounts and right uncertainties.
inline Dataset clean_record(std::uint64_t seed = 3) {
  Dataset record = make_twin({.noise = kNoise, .seed = seed});
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

inline Run diagnosed(const Dataset& record, const Method& method = Ols{},
                     const TermList& terms = paper_terms()) {
  return identify(record, method, {.terms = terms, .on_rank_loss = RankLossPolicy::drop});
}

inline std::vector<Code> warnings(const Identification& result) {
  std::vector<Code> codes;
  for (const Finding& finding : result.findings) {
    if (finding.severity == Severity::warning) codes.push_back(finding.code);
  }
  return codes;
}

// In 1 g: a dividing head that turns about one axis, then another.
inline void tumble(Dataset& record, double one_g) {
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

inline void clip(Dataset& record, double limit) {
  for (double& e : record.output) e = std::clamp(e, -limit, limit);
}

template <typename Function>
void add_to_output(Dataset& record, const Function& function) {
  for (std::size_t row = 0; row < record.rows(); ++row) record.output[row] += function(row);
}

inline void shift_outputs(Dataset& record) {
  std::rotate(record.output.begin(), record.output.begin() + 2, record.output.end());
}

}  // namespace proofmass::test
