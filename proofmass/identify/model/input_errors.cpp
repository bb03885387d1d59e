// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/input_errors.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "proofmass/numeric/linear/rank_analysis.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kMostRows = 4096;
// Steps below this fraction of the axis are those of programs that write all digits they have.
constexpr double kFineStep = 5e-14;

// d regressor / d input, along each axis.
std::array<double, 3> gradient(Term term, const Acceleration& a) {
  if (term == Term::Koq) return {2.0 * std::abs(a.i), 0.0, 0.0};
  const std::array<double, 3> values{a.i, a.o, a.p};
  const auto& powers = info(term).powers;
  std::array<double, 3> slopes{};
  for (std::size_t axis = 0; axis < slopes.size(); ++axis) {
    if (powers[axis] == 0) continue;
    double slope = powers[axis];
    for (std::size_t k = 0; k < values.size(); ++k)
      slope *= std::pow(values[k], powers[k] - (k == axis ? 1 : 0));
    slopes[axis] = slope;
  }
  return slopes;
}

// By how much a combination must exceed the sum of squares that uncertainties make of it, which varies with
// few rows as chi² does.
double uncertainty_margin(std::size_t rows) {
  constexpr double kLeast = 2.0;
  constexpr double kDeviations = 5.0;
  return std::max(kLeast, 1.0 + kDeviations * std::sqrt(2.0 / static_cast<double>(rows)));
}

// Of the errors of each axis; zero where they are not known or are too fine to matter.
struct ErrorVariances {
  std::array<double, 3> rounding{};
  std::array<double, 3> uncertainty{};
  [[nodiscard]] bool any() const {
    const auto positive = [](double variance) { return variance > 0.0; };
    return std::any_of(rounding.begin(), rounding.end(), positive) ||
           std::any_of(uncertainty.begin(), uncertainty.end(), positive);
  }
};

ErrorVariances error_variances(const Dataset& data, const std::array<double, 3>& uncertainties) {
  ErrorVariances variances;
  const double counted = uncertainty_margin(std::max<std::size_t>(1, data.rows())) / kErrorMargin;
  for (const Axis axis : data.axes()) {
    const auto k = static_cast<std::size_t>(axis);
    double largest = 0.0;
    for (const double value : data.along(axis)) largest = std::max(largest, std::abs(value));
    const double step = data.acceleration_resolution[k];
    if (step > kFineStep * largest) variances.rounding[k] = step * step / 12.0;
    if (uncertainties[k] > kFineStep * largest)
      variances.uncertainty[k] = counted * uncertainties[k] * uncertainties[k];
  }
  return variances;
}

}  // namespace

std::array<double, 3> input_uncertainties(const Dataset& data, std::optional<double> constant) {
  std::array<double, 3> uncertainties{};
  for (const Axis axis : data.axes()) {
    const auto k = static_cast<std::size_t>(axis);
    double squares = 0.0;
    for (const double sigma : data.acceleration_sigma[k]) squares += sigma * sigma;
    uncertainties[k] =
        constant.value_or(std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, data.rows()))));
  }
  return uncertainties;
}

std::optional<Matrix> input_error_products(const Dataset& data, const TermList& terms,
                                           const std::array<double, 3>& uncertainties) {
  const ErrorVariances variances = error_variances(data, uncertainties);
  if (!variances.any()) return std::nullopt;
  const std::size_t n = data.rows();
  const std::size_t used = std::min(n, kMostRows);
  const double weight = static_cast<double>(n) / static_cast<double>(std::max<std::size_t>(used, 1));
  Matrix products(terms.size(), terms.size());
  std::vector<std::array<double, 3>> slopes(terms.size());
  for (std::size_t k = 0; k < used; ++k) {
    const Acceleration a = data.at(k * n / used);
    for (std::size_t t = 0; t < terms.size(); ++t) slopes[t] = gradient(terms[t], a);
    for (std::size_t c = 0; c < terms.size(); ++c) {
      for (std::size_t r = 0; r <= c; ++r) {
        const bool of_powers = info(terms[r]).order() > 1 && info(terms[c]).order() > 1;
        double sum = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double variance = variances.rounding[axis] + (of_powers ? variances.uncertainty[axis] : 0.0);
          sum += variance * slopes[r][axis] * slopes[c][axis];
        }
        products(r, c) += weight * sum;
      }
    }
  }
  for (std::size_t c = 0; c < terms.size(); ++c) {
    for (std::size_t r = 0; r < c; ++r) products(c, r) = products(r, c);
  }
  return products;
}

}  // namespace proofmass
