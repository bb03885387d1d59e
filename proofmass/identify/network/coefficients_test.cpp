// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/coefficients.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

// A network whose scaled inputs are A / 10 and whose output is not scaled at all.
TrainedNetwork plain_network(std::size_t hidden) {
  TrainedNetwork network;
  network.inputs = {kAxes.begin(), kAxes.end()};
  network.hidden = hidden;
  network.input_range.assign(3, {-10.0, 10.0});
  network.output_range = {-1.0, 1.0};
  network.weights.assign(hidden * 5 + 1, 0.0);
  return network;
}

// 0.3 + 2 x² within 1e-5 by a second difference of tanh, x = (Ai - 2 Ap) / 10.
TrainedNetwork nearly_quadratic() {
  constexpr double kStep = 1e-3;
  constexpr double kBias = 0.5;
  const double t = std::tanh(kBias);
  const double scale = 2.0 / (-2.0 * t * (1.0 - t * t) * kStep * kStep);
  TrainedNetwork network = plain_network(3);
  network.weights = {kStep, 0,     -2 * kStep, -kStep, 0,     2 * kStep, 0,          0,
                     0,     kBias, kBias,      kBias,  scale, scale,     -2 * scale, 0.3};
  return network;
}

TEST(Projection, ReturnsTheCoefficientsOfANearlyPolynomialNetwork) {
  Dataset record = test::make_twin({.rows = 400, .greatest = 10.0});
  const TrainedNetwork network = nearly_quadratic();
  record.output = network_outputs(network, record);
  const TermList terms = parse_terms("quadratic");
  const ProjectedCoefficients projected = project_onto_terms(network, record, terms);
  const StaticModel found{.terms = terms, .coefficients = projected.fit.coefficients};
  for (const Term term : terms) {
    const double expected = term == Term::K0    ? 0.3
                            : term == Term::Kii ? 0.02
                            : term == Term::Kip ? -0.08
                            : term == Term::Kpp ? 0.08
                                                : 0.0;
    EXPECT_NEAR(found.coefficient(term), expected, 1e-5) << name(term);
  }
  EXPECT_EQ(projected.rss, 0.0);
  EXPECT_EQ(projected.induced_deviation, 0.0);
}

TEST(Projection, IsLeastSquaresLessThatOfTheResidual) {
  const Dataset record = test::make_twin({.rows = 700});
  const TrainedNetwork network = test::random_network(record, 7);
  const TermList terms = parse_terms("full");
  const ProjectedCoefficients projected = project_onto_terms(network, record, terms);
  const Matrix design = design_matrix(record, terms);
  const LeastSquaresFit direct = solve_least_squares(design, record.output);

  double square = 0.0;
  double rss = 0.0;
  const std::vector<double> outputs = network_outputs(network, record);
  for (std::size_t row = 0; row < record.rows(); ++row) {
    double effect = 0.0;
    for (std::size_t k = 0; k < terms.size(); ++k) effect += design(row, k) * projected.deviation[k];
    square += effect * effect;
    rss += std::pow(record.output[row] - outputs[row], 2);
  }
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const double size = std::abs(direct.coefficients[k]) + std::abs(projected.deviation[k]);
    EXPECT_NEAR(projected.fit.coefficients[k], direct.coefficients[k] - projected.deviation[k], 1e-10 * size)
        << name(terms[k]);
  }
  const double rms = std::sqrt(square / static_cast<double>(record.rows()));
  EXPECT_NEAR(projected.induced_deviation, rms, 1e-10 * rms);
  EXPECT_NEAR(projected.rss, rss, 1e-12 * rss);
}

// s² (XᵀX)⁻¹ + d dᵀ of least squares with the same terms, d its difference from the projection.
TEST(Projection, CovarianceIsThatOfLeastSquaresAndTheDifference) {
  const Dataset record = test::make_twin({.rows = 120, .noise = 0.1});
  const TrainedNetwork network = test::random_network(record, 2);
  const TermList terms = parse_terms("quadratic");
  const ProjectedCoefficients projected = project_onto_terms(network, record, terms);
  const LeastSquaresFit direct = solve_least_squares(design_matrix(record, terms), record.output);
  const double variance = direct.rss / (120.0 - static_cast<double>(terms.size()));
  const auto difference = [&](std::size_t k) {
    return projected.fit.coefficients[k] - direct.coefficients[k];
  };
  for (std::size_t r = 0; r < terms.size(); ++r) {
    for (std::size_t c = 0; c < terms.size(); ++c) {
      const double expected = variance * direct.unscaled_covariance(r, c) + difference(r) * difference(c);
      const double size = std::sqrt(projected.fit.covariance(r, r) * projected.fit.covariance(c, c));
      EXPECT_NEAR(projected.fit.covariance(r, c), expected, 1e-9 * size);
    }
  }
}

TEST(Projection, HasNoCovarianceWithoutMoreRowsThanTerms) {
  const Dataset record = test::make_twin({.rows = 4});
  const TrainedNetwork network = test::random_network(record, 1);
  EXPECT_EQ(project_onto_terms(network, record, parse_terms("linear")).fit.covariance.rows(), 0U);
}

TEST(Expansion, OfOneUnitIsThatOfTanh) {
  TrainedNetwork network = plain_network(1);
  const double w = 0.4;
  const double u = -0.7;
  const double q = 0.3;
  const double b = 0.6;
  const double v = 1.7;
  const double c = 0.25;
  network.weights = {10.0 * w, 10.0 * u, 10.0 * q, b, v, c};  // inputs A / 10
  const TermList terms = parse_terms("full");
  const StaticModel found{.terms = terms, .coefficients = expand_at_zero(network, terms)};
  const double t = std::tanh(b);
  const double first = v * (1.0 - t * t);
  const double second = -v * t * (1.0 - t * t);                        // half of tanh''
  const double third = v * (1.0 - t * t) * (3.0 * t * t - 1.0) / 3.0;  // a sixth of tanh'''
  const std::array<std::pair<Term, double>, 21> known{{{Term::K0, c + v * t},
                                                       {Term::Ki, first * w},
                                                       {Term::Ko, first * u},
                                                       {Term::Kp, first * q},
                                                       {Term::Kii, second * w * w},
                                                       {Term::Koo, second * u * u},
                                                       {Term::Kpp, second * q * q},
                                                       {Term::Kio, second * 2 * w * u},
                                                       {Term::Kip, second * 2 * w * q},
                                                       {Term::Kop, second * 2 * u * q},
                                                       {Term::Koq, 0.0},
                                                       {Term::Kiii, third * w * w * w},
                                                       {Term::Kooo, third * u * u * u},
                                                       {Term::Kppp, third * q * q * q},
                                                       {Term::Kioo, third * 3 * w * u * u},
                                                       {Term::Kipp, third * 3 * w * q * q},
                                                       {Term::Kopp, third * 3 * u * q * q},
                                                       {Term::Koii, third * 3 * u * w * w},
                                                       {Term::Kpoo, third * 3 * q * u * u},
                                                       {Term::Kpii, third * 3 * q * w * w},
                                                       {Term::Kiop, third * 6 * w * u * q}}};
  for (const auto& [term, expected] : known) {
    EXPECT_NEAR(found.coefficient(term), expected, 1e-14) << name(term);
  }
}

// Along a line through zero the expansion's terms of each order make the derivatives of that order; enough
// directions leave no coefficient free.
TEST(Expansion, AgreesWithFiniteDifferencesAtZero) {
  Dataset record = test::make_twin({.rows = 100});
  for (double& value : record.acceleration[1]) value += 3.0;  // ranges that are not symmetric
  const TrainedNetwork network = test::random_network(record, 7, 5);
  const TermList terms = parse_terms("full");
  const std::vector<double> found = expand_at_zero(network, terms);
  RandomStream random(11);
  for (int direction = 0; direction < 30; ++direction) {
    const Acceleration d{random.normal(), random.normal(), random.normal()};
    constexpr long double kStep = 0.2L;
    std::array<long double, 9> f{};
    for (int k = -4; k <= 4; ++k) {
      const auto s = static_cast<double>(kStep * k);
      f[static_cast<std::size_t>(k + 4)] = test::network_output(network, {s * d.i, s * d.o, s * d.p});
    }
    const auto odd = [&](std::size_t k) { return f[4 + k] - f[4 - k]; };
    const auto even = [&](std::size_t k) { return f[4 + k] + f[4 - k]; };
    const std::array<long double, 4> derivatives{
        f[4], (odd(1) * 4 / 5 - odd(2) / 5 + odd(3) * 4 / 105 - odd(4) / 280) / kStep,
        (-f[4] * 205 / 72 + even(1) * 8 / 5 - even(2) / 5 + even(3) * 8 / 315 - even(4) / 560) /
            (kStep * kStep),
        (-odd(1) * 61 / 30 + odd(2) * 169 / 120 - odd(3) * 3 / 10 + odd(4) * 7 / 240) /
            (kStep * kStep * kStep)};
    std::array<double, 4> sums{};
    for (std::size_t k = 0; k < terms.size(); ++k) {
      sums[static_cast<std::size_t>(info(terms[k]).order())] += found[k] * regressor(terms[k], d);
    }
    constexpr std::array<double, 4> kFactorial{1, 1, 2, 6};
    for (std::size_t order = 0; order < 4; ++order) {
      EXPECT_NEAR(sums[order] * kFactorial[order], static_cast<double>(derivatives[order]), 1e-6)
          << "order " << order << ", direction " << direction;
    }
  }
}

TEST(Expansion, OfANetworkOfOneAxisHasNoOtherTerms) {
  Dataset record = test::make_twin({.rows = 60});
  record.acceleration[0].clear();
  record.acceleration[2].assign(60, 1.5);  // an input that does not vary counts for nothing
  const TrainedNetwork network = test::random_network(record, 3);
  const TermList terms = parse_terms("full");
  const StaticModel found{.terms = terms, .coefficients = expand_at_zero(network, terms)};
  EXPECT_NEAR(found.coefficient(Term::K0), static_cast<double>(test::network_output(network, {})), 1e-12);
  for (const Term term : terms) {
    const bool only_output_axis = !info(term).uses(Axis::input) && !info(term).uses(Axis::pendulous);
    EXPECT_EQ(found.coefficient(term) != 0.0, only_output_axis) << name(term);
  }
}

}  // namespace
}  // namespace proofmass
