// SPDX-License-Identifier: Apache-2.0
// Arithmetic in twice the working precision on pairs of doubles, by error-free transformations: Joldes,
// Muller & Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic",
// ACM Trans. Math. Softw. 44, 2017. Relative errors are a few units of 2^-106, without overflow or underflow.
#pragma once

#include <cmath>

namespace proofmass {

// high + low, with |low| at most half a unit in the last place of high.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}  // implicit: a conversion without loss
  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}
  // The nearest double.
  [[nodiscard]] constexpr double value() const noexcept { return high; }
};

// Algorithm 2Sum (Knuth): a + b as a rounded sum and its exact error.
[[nodiscard]] constexpr DoubleDouble exact_sum(double a, double b) noexcept {
  const double sum = a + b;
  const double shadow = sum - a;
  return {sum, (a - (sum - shadow)) + (b - shadow)};
}

// Algorithm Fast2Sum (Dekker): the same for |a| >= |b|.
[[nodiscard]] constexpr DoubleDouble fast_exact_sum(double a, double b) noexcept {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

[[nodiscard]] inline DoubleDouble exact_product(double a, double b) noexcept {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a) noexcept { return {-a.high, -a.low}; }

// Algorithm 6, AccurateDWPlusDW.
[[nodiscard]] constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = exact_sum(a.high, b.high);
  const DoubleDouble low = exact_sum(a.low, b.low);
  const DoubleDouble sum = fast_exact_sum(high.high, high.low + low.high);
  return fast_exact_sum(sum.high, sum.low + low.low);
}

[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return a + (-b);
}

// Algorithm 12, DWTimesDW3.
[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = exact_product(a.high, b.high);
  const double cross = std::fma(a.low, b.high, std::fma(a.high, b.low, a.low * b.low));
  return fast_exact_sum(high.high, high.low + cross);
}

// Algorithm 17, DWDivDW2.
[[nodiscard]] inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const double quotient = a.high / b.high;
  const DoubleDouble rest = a - b * quotient;
  return fast_exact_sum(quotient, rest.high / b.high);
}

// One Newton step from the rounded root. The root of zero is zero.
[[nodiscard]] inline DoubleDouble sqrt(const DoubleDouble& a) noexcept {
  if (a.high == 0.0) return {};
  const double root = std::sqrt(a.high);
  const DoubleDouble rest = a - exact_product(root, root);
  return fast_exact_sum(root, rest.high / (2.0 * root));
}

// Multiplication by a power of two, exact without overflow or underflow.
[[nodiscard]] constexpr DoubleDouble scaled(const DoubleDouble& a, double power_of_two) noexcept {
  return {a.high * power_of_two, a.low * power_of_two};
}

}  // namespace proofmass
