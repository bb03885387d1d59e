// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/separable_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "proofmass/numeric/network/separable_kernels.cpp"
#include <hwy/foreach_target.h>
// foreach_target includes this file once for every instruction set; the next headers must come after it.
#include "proofmass/numeric/network/separable_columns-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

void BasisSums(const SeparableNetwork& network, SeparableState& state, BasisProducts& products) {
  SeparableColumns columns(network, state, false);
  const std::size_t n = columns.basis();
  ProductSums sums({.rows = n + 1, .columns = n + 1, .upper = true});
  columns.start(LayOut(columns.scratch(), sums));
  ForEachBlock(network.samples, [&](std::size_t first, std::size_t rows) HWY_ATTR {
    columns.fill(first, rows);
    for (std::size_t c = 0; c <= n; ++c) sums.left[c] = {columns.q() + c * kStride, nullptr};
    sums.right = columns.q();
    sums.add(rows);
  });
  columns.leave();
  sums.finish();
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t r = 0; r <= c; ++r) products.qq(r, c) = products.qq(c, r) = sums.total(r, c);
    products.qe[c] = sums.total(c, n);
  }
  products.ee = sums.total(n, n);
}

// Products of the slope of each unit times each input (and one) with the columns of q.
void CrossSums(const SeparableNetwork& network, SeparableState& state, Matrix& dq) {
  const Samples& samples = network.samples;
  SeparableColumns columns(network, state, true);
  const std::size_t inputs = network.shape.inputs;
  const std::size_t hidden = network.shape.hidden;
  ProductSums sums({.rows = hidden * (inputs + 1), .columns = columns.basis(), .pairs = true});
  columns.start(LayOut(columns.scratch(), sums));
  ForEachBlock(samples, [&](std::size_t first, std::size_t rows) HWY_ATTR {
    columns.fill(first, rows);
    for (std::size_t j = 0; j < hidden; ++j) {
      for (std::size_t k = 0; k < inputs; ++k) {
        sums.left[j * inputs + k] = {columns.slope(j), samples.input_data(k) + first};
      }
      sums.left[hidden * inputs + j] = {columns.slope(j), samples.mask_data() + first};
    }
    sums.right = columns.q();
    sums.add(rows);
  });
  columns.leave();
  sums.finish();
  for (std::size_t r = 0; r < sums.left.size(); ++r) {
    for (std::size_t c = 0; c < columns.basis(); ++c) dq(r, c) = sums.total(r, c);
  }
}

void ProjectedSums(const SeparableNetwork& network, SeparableState& state, const Matrix& projection,
                   Matrix& pp, double* pe, Matrix* pq) {
  SeparableColumns columns(network, state, true);
  const std::size_t p = projection.columns();
  const std::size_t n = columns.basis();
  ProductSums sums({.rows = p, .columns = p + 1, .upper = true});
  ProductSums by_basis({.rows = pq == nullptr ? 0 : p, .columns = n});
  // The columns of P, followed by the error.
  double* const projected = LayOut((p + 1) * kStride + columns.scratch(), sums, by_basis);
  columns.start(projected + (p + 1) * kStride);
  for (std::size_t c = 0; c < p; ++c) sums.left[c] = {projected + c * kStride, nullptr};
  std::copy_n(sums.left.begin(), by_basis.left.size(), by_basis.left.begin());
  sums.right = projected;
  ForEachBlock(network.samples, [&](std::size_t first, std::size_t rows) HWY_ATTR {
    columns.fill(first, rows);
    ProjectBlock(network.shape, network.samples, first, rows, columns.slope(0), columns.q(), projection,
                 projected);
    std::copy_n(columns.error(), rows, projected + p * kStride);
    sums.add(rows);
    by_basis.right = columns.q();
    by_basis.add(rows);
  });
  columns.leave();
  sums.finish();
  by_basis.finish();
  for (std::size_t c = 0; c < p; ++c) {
    for (std::size_t r = 0; r <= c; ++r) pp(c, r) = sums.total(r, c);
    pe[c] = sums.total(c, p);
  }
  for (std::size_t c = 0; c < by_basis.left.size(); ++c) {
    for (std::size_t k = 0; k < n; ++k) (*pq)(c, k) = by_basis.total(c, k);
  }
}

void SecondBasisSums(const SeparableNetwork& network, SeparableState& state, const double* direction,
                     double* q_second) {
  SeparableColumns columns(network, state, true);
  ProductSums sums({.rows = 1, .columns = columns.basis()});
  columns.start(LayOut(columns.scratch(), sums));
  ForEachBlock(network.samples, [&](std::size_t first, std::size_t rows) HWY_ATTR {
    columns.fill(first, rows);
    SecondDerivative(network, direction, first, rows, columns);
    sums.left[0] = {columns.second(), nullptr};
    sums.right = columns.q();
    sums.add(rows);
  });
  columns.leave(Kept::second);
  sums.finish();
  for (std::size_t c = 0; c < columns.basis(); ++c) q_second[c] = sums.total(0, c);
}

void SecondSums(const SeparableNetwork& network, SeparableState& state, const double* direction,
                std::span<const double> removed, double* d_second, double* q_second) {
  const Samples& samples = network.samples;
  SeparableColumns columns(network, state, true);
  const std::size_t inputs = network.shape.inputs;
  const std::size_t hidden = network.shape.hidden;
  const std::size_t n = columns.basis();
  ProductSums by_weight({.rows = inputs + 1, .columns = hidden, .pairs = true});
  ProductSums by_output({.rows = 1, .columns = n});
  columns.start(LayOut(columns.scratch(), by_weight, by_output));
  ForEachBlock(samples, [&](std::size_t first, std::size_t rows) HWY_ATTR {
    columns.fill(first, rows);
    if (!columns.has_second()) SecondDerivative(network, direction, first, rows, columns);
    SubtractColumns(columns.q(), removed, rows, columns.second());
    for (std::size_t k = 0; k < inputs; ++k) {
      by_weight.left[k] = {columns.second(), samples.input_data(k) + first};
    }
    by_weight.left[inputs] = {columns.second(), samples.mask_data() + first};
    by_weight.right = columns.slope(0);
    by_weight.add(rows);
    by_output.left[0] = {columns.second(), nullptr};
    by_output.right = columns.q();
    by_output.add(rows);
  });
  columns.leave(Kept::derivatives);
  by_weight.finish();
  by_output.finish();
  for (std::size_t j = 0; j < hidden; ++j) {
    for (std::size_t k = 0; k < inputs; ++k) d_second[j * inputs + k] = by_weight.total(k, j);
    d_second[hidden * inputs + j] = by_weight.total(inputs, j);
  }
  for (std::size_t c = 0; c < n; ++c) q_second[c] = by_output.total(0, c);
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proofmass {

HWY_EXPORT(BasisSums);
HWY_EXPORT(CrossSums);
HWY_EXPORT(ProjectedSums);
HWY_EXPORT(SecondBasisSums);
HWY_EXPORT(SecondSums);

void sum_basis_products(const SeparableNetwork& network, SeparableState& state, BasisProducts& products) {
  HWY_DYNAMIC_DISPATCH(BasisSums)(network, state, products);
}

void sum_cross_products(const SeparableNetwork& network, SeparableState& state, Matrix& dq) {
  HWY_DYNAMIC_DISPATCH(CrossSums)(network, state, dq);
}

void sum_projected_products(const SeparableNetwork& network, SeparableState& state, const Matrix& projection,
                            Matrix& pp, std::span<double> pe, Matrix* pq) {
  HWY_DYNAMIC_DISPATCH(ProjectedSums)(network, state, projection, pp, pe.data(), pq);
}

void sum_second_basis(const SeparableNetwork& network, SeparableState& state,
                      std::span<const double> direction, std::span<double> q_second) {
  HWY_DYNAMIC_DISPATCH(SecondBasisSums)(network, state, direction.data(), q_second.data());
}

void sum_second_derivative(const SeparableNetwork& network, SeparableState& state,
                           std::span<const double> direction, std::span<const double> removed,
                           std::span<double> d_second, std::span<double> q_second) {
  HWY_DYNAMIC_DISPATCH(SecondSums)
  (network, state, direction.data(), removed, d_second.data(), q_second.data());
}

}  // namespace proofmass
#endif  // HWY_ONCE
