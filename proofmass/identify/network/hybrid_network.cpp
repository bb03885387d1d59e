// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/hybrid_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/identify/network/separable_pool_internal.hpp"
#include "proofmass/identify/network/training/refinement.hpp"
#include "proofmass/identify/network/training/starts.hpp"
#include "proofmass/numeric/network/variable_projection.hpp"
#include "proofmass/numeric/optimise/particle_swarm.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// What the fits of one record share.
struct HybridProblem {
  PerceptronShape shape;
  TrainedNetwork scaling;
  Samples samples;
  TermList terms;              // without K0
  std::vector<double> scales;  // of the fixed columns
  ColumnBlock fixed;           // regressors over their largest values

  HybridProblem(const Dataset& training, const TermList& all, std::size_t hidden)
      : shape{training.axes().size(), hidden},
        scaling(learn_scaling(training)),
        samples(scale_rows(scaling, training)) {
    std::copy_if(all.begin(), all.end(), std::back_inserter(terms),
                 [](Term term) { return term != Term::K0; });
    fixed = ColumnBlock(terms.size(), samples.padded_rows());
    for (std::size_t c = 0; c < terms.size(); ++c) {
      double* const column = fixed.column(c);
      double largest = 0.0;
      for (std::size_t r = 0; r < training.rows(); ++r) {
        column[r] = regressor(terms[c], training.at(r));
        largest = std::max(largest, std::abs(column[r]));
      }
      for (std::size_t r = 0; r < training.rows(); ++r) column[r] /= largest;
      scales.push_back(largest);
    }
  }
};

SwarmResult seek(const HybridProblem& problem, const Hybrid& method, std::uint64_t seed,
                 const Progress& progress) {
  std::vector<std::vector<double>> initial;
  for (std::size_t i = 0; i < method.particles; ++i) {
    initial.push_back(random_start(problem.shape, Trainer::varpro, seed, i));
  }
  SwarmSettings settings;
  settings.iterations = method.iterations;
  const SeparablePool pool(problem.shape, problem.samples, problem.fixed);
  const auto objective = [&pool, &progress](std::span<const double> x) {
    return progress.cancelled() ? std::numeric_limits<double>::infinity() : pool.rmse(x);
  };
  return minimise_by_swarm(objective, std::move(initial), settings, seed,
                           [&progress](std::size_t, double) { return !progress.cancelled(); });
}

HybridFit assemble(const HybridProblem& problem, const Refinement& refinement) {
  // The trainer's figures count rounding as error: the output layer is solved once more for the result.
  SeparablePerceptron separable(problem.shape, problem.samples, problem.fixed);
  const auto hidden_end =
      refinement.best.weights.begin() + static_cast<std::ptrdiff_t>(problem.shape.hidden_weights());
  std::vector<double> weights(refinement.best.weights.begin(), hidden_end);
  const double sum_of_squares = separable.evaluate(weights);
  const std::vector<double>& output_weights = separable.output_weights();
  const auto network_end =
      output_weights.begin() + static_cast<std::ptrdiff_t>(problem.shape.output_weights());
  weights.insert(weights.end(), output_weights.begin(), network_end);

  HybridFit fit;
  fit.network = problem.scaling;
  fit.network.hidden = problem.shape.hidden;
  fit.network.weights = canonical_weights(problem.shape, weights);
  fit.network.skip.terms = problem.terms;
  const double half = output_half_range(problem.scaling);
  for (std::size_t c = 0; c < problem.terms.size(); ++c) {
    fit.network.skip.coefficients.push_back(half * network_end[static_cast<std::ptrdiff_t>(c)] /
                                            problem.scales[c]);
  }
  fit.rss = sum_of_squares * half * half;
  fit.parameters = problem.shape.parameters() + problem.terms.size();
  fit.curve = refinement.best.training_curve;
  fit.epochs = refinement.epochs;
  fit.training = training_end(refinement.best).status;
  return fit;
}

}  // namespace

HybridFit fit_hybrid(const Hybrid& method, const Dataset& training, const TermList& terms, std::size_t hidden,
                     std::uint64_t seed, Progress& progress) {
  const HybridProblem problem(training, terms, hidden);
  const SwarmResult swarm = seek(problem, method, seed, progress);
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
  std::vector<std::size_t> order(swarm.positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&swarm](std::size_t a, std::size_t b) { return swarm.values[a] < swarm.values[b]; });
  order.resize(std::min(order.size(), method.refined));

  // The terms are columns that variable projection alone solves for.
  const TrainingOptions training_options{.epochs = method.epochs, .perturbations = method.perturbations};
  const NetworkTrainer trainer(problem.shape, problem.samples, problem.fixed, training_options);
  std::vector<TrainingState> candidates;
  candidates.reserve(order.size());
  for (const std::size_t i : order) {
    candidates.push_back(trainer.start(swarm.positions[i], RandomStream(seed, stream_id("kick", i))));
  }
  const Refinement refinement = refine(trainer, std::move(candidates), {.epochs = method.epochs}, progress);
  HybridFit fit = assemble(problem, refinement);
  fit.swarm = swarm.history;
  fit.evaluations = swarm.evaluations;
  return fit;
}

}  // namespace proofmass
