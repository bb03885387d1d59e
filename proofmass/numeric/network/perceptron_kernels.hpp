// SPDX-License-Identifier: Apache-2.0
// Batch kernels over samples: all the arithmetic of a perceptron's training, vectorised; the instruction set
// (SSE4, AVX2, AVX-512) is chosen at run time. Each call uses one thread and needs at least one sample.
// Results of different instruction sets differ only by rounding.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/samples.hpp"
#include "proofmass/numeric/simd/block_columns.hpp"

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

// The following functions are for networks without fixed columns.
inline const ColumnBlock kNoColumns;

// The network's output for every sample. `outputs` has samples.rows() values.
void perceptron_outputs(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples,
                        std::span<double> outputs);

// Sum over the samples of (target - output)². Each output is accurate to about 1e-16 times the output
// weights.
[[nodiscard]] double perceptron_sse(const PerceptronShape& shape, std::span<const double> weights,
                                    const Samples& samples);

// Columns that passes over a network's samples keep for later passes, when there are few enough samples.
struct PerceptronColumns {
  PerceptronColumns(const PerceptronShape& shape, const Samples& samples)
      : hidden(2 * shape.hidden + 1, samples.padded_rows()),
        moments(shape.inputs * (shape.inputs + 3) / 2, samples.padded_rows()) {}

  BlockColumns hidden;         // activations, errors, slopes
  BlockColumns moments;        // products of inputs, the same for all networks
  bool moments_known = false;  // the moments have been filled
};

// The same sum; keeps activations and errors.
[[nodiscard]] double perceptron_sse(const PerceptronShape& shape, std::span<const double> weights,
                                    const Samples& samples, PerceptronColumns& columns);

// In one pass, with J the Jacobian of the outputs by all weights and e = target - output, fills the lower
// triangle of JᵀJ (parameters() square) and Jᵀe, and returns eᵀe. `kept`: the last pass that kept activations
// and errors had the same weights.
double perceptron_normal_equations(const PerceptronShape& shape, std::span<const double> weights,
                                   const Samples& samples, bool kept, PerceptronColumns& columns, Matrix& jtj,
                                   std::span<double> jte);

// Hidden activations, zero in the padding: fills the first `hidden` columns of phi.
void hidden_activations(const PerceptronShape& shape, std::span<const double> hidden_weights,
                        const Samples& samples, ColumnBlock& phi);

// The hyperbolic tangent of each value, as all kernels here compute it.
void tanh_of(std::span<const double> z, std::span<double> result);

// The instruction set in use: "AVX3_ZEN4", "AVX2", …
[[nodiscard]] const char* kernel_target();

}  // namespace proofmass
