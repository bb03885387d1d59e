// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/truth_doubts.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <utility>

#include "proofmass/study/truth.hpp"

namespace proofmass {
namespace {

constexpr double kFewSigmas = 6.0;  // of an input's noise, or of a median
// Standard deviation of the median of n magnitudes over its value, times the root of n: 1.17 for the normal,
// 1.4 for Student's t with 3 degrees of freedom.
constexpr double kMedianSpread = 1.4;
constexpr double kRounding = 1e-9;

// Least and largest |A| of the rows.
std::pair<double, double> magnitudes(const Dataset& rows) {
  std::pair<double, double> range{magnitude(rows.at(0)), magnitude(rows.at(0))};
  for (std::size_t row = 1; row < rows.rows(); ++row) {
    const double size = magnitude(rows.at(row));
    range = {std::min(range.first, size), std::max(range.second, size)};
  }
  return range;
}

std::pair<double, double> planned_magnitudes(const SimulationPlan& plan) {
  if (plan.sphere) return {plan.sphere->minimum, plan.sphere->maximum};
  SimulationPlan exact = plan;
  exact.input_sigma = {};
  exact.record_sigma = false;
  return magnitudes(simulate(exact, plan.mounted->points(), plan.seed));
}

void doubt_inputs(const SimulationPlan& plan, const Dataset& record, std::vector<Finding>& doubts) {
  const auto [least, largest] = magnitudes(record);
  const auto [from, to] = planned_magnitudes(plan);
  const auto& sigma = plan.input_sigma;
  const double room = kFewSigmas * std::hypot(sigma[0], sigma[1], sigma[2]) + kRounding * to;
  if (least >= from - room && largest <= to + room) return;
  doubts.push_back({.code = Code::inputs_unlike_plan,
                    .severity = Severity::warning,
                    .figures = {{"least", least}, {"largest", largest}, {"from", from}, {"to", to}}});
}

// The magnitude that half of the plan's noise stays below, in scales.
double median_magnitude(const OutputNoise& noise) {
  const double fraction = 0.5 + 0.25 / std::max(0.5, 1.0 - noise.outlier_fraction);
  const double probability = std::min(fraction, 0.99);
  if (!noise.student_dof) return boost::math::quantile(boost::math::normal(), probability);
  return boost::math::quantile(boost::math::students_t(*noise.student_dof), probability);
}

void doubt_outputs(const SimulationPlan& plan, const Dataset& record, std::vector<Finding>& doubts) {
  const std::vector<double> variances = output_variances(plan, record);
  const StaticModel truth = plan.truth();
  std::vector<double> distances;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (!(variances[row] > 0.0)) return;
    const Acceleration a = record.at(row);
    const double expected = truth.output(a) + plan.output_per_g * plan.unmodelled.output(a);
    distances.push_back(std::abs(record.output[row] - expected) / std::sqrt(variances[row]));
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  const double ratio = *middle / median_magnitude(plan.noise);
  const double room = 0.05 + kFewSigmas * kMedianSpread / std::sqrt(static_cast<double>(record.rows()));
  if (ratio > 0.0 && std::abs(std::log(ratio)) <= room) return;
  doubts.push_back(
      {.code = Code::outputs_unlike_plan, .severity = Severity::warning, .figures = {{"ratio", ratio}}});
}

}  // namespace

std::vector<Finding> doubts_about_truth(const SimulationPlan& plan, const Dataset& record,
                                        const std::string& named) {
  require_same_output(plan, record);
  std::vector<Finding> doubts;
  if (!named.empty() && named != plan.source) {
    doubts.push_back({.code = Code::other_plan_named,
                      .severity = Severity::warning,
                      .figures = {{"named", named}, {"plan", plan.source}}});
  }
  doubt_inputs(plan, record, doubts);
  doubt_outputs(plan, record, doubts);
  return doubts;
}

}  // namespace proofmass
