// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/term_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "proofmass/numeric/row_shares.hpp"

namespace proofmass {
namespace {

using Column = std::array<double, RowBlock::kRows>;

// Interleaved, because a running maximum waits for the one before.
double largest_magnitude(std::span<const double> values) {
  std::array<double, 8> largest{};
  std::size_t k = 0;
  for (; k + largest.size() <= values.size(); k += largest.size()) {
    for (std::size_t lane = 0; lane < largest.size(); ++lane) {
      const double magnitude = std::abs(values[k + lane]);
      largest[lane] = magnitude > largest[lane] ? magnitude : largest[lane];
    }
  }
  for (; k < values.size(); ++k) largest[0] = std::max(largest[0], std::abs(values[k]));
  return *std::max_element(largest.begin(), largest.end());
}

// The power of two that brings a range below one.
double scale_of(double range) {
  return range > 0.0 && std::isfinite(range) ? std::scalbn(1.0, -(std::ilogb(range) + 1)) : 1.0;
}

void multiply(const double* a, const double* b, std::size_t count, double* result) {
  for (std::size_t r = 0; r < count; ++r) result[r] = a[r] * b[r];
}

// The first, second and third powers of one axis over a block.
class AxisPowers {
 public:
  // An axis without values is zero.
  AxisPowers(const std::vector<double>& values, double scale, std::size_t first, std::size_t count) {
    if (values.empty()) {
      powers_ = {};
      return;
    }
    for (std::size_t r = 0; r < count; ++r) powers_[0][r] = values[first + r] * scale;
    multiply(of(1), of(1), count, powers_[1].data());
    multiply(of(2), of(1), count, powers_[2].data());
  }
  [[nodiscard]] const double* of(int exponent) const {
    return powers_[static_cast<std::size_t>(exponent - 1)].data();
  }

 private:
  std::array<Column, 3> powers_;
};

// The regressor of one term, multiplied in the order that regressor() has.
void write_regressor(Term term, const std::array<AxisPowers, 3>& axes, std::size_t count, double* column) {
  if (term == Term::Koq) {
    const double* const a = axes[0].of(1);
    for (std::size_t r = 0; r < count; ++r) column[r] = std::abs(a[r]) * a[r];
    return;
  }
  bool empty = true;
  for (const Axis axis : kAxes) {
    const auto k = static_cast<std::size_t>(axis);
    if (!info(term).uses(axis)) continue;
    const double* const factor = axes[k].of(info(term).powers[k]);
    if (empty) {
      std::copy_n(factor, count, column);
    } else {
      multiply(column, factor, count, column);
    }
    empty = false;
  }
  if (empty) std::fill_n(column, count, 1.0);
}

}  // namespace

AxisRanges axis_ranges(const Dataset& data) {
  AxisRanges ranges{};
  for (const Axis axis : kAxes) ranges[static_cast<std::size_t>(axis)] = largest_magnitude(data.along(axis));
  return ranges;
}

TermRows::TermRows(const Dataset& data, TermList terms, const AxisRanges& ranges)
    : data_(data), terms_(std::move(terms)) {
  std::transform(ranges.begin(), ranges.end(), axis_scales_.begin(), scale_of);
  for (const Term term : terms_) {
    scales_.push_back(regressor(term, {.i = axis_scales_[0], .o = axis_scales_[1], .p = axis_scales_[2]}));
  }
}

void TermRows::fill(std::size_t first, std::size_t count, RowBlock& block) const {
  const auto powers = [&](Axis axis) {
    return AxisPowers(data_.along(axis), axis_scales_[static_cast<std::size_t>(axis)], first, count);
  };
  const std::array<AxisPowers, 3> axes{powers(Axis::input), powers(Axis::output), powers(Axis::pendulous)};
  for (std::size_t c = 0; c < terms_.size(); ++c) {
    write_regressor(terms_[c], axes, count, block.column(c));
  }
  double* const response = block.column(terms_.size());
  if (data_.output.empty()) {
    std::fill_n(response, count, 0.0);
  } else {
    std::copy_n(data_.output.data() + first, count, response);
  }
}

std::vector<double> static_outputs(const StaticModel& model, const Dataset& inputs) {
  const TermRows rows(inputs, model.terms, {});
  const std::vector<double>& coefficients = model.coefficients;
  std::vector<double> outputs(inputs.rows(), 0.0);
  for_each_row_share(rows.rows(), [&](std::size_t /*share*/, std::size_t first, std::size_t last) {
    RowBlock block(coefficients.size() + 1);
    for (std::size_t row = first; row < last; row += RowBlock::kRows) {
      const std::size_t count = std::min(RowBlock::kRows, last - row);
      rows.fill(row, count, block);
      for (std::size_t c = 0; c < coefficients.size(); ++c) {
        const double* const column = block.column(c);
        for (std::size_t r = 0; r < count; ++r) outputs[row + r] += coefficients[c] * column[r];
      }
    }
  });
  return outputs;
}

}  // namespace proofmass
