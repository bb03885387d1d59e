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
#include "proofmass/identify/network/starts.hpp"
#include "proofmass/numeric/network/variable_projection.hpp"
#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"
#include "proofmass/numeric/optimise/particle_swarm.hpp"
#include "proofmass/numeric/parallel.hpp"
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

SwarmResult seek(const HybridProblem& problem, const IdentifyOptions& options, const Progress& progress) {
  std::vector<std::vector<double>> initial;
  for (std::size_t i = 0; i < options.hybrid.particles; ++i) {
    initial.push_back(random_start(problem.shape, Trainer::varpro, options.seed, i));
  }
  SwarmSettings settings;
  settings.iterations = options.hybrid.iterations;
  const SeparablePool pool(problem.shape, problem.samples, problem.fixed);
  const auto objective = [&pool, &progress](std::span<const double> x) {
    return progress.cancelled() ? std::numeric_limits<double>::infinity() : pool.rmse(x);
  };
  return minimise_by_swarm(objective, std::move(initial), settings, options.seed,
                           [&progress](std::size_t, double) { return !progress.cancelled(); });
}

// The training of one particle's best position.
struct Candidate {
  LevenbergMarquardtResult result;
  std::vector<double> output_weights;
};

Candidate train(const HybridProblem& problem, const std::vector<double>& start,
                const IdentifyOptions& options, const Progress& progress) {
  SeparablePerceptron separable(problem.shape, problem.samples, problem.fixed);
  const LevenbergMarquardtOptions settings{.iterations = options.hybrid.epochs,
                                           .geodesic_acceleration = true,
                                           .mu = 0.1,
                                           .mu_max = 1e16,
                                           .stall_window = 30,
                                           .stall_reduction = 1e-5};
  Candidate candidate;
  candidate.result =
      minimise(separable, start, settings,
               [&progress](std::size_t, std::span<const double>, double) { return !progress.cancelled(); });
  candidate.result.sum_of_squares = separable.evaluate(candidate.result.point);
  candidate.output_weights = separable.output_weights();
  return candidate;
}

HybridFit assemble(const HybridProblem& problem, const Candidate& best) {
  HybridFit fit;
  fit.network = problem.scaling;
  fit.network.hidden = problem.shape.hidden;
  const double half = output_half_range(problem.scaling);
  const auto network_end =
      best.output_weights.begin() + static_cast<std::ptrdiff_t>(problem.shape.output_weights());
  std::vector<double> weights = best.result.point;
  weights.insert(weights.end(), best.output_weights.begin(), network_end);
  fit.network.weights = canonical_weights(problem.shape, weights);
  fit.network.skip.terms = problem.terms;
  for (std::size_t c = 0; c < problem.terms.size(); ++c) {
    fit.network.skip.coefficients.push_back(half * network_end[static_cast<std::ptrdiff_t>(c)] /
                                            problem.scales[c]);
  }
  fit.rss = best.result.sum_of_squares * half * half;
  fit.parameters = problem.shape.parameters() + problem.terms.size();
  for (const double sum : best.result.history) {
    fit.curve.push_back(root_mean(sum, problem.samples));
  }
  return fit;
}

}  // namespace

HybridFit fit_hybrid(const Dataset& training, const TermList& terms, std::size_t hidden,
                     const IdentifyOptions& options, Progress& progress) {
  const HybridProblem problem(training, terms, hidden);
  const SwarmResult swarm = seek(problem, options, progress);
  std::vector<std::size_t> order(swarm.positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&swarm](std::size_t a, std::size_t b) { return swarm.values[a] < swarm.values[b]; });
  order.resize(std::min(order.size(), options.hybrid.refined));

  std::vector<Candidate> candidates(order.size());
  parallel_for(order.size(), [&](std::size_t i) {
    if (!progress.cancelled()) candidates[i] = train(problem, swarm.positions[order[i]], options, progress);
  });
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
  const auto best =
      std::min_element(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.result.sum_of_squares < b.result.sum_of_squares;
      });
  HybridFit fit = assemble(problem, *best);
  fit.swarm = swarm.history;
  fit.evaluations = swarm.evaluations;
  for (const Candidate& candidate : candidates) fit.epochs += candidate.result.iterations;
  return fit;
}

}  // namespace proofmass
