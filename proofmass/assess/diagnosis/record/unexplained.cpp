// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/unexplained.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "proofmass/assess/diagnosis/record/term_space.hpp"

namespace proofmass {
namespace {

double squares_about_mean(std::span<const double> values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [mean](double sum, double v) { return sum + (v - mean) * (v - mean); });
}

}  // namespace

double unexplained_by(const Matrix& basis, std::span<const double> output) {
  const auto n = static_cast<double>(output.size());
  const double dof = n - static_cast<double>(basis.columns());
  if (dof < 1.0) return 1.0;
  const double total = squares_about_mean(output);
  if (!(total > 0.0)) return 1.0;
  const double rss = sum_of_squares(beyond_columns(basis, {output.begin(), output.end()}));
  return rss / dof * (n - 1.0) / total;
}

double unexplained_by_linear_terms(const Dataset& rows) {
  return unexplained_by(orthonormal_rows(rows, linear_terms()), rows.output);
}

double unexplained_without_far_rows(const Dataset& rows) {
  std::vector<double> sizes = beyond_columns(orthonormal_rows(rows, linear_terms()), rows.output);
  for (double& size : sizes) size = std::abs(size);
  std::vector<double> ordered(sizes);
  const auto limit = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() * 9 / 10);
  std::nth_element(ordered.begin(), limit, ordered.end());
  std::vector<std::size_t> near;
  for (std::size_t row = 0; row < sizes.size(); ++row) {
    if (sizes[row] <= *limit) near.push_back(row);
  }
  return unexplained_by_linear_terms(rows.select(near));
}

}  // namespace proofmass
