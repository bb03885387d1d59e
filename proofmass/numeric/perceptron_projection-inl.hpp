// SPDX-License-Identifier: Apache-2.0
// What variable projection needs of a network, compiled once for every instruction set: included through
// foreach_target, so without an ordinary include guard.
#if defined(PROOFMASS_PERCEPTRON_PROJECTION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_PERCEPTRON_PROJECTION_INL
#undef PROOFMASS_PERCEPTRON_PROJECTION_INL
#else
#define PROOFMASS_PERCEPTRON_PROJECTION_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/kernel_scratch_internal.hpp"
#include "proofmass/numeric/perceptron_kernels-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// The columns of a block that variable projection needs, one after the other: P = D - q * projection, q = phi
// * transform, the error. With an empty projection P has no columns.
class ProjectedColumns {
 public:
  // `slopes`: whether they are wanted even so.
  ProjectedColumns(const Network& network, const Samples& samples, const Matrix& transform,
                   const Matrix& projection, bool slopes = false)
      : network_(network),
        samples_(samples),
        transform_(transform),
        projection_(projection),
        p_(projection.columns()),
        slopes_(slopes || p_ > 0),
        phi_(transform.columns()) {}

  [[nodiscard]] std::size_t count() const { return p_ + transform_.columns() + 1; }
  [[nodiscard]] std::size_t storage() const { return (count() + 2 * network_.shape.hidden) * kStride; }

  void start(double* storage) {
    columns_ = storage;
    hidden_.activation = storage + count() * kStride;
    hidden_.slope = slopes_ ? hidden_.activation + network_.shape.hidden * kStride : nullptr;
    hidden_.error = storage + (count() - 1) * kStride;
    for (std::size_t j = 0; j < network_.shape.hidden; ++j) phi_[j] = hidden_.activation + j * kStride;
  }

  void fill(std::size_t first, std::size_t rows) {
    HiddenBlock(network_, samples_, first, rows, hidden_);
    phi_[network_.shape.hidden] = samples_.mask_data() + first;
    for (std::size_t c = 0; c < network_.fixed.columns(); ++c) {
      phi_[network_.shape.output_weights() + c] = network_.fixed.column(c) + first;
    }
    double* const q = columns_ + p_ * kStride;
    TransformBlock(phi_.data(), transform_, rows, q);
    if (p_ > 0) {
      ProjectBlock(network_.shape, samples_, first, rows, hidden_.slope, q, projection_, columns_);
    }
  }

  [[nodiscard]] const double* column(std::size_t c) const { return columns_ + c * kStride; }
  [[nodiscard]] const HiddenColumns& hidden() const { return hidden_; }

 private:
  const Network& network_;
  const Samples& samples_;
  const Matrix& transform_;
  const Matrix& projection_;
  std::size_t p_;
  bool slopes_;
  std::vector<const double*> phi_;
  double* columns_ = nullptr;
  HiddenColumns hidden_{};
};

void SumProducts(const PerceptronShape& shape, const double* weights, const Samples& samples,
                 const ColumnBlock& fixed, const Matrix& transform, const Matrix& projection,
                 PerceptronProducts& products) {
  const Network network{shape, weights, fixed};
  ProjectedColumns columns(network, samples, transform, projection);
  const std::size_t count = columns.count();
  ProductSums sums(count, count, true);
  double* const storage = kernel_scratch(sums.storage() + columns.storage());
  std::fill_n(storage, sums.storage(), 0.0);
  sums.start(storage);
  columns.start(storage + sums.storage());
  for (std::size_t c = 0; c < count; ++c) sums.left[c] = {columns.column(c), nullptr};
  sums.right = columns.column(0);
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t rows = std::min(kBlockRows, samples.padded_rows() - first);
    columns.fill(first, rows);
    sums.add(rows);
  }
  sums.finish();

  const std::size_t p = projection.columns();
  const std::size_t n = transform.columns();
  for (std::size_t c = 0; c < p; ++c) {
    for (std::size_t r = 0; r <= c; ++r) products.pp(r, c) = products.pp(c, r) = sums.total(r, c);
    for (std::size_t k = 0; k < n; ++k) products.pq(c, k) = sums.total(c, p + k);
    products.pe[c] = sums.total(c, p + n);
  }
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t r = 0; r <= c; ++r) products.qq(r, c) = products.qq(c, r) = sums.total(p + r, p + c);
    products.qe[c] = sums.total(p + c, p + n);
  }
  products.ee = sums.total(p + n, p + n);
}

// Dᵀq: the slope of each unit with each input and one, times the columns of q.
void CrossProducts(const PerceptronShape& shape, const double* weights, const Samples& samples,
                   const ColumnBlock& fixed, const Matrix& transform, Matrix& dq) {
  const Network network{shape, weights, fixed};
  const Matrix none;
  ProjectedColumns columns(network, samples, transform, none, true);
  const std::size_t inputs = shape.inputs;
  const std::size_t n = transform.columns();
  ProductSums sums(shape.hidden * (inputs + 1), n, false);
  double* const storage = kernel_scratch(sums.storage() + columns.storage());
  std::fill_n(storage, sums.storage(), 0.0);
  sums.start(storage);
  columns.start(storage + sums.storage());
  sums.right = columns.column(0);
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t rows = std::min(kBlockRows, samples.padded_rows() - first);
    columns.fill(first, rows);
    for (std::size_t j = 0; j < shape.hidden; ++j) {
      const double* const slope = columns.hidden().slope + j * kStride;
      for (std::size_t k = 0; k < inputs; ++k) {
        sums.left[j * inputs + k] = {slope, samples.input_data(k) + first};
      }
      sums.left[shape.hidden * inputs + j] = {slope, samples.mask_data() + first};
    }
    sums.add(rows);
  }
  sums.finish();
  for (std::size_t r = 0; r < sums.left.size(); ++r) {
    for (std::size_t c = 0; c < n; ++c) dq(r, c) = sums.total(r, c);
  }
}

// Second derivative of the output along `direction`, for the block of rows from `first` on: a unit with
// argument z and dz along the direction gives 2 dz (dv (1 - h²) - slope h dz).
template <std::size_t kInputs>
void SecondDerivative(const Network& network, const double* direction, const Samples& samples,
                      std::size_t first, std::size_t rows, const HiddenColumns& columns, double* second) {
  const double* const dv = direction + network.shape.hidden_weights();
  ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
    constexpr std::size_t kVectors = decltype(together)::value;
    V sum[kVectors];
    Each<kVectors>([&](std::size_t i) HWY_ATTR { sum[i] = hn::Zero(kD); });
    for (std::size_t j = 0; j < network.shape.hidden; ++j) {
      V dz[kVectors];
      HiddenArgument<kInputs>(network.shape, direction, j, samples, first + at, dz);
      Each<kVectors>([&](std::size_t i) HWY_ATTR {
        const V h = hn::LoadU(kD, columns.activation + j * kStride + at + i * kLanes);
        const V slope = hn::LoadU(kD, columns.slope + j * kStride + at + i * kLanes);
        const V rate = hn::Mul(hn::Set(kD, dv[j]), hn::NegMulAdd(h, h, hn::Set(kD, 1.0)));
        sum[i] = hn::MulAdd(dz[i], hn::NegMulAdd(hn::Mul(slope, h), dz[i], rate), sum[i]);
      });
    }
    Each<kVectors>([&](std::size_t i)
                       HWY_ATTR { hn::StoreU(hn::Add(sum[i], sum[i]), kD, second + at + i * kLanes); });
  });
  ClearPadding(second, samples.rows() - first, rows);
}

// column -= q * coefficients.
void SubtractColumns(const double* q, std::span<const double> coefficients, std::size_t rows,
                     double* column) {
  for (const double coefficient : coefficients) {
    const V factor = hn::Set(kD, coefficient);
    for (std::size_t at = 0; at < rows; at += kLanes) {
      hn::StoreU(hn::NegMulAdd(factor, hn::LoadU(kD, q + at), hn::LoadU(kD, column + at)), kD, column + at);
    }
    q += kStride;
  }
}

void Curvature(const PerceptronShape& shape, const double* weights, const double* direction,
               const Samples& samples, const ColumnBlock& fixed, const Matrix& transform,
               std::span<const double> removed, double* d_second, double* q_second) {
  const Network network{shape, weights, fixed};
  const Matrix none;
  ProjectedColumns columns(network, samples, transform, none, true);
  const std::size_t inputs = shape.inputs;
  const std::size_t n = transform.columns();
  ProductSums by_weight(shape.hidden, inputs + 1, false), by_output(1, n, false);
  double* const storage =
      kernel_scratch(by_weight.storage() + by_output.storage() + columns.storage() + (inputs + 2) * kStride);
  std::fill_n(storage, by_weight.storage() + by_output.storage(), 0.0);
  by_weight.start(storage);
  by_output.start(storage + by_weight.storage());
  double* const second = storage + by_weight.storage() + by_output.storage();
  double* const input = second + kStride;  // the inputs, then ones
  columns.start(input + (inputs + 1) * kStride);
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    by_weight.left[j] = {second, columns.hidden().slope + j * kStride};
  }
  by_weight.right = input;
  by_output.left[0] = {second, nullptr};
  by_output.right = columns.column(0);
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t rows = std::min(kBlockRows, samples.padded_rows() - first);
    columns.fill(first, rows);
    WithInputs(inputs, [&](auto count) HWY_ATTR {
      SecondDerivative<decltype(count)::value>(network, direction, samples, first, rows, columns.hidden(),
                                               second);
    });
    SubtractColumns(columns.column(0), removed, rows, second);
    for (std::size_t k = 0; k < inputs; ++k) {
      std::copy_n(samples.input_data(k) + first, rows, input + k * kStride);
    }
    std::copy_n(samples.mask_data() + first, rows, input + inputs * kStride);
    by_weight.add(rows);
    by_output.add(rows);
  }
  by_weight.finish();
  by_output.finish();
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    for (std::size_t k = 0; k < inputs; ++k) d_second[j * inputs + k] = by_weight.total(j, k);
    d_second[shape.hidden * inputs + j] = by_weight.total(j, inputs);
  }
  for (std::size_t c = 0; c < n; ++c) q_second[c] = by_output.total(0, c);
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_PERCEPTRON_PROJECTION_INL
