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

// Training of the hidden weights alone, the output layer solved by least squares inside: r = target projected
// off the hidden activations (Golub & Pereyra 1973), its Jacobian by Kaufman's approximation (1975). x = the
// hidden weights. evaluate passes once over the samples where it has a good guess of the output layer, else
// twice or more, linearise and curvature twice; passes find what those before have computed, in at most 3 MiB
// for each of the two points known. Of samples too many for that, some thousand, evenly spaced, tell
// beforehand nearly what the first of two passes would find, so that each of the three passes once.
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
  // Output weights and transform for the trial point to begin with.
  void guess(std::span<const double> hidden_weights, double tolerance);
  // Output weights that the linearisation at the current point expects elsewhere.
  void predict(std::span<const double> hidden_weights, std::vector<double>& output_weights) const;
  // Solves for the output layer at the trial point until the relative error of the sum of squares is below
  // the tolerance.
  double solve(std::span<const double> hidden_weights, double tolerance);
  [[nodiscard]] static std::vector<double> all_weights(const Solution& solution);
  [[nodiscard]] SeparableNetwork network(std::span<const double> weights, const Matrix& transform) const;
  void sum_products(Solution& solution);
  // Finds C at the current point.
  void project();
  // The current point becomes another problem's, whose C is nearly the one that is found.
  void follow(const Solution& point);
  // C, PᵀP and Pᵀe from those of a C that was off, as Pᵀq shows. False where so much cancels that the pass
  // over the samples is to be repeated with the C found.
  bool correct(Matrix& normal);
  // Coefficients of q in the second derivative of the output along a direction of all weights.
  [[nodiscard]] std::vector<double> second_in_basis(std::span<const double> along);

  PerceptronShape shape_;
  const Samples& samples_;
  const ColumnBlock& fixed_;
  Solution current_, trial_;
  BasisProducts products_;
  bool linearised_ = false;  // at the current point
  Matrix cross_;             // Dᵀq there; hidden weights by columns of q
  Matrix projection_;        // (qᵀq)⁻¹ qᵀD there; columns of q by hidden weights
  std::vector<double> pe_;   // Pᵀe there, which is Dᵀe as e is orthogonal to q
  Matrix pq_;                // Pᵀq of a C that may be off
  std::unique_ptr<const SampleRows> pilot_rows_;
  std::unique_ptr<SeparablePerceptron> pilot_;  // the same problem on some of many samples, otherwise null
};

}  // namespace proofmass
