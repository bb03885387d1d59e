// SPDX-License-Identifier: Apache-2.0
// The columns of a block of samples for variable projection, compiled once for every instruction set. Only
// separable_kernels.cpp includes this file, through foreach_target, so it has no ordinary include guard.
//
// Operations of the multiplication ports per sample, for I inputs, H hidden units, n columns that the output
// is linear in (H + 1, and fixed ones) and p = H (I + 1) hidden weights, beyond activations, error and
// slopes:
//   q = phi T             n (n + 1) / 2
//   qᵀq, qᵀe, eᵀe         (n + 1) (n + 2) / 2
//   Dᵀq                   p (n + 1)
//   P = D - q C           p (n + 1) - H
//   PᵀP, Pᵀe              p (p + 3) / 2
//   Pᵀq                   p n, where asked for
//   second derivative     H (I + 5), its part in q 3 n, Dᵀs p + I + 1
// 3-7-1, n = 8: 36, 45, 252, 245, 434, 224 and 112. Triangles take one more for every two rows.
#if defined(PROOFMASS_SEPARABLE_COLUMNS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_SEPARABLE_COLUMNS_INL
#undef PROOFMASS_SEPARABLE_COLUMNS_INL
#else
#define PROOFMASS_SEPARABLE_COLUMNS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/network/perceptron_kernels-inl.hpp"
#include "proofmass/numeric/network/separable_kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// q = phi * transform (upper triangular).
void TransformBlock(const double* const* phi, const Matrix& transform, std::size_t rows, double* q) {
  for (std::size_t c = 0; c < transform.columns(); ++c, q += kStride) {
    ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
      constexpr std::size_t kVectors = decltype(together)::value;
      V sums[kVectors];
      Each<kVectors>([&](std::size_t i) HWY_ATTR { sums[i] = hn::Zero(kD); });
      for (std::size_t r = 0; r <= c; ++r) {
        const V factor = hn::Set(kD, transform(r, c));
        const double* const column = phi[r] + at;
        Each<kVectors>([&](std::size_t i) HWY_ATTR {
          sums[i] = hn::MulAdd(factor, hn::LoadU(kD, column + i * kLanes), sums[i]);
        });
      }
      Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(sums[i], kD, q + at + i * kLanes); });
    });
  }
}

// kColumns columns of P = D - q * projection, with indices c[0] … among all. They belong to one unit and to
// inputs[0] … (null for its bias), for kVectors vectors of rows.
template <std::size_t kColumns, std::size_t kVectors>
HWY_INLINE void ProjectRows(const double* slope, const double* const* inputs, const double* q,
                            const Matrix& projection, const std::size_t* c, std::size_t at, double* p) {
  V sums[kColumns][kVectors];
  Each<kColumns>([&](std::size_t k) HWY_ATTR {
    Each<kVectors>([&](std::size_t i) HWY_ATTR {
      const V s = hn::LoadU(kD, slope + at + i * kLanes);
      sums[k][i] = inputs[k] == nullptr ? s : hn::Mul(s, hn::LoadU(kD, inputs[k] + at + i * kLanes));
    });
  });
  for (std::size_t r = 0; r < projection.rows(); ++r, q += kStride) {
    V values[kVectors];
    Each<kVectors>([&](std::size_t i)
                       HWY_ATTR { values[i] = InRegister(hn::LoadU(kD, q + at + i * kLanes)); });
    Each<kColumns>([&](std::size_t k) HWY_ATTR {
      const V factor = hn::Set(kD, projection(r, c[k]));
      Each<kVectors>([&](std::size_t i)
                         HWY_ATTR { sums[k][i] = hn::NegMulAdd(factor, values[i], sums[k][i]); });
    });
  }
  Each<kColumns>([&](std::size_t k) HWY_ATTR {
    Each<kVectors>([&](std::size_t i)
                       HWY_ATTR { hn::StoreU(sums[k][i], kD, p + c[k] * kStride + at + i * kLanes); });
  });
}

// P = D - q * projection, columns in the order of the hidden weights.
void ProjectBlock(const PerceptronShape& shape, const Samples& samples, std::size_t first, std::size_t rows,
                  const double* slopes, const double* q, const Matrix& projection, double* p) {
  std::vector<const double*> inputs(shape.inputs + 1, nullptr);
  for (std::size_t k = 0; k < shape.inputs; ++k) inputs[k] = samples.input_data(k) + first;
  std::vector<std::size_t> columns(shape.inputs + 1);
  for (std::size_t j = 0; j < shape.hidden; ++j, slopes += kStride) {
    for (std::size_t k = 0; k < shape.inputs; ++k) columns[k] = j * shape.inputs + k;
    columns[shape.inputs] = shape.hidden * shape.inputs + j;
    std::size_t k = 0;
    for (; k + 2 <= columns.size(); k += 2) {
      ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
        ProjectRows<2, decltype(together)::value>(slopes, &inputs[k], q, projection, &columns[k], at, p);
      });
    }
    if (k == columns.size()) continue;
    ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
      ProjectRows<1, decltype(together)::value>(slopes, &inputs[k], q, projection, &columns[k], at, p);
    });
  }
}

// The columns of a block for variable projection. Columns kept from earlier passes are not computed again.
class SeparableColumns {
 public:
  SeparableColumns(const SeparableNetwork& network, SeparableState& state, bool slopes)
      : network_{network.shape, network.weights.data(), network.fixed},
        samples_(network.samples),
        transform_(network.transform),
        state_(state),
        slopes_(slopes),
        phi_(basis()) {}

  [[nodiscard]] std::size_t basis() const { return transform_.columns(); }
  [[nodiscard]] bool keeps() const { return state_.columns.keeps(); }
  // In values.
  [[nodiscard]] std::size_t scratch() const { return keeps() ? 0 : state_.columns.block_size(); }
  void start(double* scratch) { scratch_ = scratch; }

  void fill(std::size_t first, std::size_t rows) {
    const Kept kept = keeps() ? state_.kept : Kept::nothing;
    block_ = state_.columns.block(first, scratch_);
    if (kept >= Kept::derivatives) return;
    hidden_ = {.activation = second() + kStride,
               .slope = slopes_ ? block_ + slope_at(0) : nullptr,
               .error = block_ + basis() * kStride,
               .weighted = true};
    if (kept == Kept::nothing) {
      HiddenBlock(network_, samples_, first, rows, hidden_);
    } else {
      HiddenBlock<true>(network_, samples_, first, rows, hidden_);
    }
    if (kept == Kept::basis) return;
    for (std::size_t j = 0; j < network_.shape.hidden; ++j) phi_[j] = hidden_.activation + j * kStride;
    phi_[network_.shape.hidden] = samples_.mask_data() + first;
    for (std::size_t c = 0; c < network_.fixed.columns(); ++c) {
      phi_[network_.shape.output_weights() + c] = network_.fixed.column(c) + first;
    }
    TransformBlock(phi_.data(), transform_, rows, block_);
  }

  // Call after the last block: later passes then find the columns that this pass has filled.
  void leave() { leave(std::max(state_.kept, slopes_ ? Kept::derivatives : Kept::basis)); }
  void leave(Kept kept) { state_.kept = kept; }
  [[nodiscard]] bool has_second() const { return keeps() && state_.kept == Kept::second; }

  // The columns of the block filled last.
  [[nodiscard]] const double* q() const { return block_; }
  [[nodiscard]] const double* error() const { return block_ + basis() * kStride; }
  [[nodiscard]] double* second() const { return block_ + (basis() + 1) * kStride; }
  [[nodiscard]] const double* activation(std::size_t j) const { return second() + (1 + j) * kStride; }
  [[nodiscard]] const double* slope(std::size_t j) const { return block_ + slope_at(j); }

 private:
  [[nodiscard]] std::size_t slope_at(std::size_t j) const {
    return (basis() + 2 + network_.shape.hidden + j) * kStride;
  }

  Network network_;
  const Samples& samples_;
  const Matrix& transform_;
  SeparableState& state_;
  bool slopes_;
  std::vector<const double*> phi_;
  double* scratch_ = nullptr;
  double* block_ = nullptr;
  HiddenColumns hidden_;
};

// Second derivative of the output along `direction`, for the block of rows from `first` on. A unit with
// argument z and dz along the direction gives 2 dz (dv (1 - h²) - slope h dz).
template <std::size_t kInputs>
void SecondDerivativeBlock(const PerceptronShape& shape, const double* direction, const Samples& samples,
                           std::size_t first, std::size_t rows, const SeparableColumns& columns) {
  const double* const dv = direction + shape.hidden_weights();
  double* const second = columns.second();
  ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
    constexpr std::size_t kVectors = decltype(together)::value;
    V sum[kVectors];
    Each<kVectors>([&](std::size_t i) HWY_ATTR { sum[i] = hn::Zero(kD); });
    for (std::size_t j = 0; j < shape.hidden; ++j) {
      V dz[kVectors];
      HiddenArgument<kInputs>(shape, direction, j, samples, first + at, dz);
      Each<kVectors>([&](std::size_t i) HWY_ATTR {
        const V h = hn::LoadU(kD, columns.activation(j) + at + i * kLanes);
        const V slope = hn::LoadU(kD, columns.slope(j) + at + i * kLanes);
        const V rate = hn::Mul(hn::Set(kD, dv[j]), hn::NegMulAdd(h, h, hn::Set(kD, 1.0)));
        sum[i] = hn::MulAdd(dz[i], hn::NegMulAdd(hn::Mul(slope, h), dz[i], rate), sum[i]);
      });
    }
    Each<kVectors>([&](std::size_t i)
                       HWY_ATTR { hn::StoreU(hn::Add(sum[i], sum[i]), kD, second + at + i * kLanes); });
  });
  ClearPadding(second, samples.rows() - first, rows);
}

void SecondDerivative(const SeparableNetwork& network, const double* direction, std::size_t first,
                      std::size_t rows, const SeparableColumns& columns) {
  WithInputs(network.shape.inputs, [&](auto inputs) HWY_ATTR {
    SecondDerivativeBlock<decltype(inputs)::value>(network.shape, direction, network.samples, first, rows,
                                                   columns);
  });
}

// column -= q * coefficients.
void SubtractColumns(const double* q, std::span<const double> coefficients, std::size_t rows,
                     double* column) {
  ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
    constexpr std::size_t kVectors = decltype(together)::value;
    V rest[kVectors];
    Each<kVectors>([&](std::size_t i) HWY_ATTR { rest[i] = hn::LoadU(kD, column + at + i * kLanes); });
    for (std::size_t c = 0; c < coefficients.size(); ++c) {
      const V factor = hn::Set(kD, coefficients[c]);
      const double* const values = q + c * kStride + at;
      Each<kVectors>([&](std::size_t i) HWY_ATTR {
        rest[i] = hn::NegMulAdd(factor, hn::LoadU(kD, values + i * kLanes), rest[i]);
      });
    }
    Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(rest[i], kD, column + at + i * kLanes); });
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_SEPARABLE_COLUMNS_INL
