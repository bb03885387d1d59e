// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/static_surface.hpp"

#include <cmath>
#include <stdexcept>

namespace proofmass {
namespace {

constexpr std::size_t kSignedSquare = 4;
constexpr std::size_t kFactors = 5;

// 1, x, x², x³ and |x|x of one axis, and their derivatives.
struct Factors {
  Matrix value{SurfaceBlock::kRows, kFactors};
  Matrix slope{SurfaceBlock::kRows, kFactors};

  void compute(std::span<const double> x, std::size_t rows) {
    for (std::size_t r = 0; r < rows; ++r) {
      const double a = x[r];
      value(r, 0) = 1.0;
      value(r, 1) = a;
      value(r, 2) = a * a;
      value(r, 3) = a * a * a;
      value(r, kSignedSquare) = std::abs(a) * a;
      slope(r, 0) = 0.0;
      slope(r, 1) = 1.0;
      slope(r, 2) = 2.0 * a;
      slope(r, 3) = 3.0 * a * a;
      slope(r, kSignedSquare) = 2.0 * std::abs(a);
    }
  }
};

}  // namespace

StaticSurface::StaticSurface(const TermList& terms, const std::vector<Axis>& axes) : axes_(axes) {
  for (const Term term : terms) {
    int order = 0;
    std::vector<std::size_t> factors;
    for (const Axis axis : axes_) {
      const int power = info(term).powers[static_cast<std::size_t>(axis)];
      order += power;
      const bool signed_square = term == Term::Koq && axis == Axis::input;
      factors.push_back(signed_square ? kSignedSquare : static_cast<std::size_t>(power));
    }
    if (order != info(term).order()) throw std::invalid_argument("a term uses an axis that is not there");
    factors_.push_back(std::move(factors));
  }
}

void StaticSurface::evaluate(std::span<const double> coefficients, std::size_t rows,
                             SurfaceBlock& block) const {
  std::vector<Factors> of_axis(axes_.size());
  for (std::size_t k = 0; k < axes_.size(); ++k) of_axis[k].compute(block.x.column(k), rows);
  for (std::size_t r = 0; r < rows; ++r) block.value[r] = 0.0;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    for (std::size_t r = 0; r < rows; ++r) block.by_input(r, k) = 0.0;
  }
  std::vector<double> slope(rows);
  for (std::size_t j = 0; j < factors_.size(); ++j) {
    const auto product = block.by_parameter.column(j);
    for (std::size_t r = 0; r < rows; ++r) product[r] = 1.0;
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      const auto factor = of_axis[k].value.column(factors_[j][k]);
      for (std::size_t r = 0; r < rows; ++r) product[r] *= factor[r];
    }
    for (std::size_t r = 0; r < rows; ++r) block.value[r] += coefficients[j] * product[r];
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      if (factors_[j][k] == 0) continue;
      for (std::size_t r = 0; r < rows; ++r) slope[r] = coefficients[j];
      for (std::size_t l = 0; l < axes_.size(); ++l) {
        const Matrix& table = l == k ? of_axis[l].slope : of_axis[l].value;
        const auto factor = table.column(factors_[j][l]);
        for (std::size_t r = 0; r < rows; ++r) slope[r] *= factor[r];
      }
      for (std::size_t r = 0; r < rows; ++r) block.by_input(r, k) += slope[r];
    }
  }
}

}  // namespace proofmass
