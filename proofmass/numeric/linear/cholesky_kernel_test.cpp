// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/cholesky_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "proofmass/numeric/random.hpp"
#include "support/instruction_sets.hpp"

namespace proofmass {
namespace {

class CholeskyKernel : public test::OnInstructionSet {};
INSTANTIATE_TEST_SUITE_P(InstructionSets, CholeskyKernel, testing::ValuesIn(test::instruction_sets()),
                         test::instruction_set_name);

CholeskyFactors factors_of(const PaddedSquare& matrix) {
  CholeskyFactors factors(matrix.n);
  factors.matrix() = matrix;
  return factors;
}

// Products of the columns of a random matrix with more rows than columns.
PaddedSquare random_gram(std::size_t n, RandomStream& random) {
  std::vector<std::vector<double>> columns(n, std::vector<double>(n + 2));
  for (auto& column : columns) {
    for (double& value : column) value = random.normal();
  }
  PaddedSquare matrix(n);
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t k = 0; k < n + 2; ++k) matrix.column(c)[r] += columns[r][k] * columns[c][k];
    }
  }
  return matrix;
}

TEST_P(CholeskyKernel, FactorsGiveBackTheMatrix) {
  RandomStream random(1);
  for (std::size_t n = 1; n <= 60; ++n) {
    const PaddedSquare matrix = random_gram(n, random);
    CholeskyFactors factors = factors_of(matrix);
    ASSERT_TRUE(factors.factor()) << n;
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t r = c; r < n; ++r) {
        long double product = 0;
        for (std::size_t k = 0; k <= c; ++k) {
          const double* const column = factors.scaled_columns().column(k);
          product += static_cast<long double>(column[r]) * column[c] * factors.inverse_pivots()[k];
        }
        const double size = std::sqrt(matrix.column(r)[r] * matrix.column(c)[c]);
        ASSERT_NEAR(static_cast<double>(product), matrix.column(c)[r], 1e-14 * size) << n;
      }
    }
  }
}

TEST_P(CholeskyKernel, SolutionsSolveTheEquations) {
  RandomStream random(4);
  for (std::size_t n = 1; n <= 60; ++n) {
    const PaddedSquare matrix = random_gram(n, random);
    CholeskyFactors factors = factors_of(matrix);
    ASSERT_TRUE(factors.factor()) << n;
    for (int repeat = 0; repeat < 2; ++repeat) {
      std::vector<double> b(n), x(n);
      for (double& value : b) value = random.normal();
      factors.solve(b, x);
      for (std::size_t r = 0; r < n; ++r) {
        long double rest = b[r];
        double size = std::abs(b[r]);
        for (std::size_t c = 0; c < n; ++c) {
          rest += static_cast<long double>(matrix.column(c)[r]) * x[c];
          size += std::abs(matrix.column(c)[r] * x[c]);
        }
        ASSERT_LE(std::abs(static_cast<double>(rest)), 1e-14 * size) << n << ", row " << r;
      }
    }
  }
}

TEST_P(CholeskyKernel, RefusesWhatIsNotPositiveDefinite) {
  RandomStream random(2);
  for (std::size_t n = 1; n <= 20; ++n) {
    for (std::size_t spoilt = 0; spoilt < n; ++spoilt) {
      for (const double value : {-1.0, 0.0, 5e-324, std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()}) {
        CholeskyFactors factors = factors_of(random_gram(n, random));
        factors.matrix().column(spoilt)[spoilt] = value;
        EXPECT_FALSE(factors.factor()) << n << ", " << spoilt << ", " << value;
      }
    }
  }
}

TEST_P(CholeskyKernel, RefusesWhatPivotsAloneDoNotShow) {
  RandomStream random(3);
  constexpr std::size_t n = 13;
  CholeskyFactors reused(n);
  for (std::size_t column = 0; column + 1 < n; ++column) {
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), 1e9}) {
      PaddedSquare matrix = random_gram(n, random);
      matrix.column(column)[n - 1] = value;  // too large for a positive definite matrix
      reused.matrix() = matrix;
      EXPECT_FALSE(reused.factor()) << column << ", " << value;
      // A failure must not affect the next matrix in the same memory.
      const PaddedSquare sound = random_gram(n, random);
      for (std::size_t c = 0; c < n; ++c) {
        std::copy_n(sound.column(c) + c, n - c, reused.matrix().column(c) + c);
      }
      CholeskyFactors fresh = factors_of(sound);
      ASSERT_TRUE(reused.factor());
      ASSERT_TRUE(fresh.factor());
      const std::vector<double> b(n, 1.0);
      std::vector<double> x(n), y(n);
      reused.solve(b, x);
      fresh.solve(b, y);
      EXPECT_EQ(x, y);
    }
  }
}

}  // namespace
}  // namespace proofmass
