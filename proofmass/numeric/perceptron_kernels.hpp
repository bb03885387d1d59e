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

// Hidden activations, zero in the padding: the first `hidden` columns of phi.
void hidden_activations(const PerceptronShape& shape, std::span<const double> hidden_weights,
                        const Samples& samples, ColumnBlock& phi);

// What a network and its samples come to, summed over the samples. phi: the columns that the output is linear
// in (hidden activations, ones, fixed columns); q = phi * transform; P = D - q * projection, D the
// derivatives of the output by the hidden weights; e = target - output.
struct PerceptronProducts {
  // Room for the sums of a network with so many fixed columns.
  PerceptronProducts(const PerceptronShape& shape, std::size_t fixed)
      : pp(shape.hidden_weights(), shape.hidden_weights()),
        pq(shape.hidden_weights(), shape.output_weights() + fixed),
        pe(shape.hidden_weights()),
        qq(shape.output_weights() + fixed, shape.output_weights() + fixed),
        qe(shape.output_weights() + fixed) {}

  Matrix pp;               // PᵀP
  Matrix pq;               // Pᵀq
  std::vector<double> pe;  // Pᵀe
  Matrix qq;               // qᵀq
  std::vector<double> qe;  // qᵀe
  double ee = 0.0;         // eᵀe
};

// One pass over the samples. `weights`: those of the shape, then one for each fixed column. `fixed`: further
// columns of padded_rows() values, zero in the padding; may have none. `transform`: upper triangular, as many
// columns as phi. `projection`: columns of q by hidden weights; where it is empty pp, pq and pe are left
// alone.
void perceptron_products(const PerceptronShape& shape, std::span<const double> weights,
                         const Samples& samples, const ColumnBlock& fixed, const Matrix& transform,
                         const Matrix& projection, PerceptronProducts& products);

// dq = Dᵀq, hidden weights by columns of q.
void perceptron_cross_products(const PerceptronShape& shape, std::span<const double> weights,
                               const Samples& samples, const ColumnBlock& fixed, const Matrix& transform,
                               Matrix& dq);

// With s the second derivative of the output along `direction` (of all weights), less q * removed (which may
// be empty): d_second = Dᵀs, q_second = qᵀs.
void perceptron_curvature(const PerceptronShape& shape, std::span<const double> weights,
                          std::span<const double> direction, const Samples& samples, const ColumnBlock& fixed,
                          const Matrix& transform, std::span<const double> removed,
                          std::span<double> d_second, std::span<double> q_second);

// The hyperbolic tangent of each value, as all kernels here take it.
void tanh_of(std::span<const double> z, std::span<double> result);

// The instruction set in use: "AVX3_ZEN4", "AVX2", …
[[nodiscard]] const char* kernel_target();

}  // namespace proofmass
