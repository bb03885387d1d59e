// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/cholesky_kernel.hpp"

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

TEST_P(CholeskyKernel, FactorGivesBackTheMatrix) {
  RandomStream random(1);
  for (std::size_t n = 1; n <= 60; ++n) {
    PaddedSquare matrix = random_gram(n, random);
    PaddedSquare factor = matrix;
    ASSERT_TRUE(cholesky_in_place(factor)) << n;
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t r = c; r < n; ++r) {
        long double product = 0;
        for (std::size_t k = 0; k <= c; ++k) {
          product += static_cast<long double>(factor.column(k)[r]) * factor.column(k)[c];
        }
        const double size = std::sqrt(matrix.column(r)[r] * matrix.column(c)[c]);
        ASSERT_NEAR(static_cast<double>(product), matrix.column(c)[r], 1e-14 * size) << n;
      }
    }
  }
}

TEST_P(CholeskyKernel, RefusesWhatIsNotPositiveDefinite) {
  RandomStream random(2);
  for (std::size_t n = 1; n <= 20; ++n) {
    for (std::size_t spoilt = 0; spoilt < n; ++spoilt) {
      for (const double value :
           {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        PaddedSquare matrix = random_gram(n, random);
        matrix.column(spoilt)[spoilt] = value;
        EXPECT_FALSE(cholesky_in_place(matrix)) << n << ", " << spoilt << ", " << value;
      }
    }
  }
}

TEST_P(CholeskyKernel, RefusesWhatPivotsAloneDoNotShow) {
  RandomStream random(3);
  PaddedSquare reused(13);
  for (std::size_t column = 0; column < 12; ++column) {
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), 1e9}) {
      PaddedSquare matrix = random_gram(13, random);
      matrix.column(column)[12] = value;  // more than the diagonal's elements allow
      EXPECT_FALSE(cholesky_in_place(matrix)) << column << ", " << value;
      // What is left of a failure does not spoil the next matrix in its place.
      const PaddedSquare sound = random_gram(13, random);
      PaddedSquare fresh = sound;
      reused = matrix;
      for (std::size_t c = 0; c < 13; ++c) std::copy_n(&sound.values[c * sound.stride], 13, reused.column(c));
      ASSERT_TRUE(cholesky_in_place(reused));
      ASSERT_TRUE(cholesky_in_place(fresh));
      for (std::size_t c = 0; c < 13; ++c) {
        for (std::size_t r = c; r < 13; ++r) EXPECT_EQ(reused.column(c)[r], fresh.column(c)[r]);
      }
    }
  }
}

}  // namespace
}  // namespace proofmass
