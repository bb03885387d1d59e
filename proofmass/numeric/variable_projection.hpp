// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/levenberg_marquardt.hpp"
#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/perceptron.hpp"
#include "proofmass/numeric/samples.hpp"
#include "proofmass/numeric/separable_kernels.hpp"

namespace proofmass {

// Training of the hidden weights alone, the output layer solved by least squares inside: r = target projected
// off the hidden activations (Golub & Pereyra 1973), its Jacobian by Kaufman's approximation (1975). x = the
// hidden weights. evaluate passes once over the samples where it has a good guess of the output layer, else
// twice or more, linearise and curvature twice; of up to some thousand samples passes find what those before
// have computed, in at most 3 MiB for each of the two points known.
class SeparablePerceptron final : public SumOfSquares {
 public:
  // Keeps references. `fixed` are further columns that the output is linear in, of padded_rows() values, zero
  // in the padding.
  SeparablePerceptron(const PerceptronShape& shape, const Samples& samples);
  SeparablePerceptron(const PerceptronShape& shape, const Samples& samples, const ColumnBlock& fixed);
  SeparablePerceptron(const PerceptronShape& shape, Samples&& samples) = delete;
  SeparablePerceptron(const PerceptronShape& shape, const Samples& samples, ColumnBlock&& fixed) = delete;

  [[nodiscard]] std::size_t parameters() const override { return shape_.hidden_weights(); }
  double evaluate(std::span<const double> hidden_weights) override;
  // The same sum of squares to about four digits, for searches: in one pass where evaluate takes two. Leaves
  // no trial point.
  double estimate(std::span<const double> hidden_weights);
  void accept() override;
  void linearise(Matrix& normal, std::span<double> gradient) override;
  bool curvature(std::span<const double> direction, std::span<double> result) override;

  // Output weights of the last evaluated point: hidden units, bias, fixed columns.
  [[nodiscard]] const std::vector<double>& output_weights() const noexcept { return trial_.output_weights; }

 private:
  // Everything known of one point.
  struct Solution {
    std::vector<double> hidden_weights;
    std::vector<double> output_weights;
    Matrix transform;     // upper triangular: phi * transform = q spans what phi does, well conditioned
    Matrix gram_inverse;  // (qᵀq)⁻¹
    SeparableState state;
  };

  // Hidden units, bias and fixed columns.
  [[nodiscard]] std::size_t columns() const noexcept { return current_.output_weights.size(); }
  // Solves for the output layer from the guess that the solution holds, until the relative error of the sum
  // of squares is below the tolerance.
  double solve(std::span<const double> hidden_weights, double tolerance, Solution& solution);
  [[nodiscard]] static std::vector<double> all_weights(const Solution& solution);
  [[nodiscard]] SeparableNetwork network(std::span<const double> weights, const Matrix& transform) const;
  void sum_products(Solution& solution);
  // Makes q orthonormal to rounding, by the products of the last pass.
  void orthonormalise(Solution& solution);
  // Output weights that the linearisation at the current point expects elsewhere.
  void predict(std::span<const double> hidden_weights, std::vector<double>& output_weights) const;

  PerceptronShape shape_;
  const Samples& samples_;
  const ColumnBlock& fixed_;
  Solution current_, trial_;
  BasisProducts products_;
  bool linearised_ = false;  // at the current point
  Matrix cross_;             // Dᵀq there; hidden weights by columns of q
  Matrix projection_;        // (qᵀq)⁻¹ qᵀD there; columns of q by hidden weights
  std::vector<double> pe_;   // Pᵀe there, which is Dᵀe as e is orthogonal to q
};

}  // namespace proofmass
