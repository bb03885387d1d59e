// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/selection/polynomial_jet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// Polynomials of unlimited degree; the fourth power belongs to the marked variable.
using Polynomial = std::map<std::array<int, 4>, double>;

Polynomial polynomial_of(const PolynomialJet& jet) {
  Polynomial result;
  for (std::size_t k = 0; k < kJetMonomials; ++k) {
    const auto& powers = jet_monomials()[k];
    result[{powers[0], powers[1], powers[2], 0}] = jet.coefficients[k];
  }
  result[{0, 0, 0, 1}] = jet.marked;
  return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [p, x] : a) {
    for (const auto& [q, y] : b) result[{p[0] + q[0], p[1] + q[1], p[2] + q[2], p[3] + q[3]}] += x * y;
  }
  return result;
}

// Small whole numbers, so that sums are exact in any order.
PolynomialJet whole_numbers(RandomStream& random) {
  PolynomialJet jet;
  for (double& c : jet.coefficients) c = static_cast<double>(random.index(9)) - 4.0;
  jet.marked = static_cast<double>(random.index(9)) - 4.0;
  return jet;
}

TEST(PolynomialJet, ChainOfProductsAgreesWithPolynomialsOfAnyDegree) {
  RandomStream random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const PolynomialJet a = whole_numbers(random);
    const PolynomialJet b = whole_numbers(random);
    const PolynomialJet c = whole_numbers(random);
    PolynomialJet jet = a * b * c;
    jet.add(3.0, a * a);
    Polynomial full = product(product(polynomial_of(a), polynomial_of(b)), polynomial_of(c));
    for (const auto& [powers, value] : product(polynomial_of(a), polynomial_of(a)))
      full[powers] += 3.0 * value;
    for (const auto& powers : jet_monomials()) {
      EXPECT_EQ(jet.coefficient(powers), (full[{powers[0], powers[1], powers[2], 0}]));
    }
    EXPECT_EQ(jet.marked, (full[{0, 0, 0, 1}]));
  }
}

TEST(PolynomialJet, VariablesAreTheirMonomials) {
  const PolynomialJet xyz =
      PolynomialJet::variable(0) * PolynomialJet::variable(1) * PolynomialJet::variable(2);
  EXPECT_EQ(xyz.coefficient({1, 1, 1}), 1.0);
  EXPECT_EQ(std::count(xyz.coefficients.begin(), xyz.coefficients.end(), 0.0), 19);
  EXPECT_EQ((xyz * PolynomialJet::variable(0)).coefficients, PolynomialJet{}.coefficients);
  EXPECT_THROW((void)xyz.coefficient({2, 1, 1}), std::invalid_argument);
  EXPECT_THROW((void)xyz.coefficient({-1, 1, 1}), std::invalid_argument);
}

TEST(PolynomialJet, MarkedVariableToFirstOrder) {
  PolynomialJet a = PolynomialJet::constant(2.0);
  a.add(1.0, PolynomialJet::marked_variable());
  a.add(1.0, PolynomialJet::variable(0));
  EXPECT_EQ((a * a).marked, 4.0);
  EXPECT_EQ((a * a).coefficient({1, 0, 0}), 4.0);
}

}  // namespace
}  // namespace proofmass
