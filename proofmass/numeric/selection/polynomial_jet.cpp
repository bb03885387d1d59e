// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/selection/polynomial_jet.hpp"

#include <stdexcept>

namespace proofmass {
namespace {

constexpr int kDegree = static_cast<int>(kJetDegree);
constexpr std::size_t kDropped = kJetMonomials;

constexpr auto kMonomials = [] {
  std::array<std::array<int, 3>, kJetMonomials> monomials{};
  std::size_t next = 0;
  for (int degree = 0; degree <= kDegree; ++degree) {
    for (int x = degree; x >= 0; --x) {
      for (int y = degree - x; y >= 0; --y) monomials[next++] = {x, y, degree - x - y};
    }
  }
  return monomials;
}();

constexpr std::size_t index_of(const std::array<int, 3>& powers) {
  for (std::size_t k = 0; k < kJetMonomials; ++k) {
    if (kMonomials[k] == powers) return k;
  }
  return kDropped;
}

// Index of the product of two monomials.
constexpr auto kProducts = [] {
  std::array<std::array<std::size_t, kJetMonomials>, kJetMonomials> products{};
  for (std::size_t a = 0; a < kJetMonomials; ++a) {
    for (std::size_t b = 0; b < kJetMonomials; ++b) {
      products[a][b] = index_of({kMonomials[a][0] + kMonomials[b][0], kMonomials[a][1] + kMonomials[b][1],
                                 kMonomials[a][2] + kMonomials[b][2]});
    }
  }
  return products;
}();

static_assert(kMonomials[0] == std::array<int, 3>{0, 0, 0} && kMonomials[3] == std::array{0, 0, 1});

}  // namespace

PolynomialJet PolynomialJet::constant(double value) noexcept {
  PolynomialJet jet;
  jet.coefficients[0] = value;
  return jet;
}

PolynomialJet PolynomialJet::variable(std::size_t k) noexcept {
  PolynomialJet jet;
  jet.coefficients[1 + k] = 1.0;
  return jet;
}

PolynomialJet PolynomialJet::marked_variable() noexcept {
  PolynomialJet jet;
  jet.marked = 1.0;
  return jet;
}

double PolynomialJet::coefficient(const std::array<int, 3>& powers) const {
  const std::size_t k = index_of(powers);
  if (k == kDropped) throw std::invalid_argument("a jet has no monomial with these powers");
  return coefficients[k];
}

void PolynomialJet::add(double factor, const PolynomialJet& other) noexcept {
  for (std::size_t k = 0; k < kJetMonomials; ++k) coefficients[k] += factor * other.coefficients[k];
  marked += factor * other.marked;
}

PolynomialJet operator*(const PolynomialJet& a, const PolynomialJet& b) noexcept {
  PolynomialJet product;
  for (std::size_t i = 0; i < kJetMonomials; ++i) {
    for (std::size_t j = 0; j < kJetMonomials; ++j) {
      const std::size_t k = kProducts[i][j];
      if (k != kDropped) product.coefficients[k] += a.coefficients[i] * b.coefficients[j];
    }
  }
  product.marked = a.marked * b.coefficients[0] + a.coefficients[0] * b.marked;
  return product;
}

std::span<const std::array<int, 3>, kJetMonomials> jet_monomials() noexcept { return kMonomials; }

}  // namespace proofmass
