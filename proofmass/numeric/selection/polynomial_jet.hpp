// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace proofmass {

inline constexpr std::size_t kJetDegree = 3;
inline constexpr std::size_t kJetMonomials = 20;  // of three variables, total degree at most kJetDegree

// A polynomial in three variables, cut off above total degree three and to first order in a fourth, marked
// variable. The marked variable stands for a function that is no polynomial, such as x|x|. Sums and products
// of jets are exact for every coefficient kept, because degrees only add: a product drops only degree four
// and more, and the marked variable times anything but a constant.
struct PolynomialJet {
  std::array<double, kJetMonomials> coefficients{};  // in the order of jet_monomials()
  double marked = 0.0;                               // coefficient of the marked variable

  [[nodiscard]] static PolynomialJet constant(double value) noexcept;
  [[nodiscard]] static PolynomialJet variable(std::size_t k) noexcept;  // the k-th of three
  [[nodiscard]] static PolynomialJet marked_variable() noexcept;

  // The coefficient of x^powers[0] y^powers[1] z^powers[2]. Throws std::invalid_argument when its degree is
  // above three.
  [[nodiscard]] double coefficient(const std::array<int, 3>& powers) const;
  // Adds factor * other.
  void add(double factor, const PolynomialJet& other) noexcept;
};

[[nodiscard]] PolynomialJet operator*(const PolynomialJet& a, const PolynomialJet& b) noexcept;

// The powers of each monomial, by ascending degree; the first is the constant.
[[nodiscard]] std::span<const std::array<int, 3>, kJetMonomials> jet_monomials() noexcept;

}  // namespace proofmass
