// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/truth.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "proofmass/assess/efficient_bound.hpp"
#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

bool noisy_inputs(const SimulationPlan& plan) {
  return std::any_of(plan.input_sigma.begin(), plan.input_sigma.end(),
                     [](double sigma) { return sigma > 0.0; });
}

// Location information of the plan's noise of scale 1 where its scale is `scale` g. Outliers are as many
// scales away as that makes them; distances within a hundredth share a value.
class NoiseInformation {
 public:
  explicit NoiseInformation(const OutputNoise& noise) : noise_(noise) {}
  double operator()(double scale) {
    LocationDensity density{.dof = noise_.student_dof.value_or(0.0), .fraction = noise_.outlier_fraction};
    if (density.fraction == 0.0) return location_information(density);
    const double distance = noise_.outlier_magnitude / scale;
    const long key = std::lround(100.0 * std::log(std::max(distance, 1e-6)));
    const auto [found, fresh] = known_.try_emplace(key, 0.0);
    density.distance = distance;
    if (fresh) found->second = location_information(density);
    return found->second;
  }

 private:
  const OutputNoise& noise_;
  std::map<long, double> known_;
};

// A term left out by choice was there to be identified.
bool counts(const Coefficient& c) { return c.identified || c.left_out; }

std::vector<double> bound_of(const Identification& run, const Dataset& training,
                             std::span<const double> information) {
  TermList terms;
  for (const Coefficient& c : run.coefficients) {
    if (counts(c)) terms.push_back(c.term);
  }
  const std::vector<double> errors = efficient_errors(training, terms, information);
  std::vector<double> bound(run.coefficients.size(), 0.0);
  std::size_t next = 0;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    if (counts(run.coefficients[k])) bound[k] = errors[next++];
  }
  return bound;
}

std::vector<std::vector<double>> bounds_of(const Contestant& contestant, const Dataset& record,
                                           std::span<const double> information) {
  std::vector<std::vector<double>> bounds;
  if (information.empty()) return bounds;
  for (const Run& run : contestant.runs) {
    std::vector<double> weights;
    for (const std::size_t row : run.split.training) weights.push_back(information[row]);
    bounds.push_back(bound_of(run.identification, record.select(run.split.training), weights));
  }
  return bounds;
}

}  // namespace

void require_same_output(const SimulationPlan& plan, const Dataset& record) {
  if (record.output_unit.canonical_symbol() == plan.output_unit.canonical_symbol()) return;
  throw usage_error(message("the truth's output is in {}, the record's in {}: they must agree",
                            plan.output_unit.canonical_symbol(), record.output_unit.canonical_symbol()));
}

std::vector<double> output_variances(const SimulationPlan& plan, const Dataset& record) {
  const StaticModel truth = plan.truth();
  std::vector<double> variances;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const Acceleration a = record.at(row);
    double variance = std::pow(plan.output_per_g * plan.noise.scale(std::hypot(a.i, a.o, a.p)), 2);
    if (noisy_inputs(plan)) variance += truth.variance_from_inputs(a, plan.input_sigma);
    variances.push_back(variance);
  }
  return variances;
}

std::vector<double> row_information(const SimulationPlan& plan, const Dataset& record) {
  const bool normal = !plan.noise.student_dof && plan.noise.outlier_fraction == 0.0;
  if (noisy_inputs(plan) && !normal) return {};
  const std::vector<double> variances = output_variances(plan, record);
  NoiseInformation shape(plan.noise);
  std::vector<double> information;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (!(variances[row] > 0.0)) return {};
    const Acceleration a = record.at(row);
    const double scale = plan.noise.scale(std::hypot(a.i, a.o, a.p));
    information.push_back((normal ? 1.0 : shape(scale)) / variances[row]);
  }
  return information;
}

void score_truth(Comparison& comparison, const Dataset& record, const SimulationPlan& plan) {
  require_same_output(plan, record);
  const std::vector<double> information = row_information(plan, record);
  const StaticModel truth = plan.truth();
  comparison.truth = truth;
  for (Contestant& contestant : comparison.contestants) {
    contestant.truth = score_against(truth, contestant.runs, bounds_of(contestant, record, information));
  }
}

}  // namespace proofmass
