// SPDX-License-Identifier: Apache-2.0
// Compares the errors of a method with the Cramér-Rao bound of a simulated record's noise.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "proofmass/assess/efficient_bound.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"

namespace proofmass::test {

inline SimulationPlan shipped_plan(const std::string& name) {
  return read_simulation(std::filesystem::path(PROOFMASS_SOURCE_DIR) / "data" / (name + ".toml"));
}

inline LocationDensity density_of(const OutputNoise& noise) {
  return {.dof = noise.student_dof.value_or(0.0),
          .fraction = noise.outlier_fraction,
          .distance = noise.outlier_fraction > 0.0 ? noise.outlier_magnitude / noise.sigma : 0.0};
}

// Smallest possible standard errors of an unbiased estimator of the terms from the record. The information
// matrix is XᵀWX, where W is the information about location over the square of each row's noise scale.
inline std::vector<double> cramer_rao_errors(const SimulationPlan& plan, const Dataset& record,
                                             const TermList& terms, double information) {
  std::vector<double> weights;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const Acceleration a = record.at(row);
    const double scale = plan.noise.scale(std::sqrt(a.i * a.i + a.o * a.o + a.p * a.p));
    weights.push_back(information / (scale * scale));
  }
  return efficient_errors(record, terms, weights);
}

// Root mean squares over terms and seeds of the coefficients' errors: over the Cramér-Rao errors, and over
// the standard errors that the method states.
struct Efficiency {
  double over_bound = 0.0;
  double over_stated = 0.0;
};

inline Efficiency measure_efficiency(const Method& method, const SimulationPlan& plan,
                                     const IdentifyOptions& options, std::uint64_t seeds) {
  const StaticModel truth = plan.truth();
  const double information = location_information(density_of(plan.noise));
  SilentProgress progress;
  double bound_squares = 0.0;
  double stated_squares = 0.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Dataset record = simulate(plan, plan.rows, seed);
    const std::vector<double> bound = cramer_rao_errors(plan, record, options.terms, information);
    const Identification result = fit(method, record, {}, options, progress);
    for (std::size_t k = 0; k < bound.size(); ++k) {
      const Coefficient& c = result.coefficients[k];
      const double error = c.value - truth.coefficient(c.term);
      bound_squares += error * error / (bound[k] * bound[k]);
      stated_squares += error * error / (*c.standard_error * *c.standard_error);
    }
  }
  const auto count = static_cast<double>(seeds * options.terms.size());
  return {.over_bound = std::sqrt(bound_squares / count), .over_stated = std::sqrt(stated_squares / count)};
}

}  // namespace proofmass::test
