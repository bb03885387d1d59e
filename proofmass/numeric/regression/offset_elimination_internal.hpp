// SPDX-License-Identifier: Apache-2.0
// The rows' part of orthogonal distance regression; see orthogonal_distance.hpp.
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

// A current point and a trial point: parameters, and the inputs' offsets of every row, which linearisation
// eliminates in closed form. Keeps references.
class OffsetElimination {
 public:
  // The problem linearised with the offsets eliminated.
  struct Linearised {
    Eigen::MatrixXd triangle;   // R of the weighted parameter derivatives
    Eigen::VectorXd rotated;    // Qᵀ of the weighted residuals
    double output_size = 0.0;   // length of the weighted outputs: what rounding is relative to
    double output_share = 0.0;  // mean over the rows of sigma_y² / v
    double variation = 0.0;     // of the surface about its weighted mean: length of the weighted differences
  };

  struct Trial {
    double sum_of_squares = 0.0;
    double offset_step = 0.0;  // sum of squares of the offsets' changes over their standard deviations
  };

  OffsetElimination(const Surface& surface, const SurfaceObservations& observed,
                    std::span<const double> start);

  // At the current point, with offsets damped by mu.
  [[nodiscard]] Linearised linearise(double mu) const;
  // Moves the parameters by the step and every offset to its best place for it, on trial.
  [[nodiscard]] Trial attempt(const Eigen::VectorXd& step, double mu);
  // Whether the surface bends within the input's uncertainty in some row, so that its offsets may have
  // several local solutions.
  [[nodiscard]] bool bends() const;
  // A trial point with the current parameters and, in such rows, the best offsets found from several starts;
  // returns its sum of squares.
  [[nodiscard]] double search_offsets();
  // The trial point becomes the current one.
  void accept();

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] const std::vector<double>& parameters() const { return parameters_; }
  [[nodiscard]] const Matrix& offsets() const { return offsets_; }

 private:
  struct Range {
    std::size_t first, count;
  };
  // Of each row of a block: v = sigma_y² + sum of slope² sigma_x² / (1 + mu), and the residual as the
  // parameters see it, e = y - f + slope . d / (1 + mu).
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
  struct Sums {
    double output_squares = 0.0;  // of weighted outputs
    double output_shares = 0.0;   // of sigma_y² / v
    double weights = 0.0;         // of 1 / v
    double values = 0.0;          // of the weighted surface
    double value_squares = 0.0;
    void add(const Sums& other);
  };
  void add_rows(std::size_t chunk, double mu, TriangularAccumulator& triangle, Sums& sums) const;
  [[nodiscard]] Trial attempt_rows(std::size_t chunk, const Eigen::VectorXd& step, double mu);
  // The offsets that are best for what the parameters' step leaves of e.
  void move_offsets(Range range, double mu, const SurfaceBlock& block, const Eliminated& rows, Trial& trial);

  // Of each row of the block, at the trial point: its share of the sum of squares.
  [[nodiscard]] std::vector<double> costs(Range range, const SurfaceBlock& block) const;
  struct Settling;
  // Steps of the linearisation at the trial offsets, and the slopes along them.
  void propose_offsets(Range range, const SurfaceBlock& block, const Eliminated& rows, Settling& state) const;
  // Half the derivatives of the rows' sums of squares along a step, at the trial offsets.
  [[nodiscard]] std::vector<double> slopes(Range range, const SurfaceBlock& block, const Matrix& step) const;
  // Takes back the steps that made a row worse, and learns how long the next ones should be.
  void judge_offsets(Range range, const SurfaceBlock& block, Settling& state);
  // Takes the trial offsets to the best for the trial parameters, each row by itself and never to a worse
  // place, and returns the rows' sums of squares. Without it, where the output is much more certain than the
  // inputs, the way to the solution is a narrow curved valley that joint steps follow slowly; and a row where
  // the surface bends within the input's uncertainty never comes to rest. Such rows take secant steps.
  [[nodiscard]] std::vector<double> settle_offsets(Range range, SurfaceBlock& block, Eliminated& rows);
  [[nodiscard]] double search_block(Range range, SurfaceBlock& block, Eliminated& rows);

  const Surface& surface_;
  const SurfaceObservations& observed_;
  std::size_t rows_, chunks_;
  std::vector<double> parameters_, trial_parameters_;
  Matrix offsets_, trial_offsets_;
  std::vector<char> bends_;  // of each row, whether it was seen to
};

}  // namespace proofmass
