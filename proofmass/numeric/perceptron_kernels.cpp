// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/perceptron_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "proofmass/numeric/perceptron_kernels.cpp"
#include <hwy/foreach_target.h>
// foreach_target includes this file once for every instruction set; the next header must come after it.
#include "proofmass/numeric/perceptron_kernels-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

double Forward(const PerceptronShape& shape, const double* weights, const Samples& samples, double* outputs) {
  const double* v = weights + shape.hidden_weights();
  V sums = hn::Zero(kD);
  for (std::size_t row = 0; row < samples.padded_rows(); row += hn::Lanes(kD)) {
    V output = hn::Set(kD, v[shape.hidden]);
    for (std::size_t j = 0; j < shape.hidden; ++j) {
      output = hn::MulAdd(hn::Set(kD, v[j]), Tanh(HiddenArgument(shape, weights, j, samples, row)), output);
    }
    if (outputs != nullptr) hn::StoreU(output, kD, outputs + row);
    const V mask = hn::LoadU(kD, samples.mask_data() + row);
    const V e = hn::Mul(mask, hn::Sub(hn::LoadU(kD, samples.target_data() + row), output));
    sums = hn::MulAdd(e, e, sums);
  }
  return hn::GetLane(hn::SumOfLanes(kD, sums));
}

double NormalEquations(const PerceptronShape& shape, const double* weights, const Samples& samples,
                       Matrix& jtj, double* jte) {
  const std::size_t inputs = shape.inputs;
  const std::size_t hidden = shape.hidden;
  const std::size_t p = shape.parameters();
  const double* v = weights + shape.hidden_weights();
  ColumnBlock columns(p + 1, kBlockRows);  // the Jacobian's, then the residual
  ProductSums sums(p + 1, p + 1, true);
  for (std::size_t c = 0; c <= p; ++c) {
    sums.set_left(c, columns.column(c));
    sums.set_right(c, columns.column(c));
  }
  double* const e = columns.column(p);
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t last = std::min(first + kBlockRows, samples.padded_rows());
    std::copy_n(samples.mask_data() + first, last - first, columns.column(p - 1));
    for (std::size_t j = 0; j < hidden; ++j) {
      double* const h = columns.column(shape.hidden_weights() + j);
      HiddenColumn(shape, weights, j, samples, first, last, h);
      HiddenDerivatives(shape, v[j], h, samples, first, last, columns.column(j * inputs), kBlockRows,
                        columns.column(hidden * inputs + j));
    }
    for (std::size_t row = first; row < last; row += hn::Lanes(kD)) {
      const std::size_t at = row - first;
      V residual = hn::NegMulAdd(hn::Set(kD, v[hidden]), hn::LoadU(kD, samples.mask_data() + row),
                                 hn::LoadU(kD, samples.target_data() + row));
      for (std::size_t j = 0; j < hidden; ++j) {
        const V h = hn::LoadU(kD, columns.column(shape.hidden_weights() + j) + at);
        residual = hn::NegMulAdd(hn::Set(kD, v[j]), h, residual);
      }
      hn::StoreU(residual, kD, e + at);
    }
    sums.add(last - first);
  }
  for (std::size_t c = 0; c < p; ++c) {
    for (std::size_t r = 0; r <= c; ++r) jtj(r, c) = jtj(c, r) = sums.sum(r, c);
    jte[c] = sums.sum(c, p);
  }
  return sums.sum(p, p);
}

void Activations(const PerceptronShape& shape, const double* weights, const Samples& samples,
                 ColumnBlock& phi) {
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    HiddenColumn(shape, weights, j, samples, 0, samples.padded_rows(), phi.column(j));
  }
  std::copy_n(samples.mask_data(), samples.padded_rows(), phi.column(shape.hidden));
}

void Transform(const ColumnBlock& phi, const Matrix& transform, const Samples& samples, ColumnBlock& q,
               Matrix& gram, double* qty) {
  const std::size_t n = phi.columns();
  ProductSums sums(n, n + 1, true);
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t last = std::min(first + kBlockRows, samples.padded_rows());
    for (std::size_t row = first; row < last; row += hn::Lanes(kD)) {
      for (std::size_t c = 0; c < n; ++c) {
        V value = hn::Zero(kD);
        for (std::size_t k = 0; k <= c; ++k) {
          value = hn::MulAdd(hn::Set(kD, transform(k, c)), hn::LoadU(kD, phi.column(k) + row), value);
        }
        hn::StoreU(value, kD, q.column(c) + row);
      }
    }
    for (std::size_t c = 0; c < n; ++c) {
      sums.set_left(c, q.column(c) + first);
      sums.set_right(c, q.column(c) + first);
    }
    sums.set_right(n, samples.target_data() + first);
    sums.add(last - first);
  }
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t r = 0; r <= c; ++r) gram(r, c) = gram(c, r) = sums.sum(r, c);
    qty[c] = sums.sum(c, n);
  }
}

double Residual(const ColumnBlock& phi, const double* coefficients, const Samples& samples,
                const ColumnBlock& q, double* residual, double* qt_residual) {
  V sums = hn::Zero(kD);
  ProductSums products(q.columns(), 1, false);
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t last = std::min(first + kBlockRows, samples.padded_rows());
    for (std::size_t row = first; row < last; row += hn::Lanes(kD)) {
      const V e = ResidualVector(phi, coefficients, samples, row);
      hn::StoreU(e, kD, residual + row);
      sums = hn::MulAdd(e, e, sums);
    }
    for (std::size_t c = 0; c < q.columns(); ++c) products.set_left(c, q.column(c) + first);
    products.set_right(0, residual + first);
    products.add(last - first);
  }
  for (std::size_t c = 0; c < q.columns(); ++c) qt_residual[c] = products.sum(c, 0);
  return hn::GetLane(hn::SumOfLanes(kD, sums));
}

// Columns of D for a block of rows: w_1 … w_H, then b_1 … b_H.
void HiddenJacobianBlock(const PerceptronShape& shape, const double* v, const ColumnBlock& phi,
                         const Samples& samples, std::size_t first, std::size_t last, ColumnBlock& d) {
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    HiddenDerivatives(shape, v[j], phi.column(j) + first, samples, first, last, d.column(j * shape.inputs),
                      kBlockRows, d.column(shape.hidden * shape.inputs + j));
  }
}

void Cross(const PerceptronShape& shape, const double* v, const ColumnBlock& phi, const ColumnBlock& q,
           const Samples& samples, Matrix& cross) {
  const std::size_t p = shape.hidden_weights();
  ColumnBlock d(p, kBlockRows);
  ProductSums sums(q.columns(), p, false);
  for (std::size_t c = 0; c < p; ++c) sums.set_right(c, d.column(c));
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t last = std::min(first + kBlockRows, samples.padded_rows());
    HiddenJacobianBlock(shape, v, phi, samples, first, last, d);
    for (std::size_t c = 0; c < q.columns(); ++c) sums.set_left(c, q.column(c) + first);
    sums.add(last - first);
  }
  for (std::size_t c = 0; c < p; ++c) {
    for (std::size_t r = 0; r < q.columns(); ++r) cross(r, c) = sums.sum(r, c);
  }
}

// column -= q * coefficients over rows [first, last).
HWY_INLINE void Project(const ColumnBlock& q, const Matrix& cross, std::size_t column, std::size_t first,
                        std::size_t last, double* values) {
  for (std::size_t row = first; row < last; row += hn::Lanes(kD)) {
    V value = hn::LoadU(kD, values + (row - first));
    for (std::size_t k = 0; k < q.columns(); ++k) {
      value = hn::NegMulAdd(hn::Set(kD, cross(k, column)), hn::LoadU(kD, q.column(k) + row), value);
    }
    hn::StoreU(value, kD, values + (row - first));
  }
}

void ProjectedNormal(const PerceptronShape& shape, const double* v, const ColumnBlock& phi,
                     const ColumnBlock& q, const Matrix& cross, const ColumnBlock& residual,
                     const Samples& samples, Matrix& normal, double* gradient) {
  const std::size_t p = shape.hidden_weights();
  ColumnBlock d(p, kBlockRows);
  ProductSums sums(p, p + 1, true);
  for (std::size_t c = 0; c < p; ++c) {
    sums.set_left(c, d.column(c));
    sums.set_right(c, d.column(c));
  }
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t last = std::min(first + kBlockRows, samples.padded_rows());
    HiddenJacobianBlock(shape, v, phi, samples, first, last, d);
    for (std::size_t c = 0; c < p; ++c) Project(q, cross, c, first, last, d.column(c));
    sums.set_right(p, residual.column(0) + first);
    sums.add(last - first);
  }
  for (std::size_t c = 0; c < p; ++c) {
    for (std::size_t r = 0; r <= c; ++r) normal(r, c) = normal(c, r) = sums.sum(r, c);
    gradient[c] = sums.sum(c, p);
  }
}

void Transposed(const PerceptronShape& shape, const double* v, const ColumnBlock& phi, const ColumnBlock& q,
                const ColumnBlock& residual, const Samples& samples, double* dt_residual,
                double* qt_residual) {
  const std::size_t p = shape.hidden_weights();
  ColumnBlock d(p, kBlockRows);
  ProductSums sums(p + q.columns(), 1, false);
  for (std::size_t c = 0; c < p; ++c) sums.set_left(c, d.column(c));
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t last = std::min(first + kBlockRows, samples.padded_rows());
    HiddenJacobianBlock(shape, v, phi, samples, first, last, d);
    for (std::size_t c = 0; c < q.columns(); ++c) sums.set_left(p + c, q.column(c) + first);
    sums.set_right(0, residual.column(0) + first);
    sums.add(last - first);
  }
  for (std::size_t c = 0; c < p; ++c) dt_residual[c] = sums.sum(c, 0);
  for (std::size_t c = 0; c < q.columns(); ++c) qt_residual[c] = sums.sum(p + c, 0);
}

const char* Target() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proofmass {

HWY_EXPORT(Forward);
HWY_EXPORT(NormalEquations);
HWY_EXPORT(Activations);
HWY_EXPORT(Transform);
HWY_EXPORT(Residual);
HWY_EXPORT(Cross);
HWY_EXPORT(ProjectedNormal);
HWY_EXPORT(Transposed);
HWY_EXPORT(Target);

void perceptron_outputs(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples,
                        std::span<double> outputs) {
  AlignedColumn padded(samples.padded_rows());
  HWY_DYNAMIC_DISPATCH(Forward)(shape, weights.data(), samples, padded.data());
  std::copy_n(padded.begin(), samples.rows(), outputs.begin());
}

double perceptron_sse(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples) {
  return HWY_DYNAMIC_DISPATCH(Forward)(shape, weights.data(), samples, nullptr);
}

double perceptron_normal_equations(const PerceptronShape& shape, std::span<const double> weights,
                                   const Samples& samples, Matrix& jtj, std::span<double> jte) {
  return HWY_DYNAMIC_DISPATCH(NormalEquations)(shape, weights.data(), samples, jtj, jte.data());
}

void hidden_activations(const PerceptronShape& shape, std::span<const double> hidden_weights,
                        const Samples& samples, ColumnBlock& phi) {
  HWY_DYNAMIC_DISPATCH(Activations)(shape, hidden_weights.data(), samples, phi);
}

void transform_columns(const ColumnBlock& phi, const Matrix& transform, const Samples& samples,
                       ColumnBlock& q, Matrix& gram, std::span<double> qty) {
  HWY_DYNAMIC_DISPATCH(Transform)(phi, transform, samples, q, gram, qty.data());
}

double column_residual(const ColumnBlock& phi, std::span<const double> coefficients, const Samples& samples,
                       const ColumnBlock& q, ColumnBlock& residual, std::span<double> qt_residual) {
  return HWY_DYNAMIC_DISPATCH(Residual)(phi, coefficients.data(), samples, q, residual.column(0),
                                        qt_residual.data());
}

void hidden_jacobian_cross(const PerceptronShape& shape, std::span<const double> v, const ColumnBlock& phi,
                           const ColumnBlock& q, const Samples& samples, Matrix& cross) {
  HWY_DYNAMIC_DISPATCH(Cross)(shape, v.data(), phi, q, samples, cross);
}

void projected_normal_equations(const PerceptronShape& shape, std::span<const double> v,
                                const ColumnBlock& phi, const ColumnBlock& q, const Matrix& cross,
                                const ColumnBlock& residual, const Samples& samples, Matrix& normal,
                                std::span<double> gradient) {
  HWY_DYNAMIC_DISPATCH(ProjectedNormal)
  (shape, v.data(), phi, q, cross, residual, samples, normal, gradient.data());
}

void hidden_jacobian_transposed(const PerceptronShape& shape, std::span<const double> v,
                                const ColumnBlock& phi, const ColumnBlock& q, const ColumnBlock& residual,
                                const Samples& samples, std::span<double> dt_residual,
                                std::span<double> qt_residual) {
  HWY_DYNAMIC_DISPATCH(Transposed)
  (shape, v.data(), phi, q, residual, samples, dt_residual.data(), qt_residual.data());
}

const char* kernel_target() { return HWY_DYNAMIC_DISPATCH(Target)(); }

}  // namespace proofmass
#endif  // HWY_ONCE
