// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/network/sample_rows.hpp"
#include "proofmass/numeric/network/separable_kernels.hpp"
#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// Training of the hidden weights alone. The output layer is solved by least squares inside: r = target
// projected off the hidden activations (Golub & Pereyra 1973), with Kaufman's approximation of its Jacobian
// (1975). x = the hidden weights. evaluate passes over the samples once when it has a good guess of the
// output layer, otherwise twice or more; linearise and curvature pass twice. Passes reuse columns that
// earlier ones have computed, in at most 3 MiB for each of two points. Above about 15,000 rows this cache
// would not fit. A pilot of 4096 evenly spaced rows then predicts the result of the first pass and the second
// pass corrects it, so each of the three functions passes once.
class SeparablePerceptron final : public SumOfSquares {
 public:
  // Keeps references. `fixed` are further columns that the output is linear in, of padded_rows() values, with
  // zeros in the padding.
  SeparablePerceptron(const PerceptronShape& shape, const Samples& samples);
  SeparablePerceptron(const PerceptronShape& shape, const Samples& samples, const ColumnBlock& fixed);
  SeparablePerceptron(const PerceptronShape& shape, Samples&& samples) = delete;
  SeparablePerceptron(const PerceptronShape& shape, const Samples& samples, ColumnBlock&& fixed) = delete;

  [[nodiscard]] std::size_t parameters() const override { return shape_.hidden_weights(); }
  double evaluate(std::span<const double> hidden_weights) override;
  // The same sum of squares to about four digits, for searches: one pass where evaluate takes two. Sets no
  // trial point.
  double estimate(std::span<const double> hidden_weights);
  void accept() override;
  void linearise(Matrix& normal, std::span<double> gradient) override;
  bool curvature(std::span<const double> direction, std::span<double> result) override;

  // Output weights of the last evaluated point: hidden units, bias, fixed columns.
  [[nodiscard]] const std::vector<double>& output_weights() const noexcept { return trial_.output_weights; }

 private:
  // All values known at one point.
  struct Solution {
    std::vector<double> hidden_weights;
    std::vector<double> output_weights;
    Matrix transform;  // upper triangular: phi * transform = q spans the space of phi and is well conditioned
    Matrix gram_inverse;  // (qᵀq)⁻¹
    SeparableState state;
  };

  // Hidden units, bias and fixed columns.
  [[nodiscard]] std::size_t columns() const noexcept { return current_.output_weights.size(); }
  // Initial output weights and transform for the trial point.
  void guess(std::span<const double> hidden_weights, double tolerance);
  // Output weights at another point, predicted by the linearisation at the current point.
  void predict(std::span<const double> hidden_weights, std::vector<double>& output_weights) const;
  // Solves for the output layer at the trial point until the relative error of the sum of squares is below
  // the tolerance.
  double solve(std::span<const double> hidden_weights, double tolerance);
  [[nodiscard]] static std::vector<double> all_weights(const Solution& solution);
  [[nodiscard]] SeparableNetwork network(std::span<const double> weights, const Matrix& transform) const;
  void sum_products(Solution& solution);
  // Computes C at the current point.
  void project();
  // Takes over the current point of another problem, whose C is close to the one wanted.
  void follow(const Solution& point);
  // Computes C, PᵀP and Pᵀe from those of an inexact C, using Pᵀq. False when so much cancels that the pass
  // over the samples must be repeated with the new C.
  bool correct(Matrix& normal);
  // Coefficients of q in the second derivative of the output along a direction of all weights.
  [[nodiscard]] std::vector<double> second_in_basis(std::span<const double> along);

  PerceptronShape shape_;
  const Samples& samples_;
  const ColumnBlock& fixed_;
  Solution current_, trial_;
  BasisProducts products_;
  bool linearised_ = false;  // at the current point
  Matrix cross_;             // Dᵀq at the current point; hidden weights by columns of q
  Matrix projection_;        // (qᵀq)⁻¹ qᵀD at the current point; columns of q by hidden weights
  std::vector<double> pe_;   // Pᵀe at the current point; equals Dᵀe because e is orthogonal to q
  Matrix pq_;                // Pᵀq of an inexact C
  std::unique_ptr<const SampleRows> pilot_rows_;
  std::unique_ptr<SeparablePerceptron> pilot_;  // the same problem on the pilot; null for few samples
};

}  // namespace proofmass
