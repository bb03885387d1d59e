// SPDX-License-Identifier: Apache-2.0
// The part of orthogonal distance regression that works on rows; see orthogonal_distance.hpp.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/linear/triangular_accumulator.hpp"
#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/regression/orthogonal_distance.hpp"
#include "proofmass/numeric/regression/surface.hpp"

namespace proofmass {

// A current point and a trial point. A point consists of the parameters and the input offsets of every row;
// linearisation eliminates the offsets in closed form. Keeps references.
class OffsetElimination {
 public:
  // The linearised problem with the offsets eliminated.
  struct Linearised {
    Eigen::MatrixXd triangle;  // R of the weighted parameter derivatives
    Eigen::VectorXd rotated;   // Qᵀ of the weighted residuals
    double output_size = 0.0;  // length of the weighted outputs, the reference for rounding errors
  };

  struct Trial {
    double sum_of_squares = 0.0;
    double offset_step = 0.0;  // sum of squares of the offsets' changes over their standard deviations
  };

  OffsetElimination(const Surface& surface, const SurfaceObservations& observed,
                    std::span<const double> start);

  // Linearises at the current point, with offsets damped by mu.
  [[nodiscard]] Linearised linearise(double mu) const;
  // Sets the trial point: the parameters after the step, and the best offsets for them.
  [[nodiscard]] Trial attempt(const Eigen::VectorXd& step, double mu);
  // The trial point becomes the current one.
  void accept();

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] const std::vector<double>& parameters() const { return parameters_; }
  [[nodiscard]] const Matrix& offsets() const { return offsets_; }

 private:
  struct Range {
    std::size_t first, count;
  };
  // For each row of a block: v = sigma_y² + sum of slope² sigma_x² / (1 + mu), and the residual for the
  // parameters, e = y - f + slope . d / (1 + mu).
  struct Eliminated {
    std::vector<double> v, e;
  };

  template <typename Body>
  void for_blocks(std::size_t chunk, Body body) const;
  [[nodiscard]] double input_variance(std::size_t input, std::size_t row) const;
  void evaluate(const std::vector<double>& parameters, const Matrix& offsets, Range range,
                SurfaceBlock& block) const;
  void eliminate(Range range, double mu, const Matrix& offsets, const SurfaceBlock& block,
                 Eliminated& rows) const;
  void add_rows(std::size_t chunk, double mu, TriangularAccumulator& triangle, double& output_size) const;
  [[nodiscard]] Trial attempt_rows(std::size_t chunk, const Eigen::VectorXd& step, double mu);
  // The best offsets for the part of e that the parameters' step leaves.
  void move_offsets(Range range, double mu, const SurfaceBlock& block, const Eliminated& rows, Trial& trial);

  // The contribution of each row of the block to the sum of squares, at the trial point.
  [[nodiscard]] std::vector<double> costs(Range range, const SurfaceBlock& block) const;
  // Moves the trial offsets closer to the best ones for the trial parameters. Each row moves separately and
  // never to a worse value. Returns the rows' sum of squares. Without this step, where the output is much
  // more certain than the inputs, the path to the solution is a narrow curved valley that joint steps follow
  // slowly.
  [[nodiscard]] double settle_offsets(Range range, SurfaceBlock& block, Eliminated& rows);

  const Surface& surface_;
  const SurfaceObservations& observed_;
  std::size_t rows_, chunks_;
  std::vector<double> parameters_, trial_parameters_;
  Matrix offsets_, trial_offsets_;
};

}  // namespace proofmass
