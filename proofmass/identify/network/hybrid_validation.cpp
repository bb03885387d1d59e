// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/hybrid_validation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/core/step_progress.hpp"
#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/network/hybrid_network.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/parallel.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kFolds = 5;

struct Fold {
  std::vector<std::size_t> rows;      // left out; none where the others do not identify every term
  std::vector<double> with, without;  // errors there
  std::size_t epochs = 0;
  std::size_t evaluations = 0;
};

// For each row the number of its set-up, counted from the first: rows of the same accelerations share one,
// for a network would know the errors of a row left out from its copy.
std::vector<std::size_t> number_set_ups(const Dataset& training) {
  std::map<std::array<double, 3>, std::size_t> numbers;
  std::vector<std::size_t> set_ups;
  for (std::size_t r = 0; r < training.rows(); ++r) {
    const Acceleration a = training.at(r);
    set_ups.push_back(numbers.try_emplace({a.i, a.o, a.p}, numbers.size()).first->second);
  }
  return set_ups;
}

Fold leave_out(const Hybrid& method, const Dataset& training, const std::vector<std::size_t>& set_ups,
               std::size_t fold, const TermList& terms, std::size_t hidden, std::uint64_t seed,
               Progress& progress) {
  std::vector<std::size_t> kept, left;
  for (std::size_t r = 0; r < training.rows(); ++r) {
    (set_ups[r] % kFolds == fold ? left : kept).push_back(r);
  }
  const Dataset rows = training.select(kept);
  const Dataset out = training.select(left);
  Fold errors;
  if (analyse_identifiability(rows, terms).identified.size() < terms.size()) return errors;
  const StaticModel model{terms, solve_least_squares(design_matrix(rows, terms), rows.output).coefficients};
  const HybridFit fit = fit_hybrid(method, rows, terms, hidden, seed, progress);
  const std::vector<double> predicted = network_outputs(fit.network, out);
  errors.rows = std::move(left);
  errors.epochs = fit.epochs;
  errors.evaluations = fit.evaluations;
  for (std::size_t r = 0; r < out.rows(); ++r) {
    errors.with.push_back(out.output[r] - predicted[r]);
    errors.without.push_back(out.output[r] - model.output(out.at(r)));
  }
  return errors;
}

}  // namespace

HybridValidation validate_hybrid(const Hybrid& method, const Dataset& training, const TermList& terms,
                                 std::size_t hidden, std::uint64_t seed, Progress& progress) {
  const std::vector<std::size_t> set_ups = number_set_ups(training);
  std::array<Fold, kFolds> folds;
  StepProgress steps(progress, "cross-validation", kFolds);
  parallel_for(kFolds, [&](std::size_t k) {
    folds[k] = leave_out(method, training, set_ups, k, terms, hidden, seed, steps);
    steps.step();
  });
  HybridValidation result;
  double with = 0.0;
  double without = 0.0;
  std::vector<double> gains(training.rows(), 0.0);      // of each set-up
  std::vector<std::size_t> counts(training.rows(), 0);  // of its rows
  for (const Fold& fold : folds) {
    result.epochs += fold.epochs;
    result.evaluations += fold.evaluations;
    result.rows += fold.rows.size();
    for (std::size_t r = 0; r < fold.rows.size(); ++r) {
      const double a = fold.with[r] * fold.with[r];
      const double b = fold.without[r] * fold.without[r];
      with += a;
      without += b;
      gains[set_ups[fold.rows[r]]] += b - a;
      ++counts[set_ups[fold.rows[r]]];
    }
  }
  if (result.rows == 0) return result;
  const auto n = static_cast<double>(result.rows);
  result.rmse_with = std::sqrt(with / n);
  result.rmse_without = std::sqrt(without / n);
  result.gain = (without - with) / n;
  // The rows of a set-up share their gain, so that set-ups and not rows are independent.
  double squares = 0.0;
  for (std::size_t s = 0; s < gains.size(); ++s) {
    const double deviation = gains[s] - static_cast<double>(counts[s]) * result.gain;
    squares += deviation * deviation;
  }
  result.standard_error = std::sqrt(squares) / n;
  return result;
}

}  // namespace proofmass
