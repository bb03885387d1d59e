// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
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
constexpr int kSettlingRounds = 2;

}  // namespace

OffsetElimination::OffsetElimination(const Surface& surface, const SurfaceObservations& observed,
                                     std::span<const double> start)
    : surface_(surface),
      observed_(observed),
      rows_(observed.output.size()),
      chunks_((rows_ + kChunkRows - 1) / kChunkRows),
      parameters_(start.begin(), start.end()),
      trial_parameters_(parameters_),
      offsets_(rows_, surface.inputs()),
      trial_offsets_(rows_, surface.inputs()) {}

OffsetElimination::Linearised OffsetElimination::linearise(double mu) const {
  const std::size_t n = parameters_.size();
  std::vector<TriangularAccumulator> parts(chunks_, TriangularAccumulator(n + 1));
  std::vector<double> sizes(chunks_, 0.0);
  parallel_for(chunks_, [&](std::size_t chunk) { add_rows(chunk, mu, parts[chunk], sizes[chunk]); });
  for (std::size_t chunk = 1; chunk < chunks_; ++chunk) {
    parts[0].add(parts[chunk].r(), n + 1);
    sizes[0] += sizes[chunk];
  }
  const auto count = static_cast<Index>(n);
  const Eigen::Map<const MatrixXd> r(parts[0].r().data(), count + 1, count + 1);
  return {.triangle = r.topLeftCorner(count, count),
          .rotated = r.col(count).head(count),
          .output_size = std::sqrt(sizes[0])};
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
                                 double& output_size) const {
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
      output_size += y * y / rows.v[r];
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
    trial.sum_of_squares += settle_offsets(range, block, rows);
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

double OffsetElimination::settle_offsets(Range range, SurfaceBlock& block, Eliminated& rows) {
  evaluate(trial_parameters_, trial_offsets_, range, block);
  std::vector<double> cost = costs(range, block);
  Matrix before(SurfaceBlock::kRows, surface_.inputs());
  for (int round = 0; round < kSettlingRounds; ++round) {
    eliminate(range, 0.0, trial_offsets_, block, rows);
    for (std::size_t k = 0; k < surface_.inputs(); ++k) {
      for (std::size_t r = 0; r < range.count; ++r) {
        double& offset = trial_offsets_(range.first + r, k);
        before(r, k) = std::exchange(
            offset, block.by_input(r, k) * input_variance(k, range.first + r) * rows.e[r] / rows.v[r]);
      }
    }
    evaluate(trial_parameters_, trial_offsets_, range, block);
    const std::vector<double> now = costs(range, block);
    for (std::size_t r = 0; r < range.count; ++r) {
      if (now[r] < cost[r]) {
        cost[r] = now[r];
        continue;
      }
      for (std::size_t k = 0; k < surface_.inputs(); ++k) trial_offsets_(range.first + r, k) = before(r, k);
    }
  }
  return std::accumulate(cost.begin(), cost.end(), 0.0);
}

}  // namespace proofmass
