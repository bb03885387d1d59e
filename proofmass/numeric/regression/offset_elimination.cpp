// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/regression/offset_elimination_internal.hpp"

namespace proofmass {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Rows per task. The number is fixed, so that sums do not depend on the number of threads.
constexpr std::size_t kChunkRows = 16 * SurfaceBlock::kRows;
// Every row's offsets take this many steps to their best place.
constexpr int kSettlingRounds = 2;
// A row that is still this far from it, in standard deviations squared, goes on until it is as near as the
// second figure: there the surface bends so much within the input's uncertainty that steps of the
// linearisation overshoot or creep.
constexpr double kUnsettled = 1e-12;
constexpr double kSettled = 1e-22;
constexpr int kMostSettlingRounds = 50;
// What a step gains below this fraction of the row's sum of squares, rounding hides.
constexpr double kBelowRounding = 1e-12;
// Where a search for a row's best offsets starts along each input, in standard deviations.
constexpr std::array kOffsetStarts{0.0, -1.5, 1.5, -3.0, 3.0};
constexpr double kLeastCurvature = 0.1;  // over that of the linearisation: steps at most ten times as long

}  // namespace

// Where the rows of a block stand on the way to their best offsets.
struct OffsetElimination::Settling {
  Settling(std::size_t rows, std::size_t inputs)
      : before(SurfaceBlock::kRows, inputs),
        step(SurfaceBlock::kRows, inputs),
        slope(rows),
        curvature(rows, 1.0),
        hard(rows, 0),
        moves(rows, 0) {}

  // Marks the rows that have further to go; false when none has.
  bool choose_rows(int round) {
    bool any = false;
    for (std::size_t r = 0; r < moves.size(); ++r) {
      if (round == kSettlingRounds && -slope[r] > kUnsettled) hard[r] = 1;
      moves[r] = round < kSettlingRounds || (hard[r] != 0 && -slope[r] > kSettled) ? 1 : 0;
      any = any || moves[r] != 0;
    }
    return any;
  }

  Matrix before, step;            // offsets, and the linearisation's step from them
  std::vector<double> slope;      // half the derivative of the row's sum of squares along the step
  std::vector<double> curvature;  // along the step, over that of the linearisation
  std::vector<double> cost;
  std::vector<char> hard, moves;
};

OffsetElimination::OffsetElimination(const Surface& surface, const SurfaceObservations& observed,
                                     std::span<const double> start)
    : surface_(surface),
      observed_(observed),
      rows_(observed.output.size()),
      chunks_((rows_ + kChunkRows - 1) / kChunkRows),
      parameters_(start.begin(), start.end()),
      trial_parameters_(parameters_),
      offsets_(rows_, surface.inputs()),
      trial_offsets_(rows_, surface.inputs()),
      bends_(rows_, 0) {}

void OffsetElimination::Sums::add(const Sums& other) {
  output_squares += other.output_squares;
  output_shares += other.output_shares;
  weights += other.weights;
  values += other.values;
  value_squares += other.value_squares;
}

OffsetElimination::Linearised OffsetElimination::linearise(double mu) const {
  const std::size_t n = parameters_.size();
  std::vector<TriangularAccumulator> parts(chunks_, TriangularAccumulator(n + 1));
  std::vector<Sums> sums(chunks_);
  parallel_for(chunks_, [&](std::size_t chunk) { add_rows(chunk, mu, parts[chunk], sums[chunk]); });
  for (std::size_t chunk = 1; chunk < chunks_; ++chunk) {
    parts[0].add(parts[chunk].r(), n + 1);
    sums[0].add(sums[chunk]);
  }
  const auto count = static_cast<Index>(n);
  const Eigen::Map<const MatrixXd> r(parts[0].r().data(), count + 1, count + 1);
  return {.triangle = r.topLeftCorner(count, count),
          .rotated = r.col(count).head(count),
          .output_size = std::sqrt(sums[0].output_squares),
          .output_share = sums[0].output_shares / static_cast<double>(rows_),
          .variation = std::sqrt(
              std::max(0.0, sums[0].value_squares - sums[0].values * sums[0].values / sums[0].weights))};
}

OffsetElimination::Trial OffsetElimination::attempt(const VectorXd& step, double mu) {
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    trial_parameters_[j] = parameters_[j] + step(static_cast<Index>(j));
  }
  std::vector<Trial> parts(chunks_);
  parallel_for(chunks_, [&](std::size_t chunk) { parts[chunk] = attempt_rows(chunk, step, mu); });
  Trial total;
  for (const Trial& part : parts) {
    total.sum_of_squares += part.sum_of_squares;
    total.offset_step += part.offset_step;
  }
  return total;
}

bool OffsetElimination::bends() const {
  return std::any_of(bends_.begin(), bends_.end(), [](char bends) { return bends != 0; });
}

void OffsetElimination::accept() {
  std::swap(parameters_, trial_parameters_);
  std::swap(offsets_, trial_offsets_);
}

template <typename Body>
void OffsetElimination::for_blocks(std::size_t chunk, Body body) const {
  const std::size_t end = std::min(rows_, (chunk + 1) * kChunkRows);
  for (std::size_t first = chunk * kChunkRows; first < end; first += SurfaceBlock::kRows) {
    body(Range{first, std::min(SurfaceBlock::kRows, end - first)});
  }
}

double OffsetElimination::input_variance(std::size_t input, std::size_t row) const {
  const auto& sigma = observed_.input_sigma[input];
  return sigma.empty() ? 0.0 : sigma[row] * sigma[row];
}

void OffsetElimination::evaluate(const std::vector<double>& parameters, const Matrix& offsets, Range range,
                                 SurfaceBlock& block) const {
  for (std::size_t k = 0; k < surface_.inputs(); ++k) {
    for (std::size_t r = 0; r < range.count; ++r) {
      block.x(r, k) = observed_.inputs[k][range.first + r] + offsets(range.first + r, k);
    }
  }
  surface_.evaluate(parameters, range.count, block);
}

void OffsetElimination::eliminate(Range range, double mu, const Matrix& offsets, const SurfaceBlock& block,
                                  Eliminated& rows) const {
  for (std::size_t r = 0; r < range.count; ++r) {
    const double sigma = observed_.output_sigma[range.first + r];
    rows.v[r] = sigma * sigma;
    rows.e[r] = observed_.output[range.first + r] - block.value[r];
  }
  for (std::size_t k = 0; k < surface_.inputs(); ++k) {
    if (observed_.input_sigma[k].empty()) continue;
    for (std::size_t r = 0; r < range.count; ++r) {
      const double slope = block.by_input(r, k);
      rows.v[r] += slope * slope * input_variance(k, range.first + r) / (1.0 + mu);
      rows.e[r] += slope * offsets(range.first + r, k) / (1.0 + mu);
    }
  }
}

void OffsetElimination::add_rows(std::size_t chunk, double mu, TriangularAccumulator& triangle,
                                 Sums& sums) const {
  const std::size_t n = parameters_.size();
  SurfaceBlock block(surface_.inputs(), n);
  Eliminated rows{.v = std::vector<double>(SurfaceBlock::kRows),
                  .e = std::vector<double>(SurfaceBlock::kRows)};
  Matrix weighted(SurfaceBlock::kRows, n + 1);
  for_blocks(chunk, [&](Range range) {
    evaluate(parameters_, offsets_, range, block);
    eliminate(range, mu, offsets_, block, rows);
    for (std::size_t r = 0; r < range.count; ++r) {
      const double y = observed_.output[range.first + r];
      const double sigma = observed_.output_sigma[range.first + r];
      sums.add({.output_squares = y * y / rows.v[r],
                .output_shares = sigma * sigma / rows.v[r],
                .weights = 1.0 / rows.v[r],
                .values = block.value[r] / rows.v[r],
                .value_squares = block.value[r] * block.value[r] / rows.v[r]});
      rows.v[r] = 1.0 / std::sqrt(rows.v[r]);
      weighted(r, n) = rows.e[r] * rows.v[r];
    }
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t r = 0; r < range.count; ++r) weighted(r, j) = block.by_parameter(r, j) * rows.v[r];
    }
    triangle.add(weighted, range.count);
  });
}

OffsetElimination::Trial OffsetElimination::attempt_rows(std::size_t chunk, const VectorXd& step, double mu) {
  SurfaceBlock block(surface_.inputs(), parameters_.size());
  Eliminated rows{.v = std::vector<double>(SurfaceBlock::kRows),
                  .e = std::vector<double>(SurfaceBlock::kRows)};
  Trial trial;
  for_blocks(chunk, [&](Range range) {
    evaluate(parameters_, offsets_, range, block);
    eliminate(range, mu, offsets_, block, rows);
    for (std::size_t j = 0; j < parameters_.size(); ++j) {
      const double change = step(static_cast<Index>(j));
      for (std::size_t r = 0; r < range.count; ++r) rows.e[r] -= block.by_parameter(r, j) * change;
    }
    move_offsets(range, mu, block, rows, trial);
    const std::vector<double> cost = settle_offsets(range, block, rows);
    trial.sum_of_squares += std::accumulate(cost.begin(), cost.end(), 0.0);
  });
  return trial;
}

void OffsetElimination::move_offsets(Range range, double mu, const SurfaceBlock& block,
                                     const Eliminated& rows, Trial& trial) {
  for (std::size_t k = 0; k < surface_.inputs(); ++k) {
    if (observed_.input_sigma[k].empty()) continue;
    for (std::size_t r = 0; r < range.count; ++r) {
      const std::size_t row = range.first + r;
      const double variance = input_variance(k, row);
      if (variance == 0.0) continue;
      const double old = offsets_(row, k);
      const double now = (mu * old + block.by_input(r, k) * variance * rows.e[r] / rows.v[r]) / (1.0 + mu);
      trial_offsets_(row, k) = now;
      trial.offset_step += (now - old) * (now - old) / variance;
    }
  }
}

std::vector<double> OffsetElimination::costs(Range range, const SurfaceBlock& block) const {
  std::vector<double> result(range.count);
  for (std::size_t r = 0; r < range.count; ++r) {
    const std::size_t row = range.first + r;
    const double residual = (observed_.output[row] - block.value[r]) / observed_.output_sigma[row];
    result[r] = residual * residual;
  }
  for (std::size_t k = 0; k < surface_.inputs(); ++k) {
    if (observed_.input_sigma[k].empty()) continue;
    for (std::size_t r = 0; r < range.count; ++r) {
      const double variance = input_variance(k, range.first + r);
      const double offset = trial_offsets_(range.first + r, k);
      if (variance > 0.0) result[r] += offset * offset / variance;
    }
  }
  return result;
}

void OffsetElimination::propose_offsets(Range range, const SurfaceBlock& block, const Eliminated& rows,
                                        Settling& state) const {
  for (std::size_t k = 0; k < surface_.inputs(); ++k) {
    for (std::size_t r = 0; r < range.count; ++r) {
      const double offset = trial_offsets_(range.first + r, k);
      state.before(r, k) = offset;
      state.step(r, k) =
          block.by_input(r, k) * input_variance(k, range.first + r) * rows.e[r] / rows.v[r] - offset;
    }
  }
  state.slope = slopes(range, block, state.step);
}

std::vector<double> OffsetElimination::slopes(Range range, const SurfaceBlock& block,
                                              const Matrix& step) const {
  std::vector<double> result(range.count);
  for (std::size_t k = 0; k < surface_.inputs(); ++k) {
    if (observed_.input_sigma[k].empty()) continue;
    for (std::size_t r = 0; r < range.count; ++r) {
      const std::size_t row = range.first + r;
      const double variance = input_variance(k, row);
      if (variance == 0.0) continue;
      const double sigma = observed_.output_sigma[row];
      const double residual = (observed_.output[row] - block.value[r]) / sigma;
      result[r] += step(r, k) * (trial_offsets_(row, k) / variance - block.by_input(r, k) * residual / sigma);
    }
  }
  return result;
}

void OffsetElimination::judge_offsets(Range range, const SurfaceBlock& block, Settling& state) {
  const std::vector<double> now = costs(range, block);
  const std::vector<double> slope = slopes(range, block, state.step);
  for (std::size_t r = 0; r < range.count; ++r) {
    if (!state.moves[r]) continue;
    const bool rounded = -state.slope[r] <= kBelowRounding * state.cost[r];
    const bool better = now[r] < state.cost[r] || (rounded && std::abs(slope[r]) < std::abs(state.slope[r]));
    if (better) {
      state.cost[r] = now[r];
    } else {
      for (std::size_t k = 0; k < surface_.inputs(); ++k) {
        trial_offsets_(range.first + r, k) = state.before(r, k);
      }
    }
    // The secant: slope over the step's length, in units of the curvature that linearisation gives.
    const double secant = state.curvature[r] * (1.0 - slope[r] / state.slope[r]);
    const double least = better ? kLeastCurvature : 2.0 * state.curvature[r];
    state.curvature[r] = std::clamp(secant, least, std::max(least, 10.0 * state.curvature[r]));
  }
}

std::vector<double> OffsetElimination::settle_offsets(Range range, SurfaceBlock& block, Eliminated& rows) {
  evaluate(trial_parameters_, trial_offsets_, range, block);
  Settling state(range.count, surface_.inputs());
  state.cost = costs(range, block);
  for (int round = 0; round < kMostSettlingRounds; ++round) {
    eliminate(range, 0.0, trial_offsets_, block, rows);
    propose_offsets(range, block, rows, state);
    if (!state.choose_rows(round)) break;
    for (std::size_t k = 0; k < surface_.inputs(); ++k) {
      for (std::size_t r = 0; r < range.count; ++r) {
        if (state.moves[r]) trial_offsets_(range.first + r, k) += state.step(r, k) / state.curvature[r];
      }
    }
    evaluate(trial_parameters_, trial_offsets_, range, block);
    judge_offsets(range, block, state);
  }
  for (std::size_t r = 0; r < range.count; ++r) {
    if (state.hard[r] != 0) bends_[range.first + r] = 1;
  }
  return state.cost;
}

double OffsetElimination::search_offsets() {
  trial_parameters_ = parameters_;
  trial_offsets_ = offsets_;
  std::vector<double> sums(chunks_, 0.0);
  parallel_for(chunks_, [&](std::size_t chunk) {
    SurfaceBlock block(surface_.inputs(), parameters_.size());
    Eliminated rows{.v = std::vector<double>(SurfaceBlock::kRows),
                    .e = std::vector<double>(SurfaceBlock::kRows)};
    for_blocks(chunk, [&](Range range) { sums[chunk] += search_block(range, block, rows); });
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double OffsetElimination::search_block(Range range, SurfaceBlock& block, Eliminated& rows) {
  evaluate(trial_parameters_, trial_offsets_, range, block);
  std::vector<double> least = costs(range, block);
  Matrix best(range.count, surface_.inputs());
  const auto keep = [&](std::size_t r) {
    for (std::size_t k = 0; k < surface_.inputs(); ++k) best(r, k) = trial_offsets_(range.first + r, k);
  };
  for (std::size_t r = 0; r < range.count; ++r) keep(r);
  for (std::size_t input = 0; input < surface_.inputs(); ++input) {
    for (const double sigmas : kOffsetStarts) {
      for (std::size_t r = 0; r < range.count; ++r) {
        const std::size_t row = range.first + r;
        if (bends_[row] == 0) continue;
        for (std::size_t k = 0; k < surface_.inputs(); ++k) trial_offsets_(row, k) = 0.0;
        trial_offsets_(row, input) = sigmas * std::sqrt(input_variance(input, row));
      }
      const std::vector<double> now = settle_offsets(range, block, rows);
      for (std::size_t r = 0; r < range.count; ++r) {
        if (bends_[range.first + r] == 0 || !(now[r] < least[r])) continue;
        least[r] = now[r];
        keep(r);
      }
    }
  }
  for (std::size_t r = 0; r < range.count; ++r) {
    for (std::size_t k = 0; k < surface_.inputs(); ++k) trial_offsets_(range.first + r, k) = best(r, k);
  }
  return std::accumulate(least.begin(), least.end(), 0.0);
}

}  // namespace proofmass
