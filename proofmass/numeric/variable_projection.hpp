// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/levenberg_marquardt.hpp"
#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/perceptron.hpp"
#include "proofmass/numeric/perceptron_kernels.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// Training of the hidden weights alone, the output layer solved by least squares inside: r = target projected
// off the hidden activations (Golub & Pereyra 1973), its Jacobian by Kaufman's approximation (1975). x = the
// hidden weights.
class SeparablePerceptron final : public SumOfSquares {
 public:
  // Keeps a reference to the samples. `fixed` are further columns that the output is linear in, of
  // padded_rows() values, zero in the padding; copied.
  SeparablePerceptron(const PerceptronShape& shape, const Samples& samples, const ColumnBlock& fixed = {});

  [[nodiscard]] std::size_t parameters() const override { return shape_.hidden_weights(); }
  double evaluate(std::span<const double> hidden_weights) override;
  void accept() override;
  void linearise(Matrix& normal, std::span<double> gradient) override;
  // By a finite difference of r along the direction.
  bool curvature(std::span<const double> direction, const Matrix& normal, std::span<const double> gradient,
                 std::span<double> result) override;

  // Output weights of the last evaluated point: hidden units, bias, fixed columns.
  [[nodiscard]] const std::vector<double>& output_weights() const noexcept { return trial_.output_weights; }

 private:
  // Everything known of one point.
  struct Solution {
    std::vector<double> hidden_weights;
    std::vector<double> output_weights;
    ColumnBlock phi;       // activations and ones
    ColumnBlock q;         // phi * transform: the same space, well conditioned
    Matrix transform;      // upper triangular
    Matrix gram_inverse;   // (qᵀq)⁻¹
    ColumnBlock residual;  // target - phi * output_weights
  };

  // Hidden units, bias and fixed columns.
  [[nodiscard]] std::size_t columns() const noexcept { return current_.output_weights.size(); }
  double solve(std::span<const double> hidden_weights, Solution& solution) const;

  PerceptronShape shape_;
  const Samples& samples_;
  Solution current_, trial_, probe_;
  Matrix cross_;
};

}  // namespace proofmass
