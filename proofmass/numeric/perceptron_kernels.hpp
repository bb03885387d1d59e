// SPDX-License-Identifier: Apache-2.0
// Batch kernels over samples: the whole arithmetic of a perceptron's training, vectorised, chosen at run time
// for the processor (SSE4, AVX2, AVX-512). One thread each; results depend on the target chosen only by
// rounding.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/perceptron.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// Columns of padded_rows() values each, one after the other.
class ColumnBlock {
 public:
  ColumnBlock() = default;
  ColumnBlock(std::size_t columns, std::size_t padded_rows)
      : columns_(columns), stride_(padded_rows), data_(columns * padded_rows, 0.0) {}
  [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
  [[nodiscard]] std::size_t stride() const noexcept { return stride_; }
  [[nodiscard]] double* column(std::size_t c) noexcept { return data_.data() + c * stride_; }
  [[nodiscard]] const double* column(std::size_t c) const noexcept { return data_.data() + c * stride_; }

 private:
  std::size_t columns_ = 0;
  std::size_t stride_ = 0;
  AlignedColumn data_;
};

// The network's output for every sample. `outputs` has samples.rows() values.
void perceptron_outputs(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples,
                        std::span<double> outputs);

// Sum over the samples of (target - output)².
[[nodiscard]] double perceptron_sse(const PerceptronShape& shape, std::span<const double> weights,
                                    const Samples& samples);

// One pass: with J the Jacobian of the outputs by all weights and e = target - output, fills the upper
// triangle and mirror of JᵀJ (parameters() square) and Jᵀe, and returns eᵀe.
double perceptron_normal_equations(const PerceptronShape& shape, std::span<const double> weights,
                                   const Samples& samples, Matrix& jtj, std::span<double> jte);

// Hidden activations, zero in the padding: the first `hidden` columns of phi; the last, of ones, is the
// output bias's.
void hidden_activations(const PerceptronShape& shape, std::span<const double> hidden_weights,
                        const Samples& samples, ColumnBlock& phi);

// q = phi * transform (upper triangular), gram = qᵀq, qty = qᵀ target.
void transform_columns(const ColumnBlock& phi, const Matrix& transform, const Samples& samples,
                       ColumnBlock& q, Matrix& gram, std::span<double> qty);

// residual = target - phi * coefficients, with qt_residual = qᵀ residual; returns its sum of squares.
// `residual` has one column.
double column_residual(const ColumnBlock& phi, std::span<const double> coefficients, const Samples& samples,
                       const ColumnBlock& q, ColumnBlock& residual, std::span<double> qt_residual);

// With D the derivative of phi * v by the hidden weights (v held): cross = qᵀD.
void hidden_jacobian_cross(const PerceptronShape& shape, std::span<const double> v, const ColumnBlock& phi,
                           const ColumnBlock& q, const Samples& samples, Matrix& cross);

// normal = PᵀP and gradient = Pᵀe for P = D - q * cross.
void projected_normal_equations(const PerceptronShape& shape, std::span<const double> v,
                                const ColumnBlock& phi, const ColumnBlock& q, const Matrix& cross,
                                const ColumnBlock& residual, const Samples& samples, Matrix& normal,
                                std::span<double> gradient);

// Dᵀ residual and qᵀ residual.
void hidden_jacobian_transposed(const PerceptronShape& shape, std::span<const double> v,
                                const ColumnBlock& phi, const ColumnBlock& q, const ColumnBlock& residual,
                                const Samples& samples, std::span<double> dt_residual,
                                std::span<double> qt_residual);

// The instruction set in use: "AVX3_ZEN4", "AVX2", …
[[nodiscard]] const char* kernel_target();

}  // namespace proofmass
