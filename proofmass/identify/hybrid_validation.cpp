// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/hybrid_validation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/core/step_progress.hpp"
#include "proofmass/identify/design_matrix.hpp"
#include "proofmass/identify/hybrid_network.hpp"
#include "proofmass/identify/identifiability.hpp"
#include "proofmass/identify/network_data.hpp"
#include "proofmass/numeric/least_squares.hpp"
#include "proofmass/numeric/parallel.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kFolds = 5;

struct Fold {
  std::vector<double> with, without;  // errors at the rows left out
  std::size_t epochs = 0;
  std::size_t evaluations = 0;
};

Fold leave_out(const Dataset& training, std::size_t fold, const TermList& terms, std::size_t hidden,
               const IdentifyOptions& options, Progress& progress) {
  std::vector<std::size_t> kept, left;
  for (std::size_t r = 0; r < training.rows(); ++r) (r % kFolds == fold ? left : kept).push_back(r);
  const Dataset rows = training.select(kept);
  const Dataset out = training.select(left);
  Fold errors;
  if (analyse_identifiability(rows, terms).identified.size() < terms.size()) return errors;
  const StaticModel model{terms, solve_least_squares(design_matrix(rows, terms), rows.output).coefficients};
  const HybridFit fit = fit_hybrid(rows, terms, hidden, options, progress);
  const std::vector<double> predicted = network_outputs(fit.network, out);
  errors.epochs = fit.epochs;
  errors.evaluations = fit.evaluations;
  for (std::size_t r = 0; r < out.rows(); ++r) {
    errors.with.push_back(out.output[r] - predicted[r]);
    errors.without.push_back(out.output[r] - model.output(out.at(r)));
  }
  return errors;
}

}  // namespace

HybridValidation validate_hybrid(const Dataset& training, const TermList& terms, std::size_t hidden,
                                 const IdentifyOptions& options, Progress& progress) {
  std::array<Fold, kFolds> folds;
  StepProgress steps(progress, "cross-validation", kFolds);
  parallel_for(kFolds, [&](std::size_t k) {
    folds[k] = leave_out(training, k, terms, hidden, options, steps);
    steps.step();
  });
  HybridValidation result;
  double with = 0.0;
  double without = 0.0;
  double squares = 0.0;
  for (const Fold& fold : folds) {
    result.epochs += fold.epochs;
    result.evaluations += fold.evaluations;
    result.rows += fold.with.size();
    for (std::size_t r = 0; r < fold.with.size(); ++r) {
      const double a = fold.with[r] * fold.with[r];
      const double b = fold.without[r] * fold.without[r];
      with += a;
      without += b;
      squares += (b - a) * (b - a);
    }
  }
  if (result.rows == 0) return result;
  const auto n = static_cast<double>(result.rows);
  result.rmse_with = std::sqrt(with / n);
  result.rmse_without = std::sqrt(without / n);
  result.gain = (without - with) / n;
  result.standard_error = std::sqrt(std::max(0.0, squares / n - result.gain * result.gain) / n);
  return result;
}

}  // namespace proofmass
