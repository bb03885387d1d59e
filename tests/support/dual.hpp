// SPDX-License-Identifier: Apache-2.0
// Forward-mode derivatives: a value with its gradient in N variables.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace proofmass::test {

template <std::size_t N>
struct Dual {
  double value = 0.0;
  std::array<double, N> gradient{};

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT: constants mix freely with variables

  [[nodiscard]] static Dual variable(double value, std::size_t index) {
    Dual x(value);
    x.gradient.at(index) = 1.0;
    return x;
  }
};

// f(a, b) with its value and its derivatives in a and b.
template <std::size_t N>
[[nodiscard]] Dual<N> chain(double value, double by_a, const Dual<N>& a, double by_b, const Dual<N>& b) {
  Dual<N> result(value);
  for (std::size_t k = 0; k < N; ++k) result.gradient[k] = by_a * a.gradient[k] + by_b * b.gradient[k];
  return result;
}
template <std::size_t N>
[[nodiscard]] Dual<N> chain(double value, double by_a, const Dual<N>& a) {
  Dual<N> result(value);
  for (std::size_t k = 0; k < N; ++k) result.gradient[k] = by_a * a.gradient[k];
  return result;
}

template <std::size_t N>
[[nodiscard]] Dual<N> operator+(const Dual<N>& a, const Dual<N>& b) {
  return chain(a.value + b.value, 1.0, a, 1.0, b);
}
template <std::size_t N>
[[nodiscard]] Dual<N> operator-(const Dual<N>& a, const Dual<N>& b) {
  return chain(a.value - b.value, 1.0, a, -1.0, b);
}
template <std::size_t N>
[[nodiscard]] Dual<N> operator-(const Dual<N>& a) {
  return chain(-a.value, -1.0, a);
}
template <std::size_t N>
[[nodiscard]] Dual<N> operator*(const Dual<N>& a, const Dual<N>& b) {
  return chain(a.value * b.value, b.value, a, a.value, b);
}
template <std::size_t N>
[[nodiscard]] Dual<N> operator/(const Dual<N>& a, const Dual<N>& b) {
  const double quotient = a.value / b.value;
  return chain(quotient, 1.0 / b.value, a, -quotient / b.value, b);
}
template <std::size_t N>
[[nodiscard]] Dual<N> exp(const Dual<N>& a) {
  const double value = std::exp(a.value);
  return chain(value, value, a);
}
template <std::size_t N>
[[nodiscard]] Dual<N> cos(const Dual<N>& a) {
  return chain(std::cos(a.value), -std::sin(a.value), a);
}
template <std::size_t N>
[[nodiscard]] Dual<N> sin(const Dual<N>& a) {
  return chain(std::sin(a.value), std::cos(a.value), a);
}
template <std::size_t N>
[[nodiscard]] Dual<N> atan(const Dual<N>& a) {
  return chain(std::atan(a.value), 1.0 / (1.0 + a.value * a.value), a);
}
// a to the power of b; a > 0 unless b is a constant.
template <std::size_t N>
[[nodiscard]] Dual<N> pow(const Dual<N>& a, const Dual<N>& b) {
  const double value = std::pow(a.value, b.value);
  const double by_b = a.value > 0.0 ? value * std::log(a.value) : 0.0;
  return chain(value, b.value * std::pow(a.value, b.value - 1.0), a, by_b, b);
}

}  // namespace proofmass::test
