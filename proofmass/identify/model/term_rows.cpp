// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/term_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "proofmass/numeric/linear/row_chunks.hpp"

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

// The term that is a power of one axis alone.
constexpr std::array<std::array<Term, 3>, 3> kPowers{{{Term::Ki, Term::Kii, Term::Kiii},
                                                      {Term::Ko, Term::Koo, Term::Kooo},
                                                      {Term::Kp, Term::Kpp, Term::Kppp}}};

// The first, second and third powers of the axes over a block: those that are terms in their columns, so that
// they are written once, others aside.
class AxisPowers {
 public:
  AxisPowers(const TermList& terms, RowBlock& block) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = std::find(terms.begin(), terms.end(), kPowers[axis][k]);
        powers_[axis][k] = at == terms.end() ? aside_[axis][k].data()
                                             : block.column(static_cast<std::size_t>(at - terms.begin()));
      }
    }
  }

  // An axis without values is zero.
  void fill(std::size_t axis, const std::vector<double>& values, double scale, std::size_t first,
            std::size_t count) {
    const auto& [one, two, three] = powers_[axis];
    if (values.empty()) {
      for (double* const column : powers_[axis]) std::fill_n(column, count, 0.0);
      return;
    }
    for (std::size_t r = 0; r < count; ++r) one[r] = values[first + r] * scale;
    multiply(one, one, count, two);
    multiply(two, one, count, three);
  }

  [[nodiscard]] const double* of(std::size_t axis, int exponent) const {
    return powers_[axis][static_cast<std::size_t>(exponent - 1)];
  }

 private:
  std::array<std::array<double*, 3>, 3> powers_{};
  std::array<std::array<Column, 3>, 3> aside_;
};

// The regressor of one term, multiplied in the order that regressor() has.
void write_regressor(Term term, const AxisPowers& powers, std::size_t count, double* column) {
  if (term == Term::Koq) {
    const double* const a = powers.of(0, 1);
    for (std::size_t r = 0; r < count; ++r) column[r] = std::abs(a[r]) * a[r];
    return;
  }
  const double* product = nullptr;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int exponent = info(term).powers[axis];
    if (exponent == 0) continue;
    const double* const factor = powers.of(axis, exponent);
    if (product != nullptr) multiply(product, factor, count, column);
    product = product != nullptr ? column : factor;
  }
  if (product == nullptr) {
    std::fill_n(column, count, 1.0);
  } else if (product != column) {
    std::copy_n(product, count, column);
  }
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
  AxisPowers powers(terms_, block);
  for (const Axis axis : kAxes) {
    const auto k = static_cast<std::size_t>(axis);
    powers.fill(k, data_.along(axis), axis_scales_[k], first, count);
  }
  for (std::size_t c = 0; c < terms_.size(); ++c) write_regressor(terms_[c], powers, count, block.column(c));
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
  for_each_row_chunk(rows.rows(), [&](std::size_t /*chunk*/, std::size_t first, std::size_t last) {
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

std::vector<double> static_residuals(const StaticModel& model, const Dataset& record) {
  std::vector<double> residuals = static_outputs(model, record);
  for (std::size_t row = 0; row < residuals.size(); ++row)
    residuals[row] = record.output[row] - residuals[row];
  return residuals;
}

}  // namespace proofmass
