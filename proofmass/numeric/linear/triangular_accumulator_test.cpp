// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/triangular_accumulator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

Matrix random_matrix(std::size_t rows, std::size_t columns, RandomStream& random) {
  Matrix matrix(rows, columns);
  for (std::size_t c = 0; c < columns; ++c) {
    for (double& value : matrix.column(c)) value = random.normal();
  }
  return matrix;
}

double product(const Matrix& a, std::size_t i, std::size_t j) {
  double sum = 0.0;
  for (std::size_t r = 0; r < a.rows(); ++r) sum += a(r, i) * a(r, j);
  return sum;
}

// Adds the matrix in random blocks, each followed by unrelated rows that must be ignored.
Matrix factor_by_blocks(const Matrix& a, RandomStream& random) {
  TriangularAccumulator accumulator(a.columns());
  for (std::size_t first = 0; first < a.rows();) {
    const std::size_t rows = std::min(random.index(12), a.rows() - first);
    Matrix block(rows + random.index(3), a.columns());
    for (std::size_t c = 0; c < a.columns(); ++c) {
      std::fill(block.column(c).begin(), block.column(c).end(), 1e3);
      for (std::size_t r = 0; r < rows; ++r) block(r, c) = a(first + r, c);
    }
    accumulator.add(block, rows);
    first += rows;
  }
  return accumulator.r();
}

RC_GTEST_PROP(TriangularAccumulator, HasTheGramMatrixOfAllRowsWhateverTheBlocks, (std::uint64_t seed)) {
  RandomStream random(seed);
  const Matrix a = random_matrix(random.index(60), 1 + random.index(9), random);
  const Matrix r = factor_by_blocks(a, random);
  const Matrix other = factor_by_blocks(a, random);
  const std::size_t n = a.columns();
  RC_ASSERT(r.rows() == n && r.columns() == n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const double size = std::sqrt(product(a, i, i) * product(a, j, j));
      RC_ASSERT(std::abs(product(r, i, j) - product(a, i, j)) <= 1e-14 * size);
      if (i > j) RC_ASSERT(r(i, j) == 0.0);
      // With enough rows R is unique up to the signs of its rows. The error of the last rows grows with the
      // condition.
      if (a.rows() >= 4 * n) RC_ASSERT(std::abs(std::abs(r(i, j)) - std::abs(other(i, j))) <= 1e-12 * size);
    }
  }
}

TEST(TriangularAccumulator, RowsBeyondTheRankAreZero) {
  // Leading columns are far from dependent; otherwise rounding in the last row would be magnified.
  RandomStream random(1);
  Matrix a = random_matrix(2, 4, random);
  a(0, 0) = a(1, 1) = 10.0;
  TriangularAccumulator accumulator(4);
  for (int repeat = 0; repeat < 3; ++repeat) accumulator.add(a, 2);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_NEAR(product(accumulator.r(), c, c), 3.0 * product(a, c, c), 1e-13 * product(a, c, c));
    for (std::size_t r = 2; r < 4; ++r) EXPECT_NEAR(accumulator.r()(r, c), 0.0, 1e-14);
  }
}

}  // namespace
}  // namespace proofmass
