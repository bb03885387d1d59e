// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/gram_matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "proofmass/numeric/linear/gram_kernels.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/random.hpp"
#include "support/instruction_sets.hpp"

namespace proofmass {
namespace {

struct Data {
  Matrix design;
  std::vector<double> y;
};

Data random_data(std::size_t rows, std::size_t columns, RandomStream& random) {
  Data data{.design = Matrix(rows, columns), .y = std::vector<double>(rows)};
  for (std::size_t c = 0; c < columns; ++c) {
    for (double& value : data.design.column(c)) value = c == 0 ? 1.0 : random.normal();
  }
  for (double& value : data.y) value = random.normal();
  return data;
}

// The product sum of the scaled columns i and j, added one by one in twice the working precision.
DoubleDouble plain_product(const Data& data, std::span<const double> scales, std::size_t i, std::size_t j) {
  const auto element = [&](std::size_t r, std::size_t c) {
    return c < data.design.columns() ? data.design(r, c) * scales[c] : data.y[r];
  };
  DoubleDouble sum;
  for (std::size_t r = 0; r < data.y.size(); ++r) sum = sum + exact_product(element(r, i), element(r, j));
  return sum;
}

// The largest error of a sum of products over the lengths of its columns.
double worst_error(const Data& data, const GramMatrix& gram) {
  double worst = 0.0;
  for (std::size_t j = 0; j <= gram.regressors(); ++j) {
    for (std::size_t i = 0; i <= j; ++i) {
      const DoubleDouble error = gram(i, j) - plain_product(data, gram.scales(), i, j);
      const double lengths = std::sqrt(gram(i, i).value() * gram(j, j).value());
      if (lengths > 0.0) worst = std::max(worst, std::abs(error.value()) / lengths);
    }
  }
  return worst;
}

class GramKernels : public test::OnInstructionSet {};

TEST_P(GramKernels, SumProductsInTwiceTheWorkingPrecision) {
  RandomStream random(3);
  // Numbers of rows near those of vectors, lane sums, blocks and portions; numbers of columns near those of
  // tiles.
  for (const std::size_t rows : {1U, 7U, 8U, 9U, 127U, 129U, 255U, 257U, 1000U, 8193U, 20000U}) {
    for (const std::size_t columns : {1U, 2U, 5U, 21U}) {
      const Data data = random_data(rows, columns, random);
      const GramMatrix gram = gram_matrix(MatrixRows(data.design, data.y));
      EXPECT_EQ(gram.rows(), rows);
      EXPECT_LT(worst_error(data, gram), 5e-29) << rows << " x " << columns;
    }
  }
}

TEST_P(GramKernels, CancellingAndUnequalRowsKeepTheirDigits) {
  RandomStream random(4);
  Data data = random_data(1000, 4, random);
  for (std::size_t r = 0; r < 1000; ++r) {
    data.design(r, 1) = std::ldexp(random.normal(), static_cast<int>(random.uniform(-60.0, 60.0)));
    data.design(r, 2) = r % 2 == 0 ? data.design(r, 1) : -data.design(r - 1, 1);
    data.design(r, 3) = r == 517 ? 1e10 : 1e-5 * random.normal();
    data.y[r] = std::ldexp(random.normal(), -300);
  }
  EXPECT_LT(worst_error(data, gram_matrix(MatrixRows(data.design, data.y))), 1e-28);
}

TEST_P(GramKernels, PlainAndWeightedSumsOfOnePassAreThoseOfTwo) {
  RandomStream random(8);
  for (const std::size_t rows : {1U, 7U, 255U, 257U, 20000U}) {
    const Data data = random_data(rows, 5, random);
    std::vector<double> weights(rows);
    for (std::size_t r = 0; r < rows; ++r) weights[r] = r % 5 == 3 ? 0.0 : random.uniform(0.1, 4.0);
    const MatrixRows plain(data.design, data.y);
    const GramMatrices sums = gram_matrices(plain, weights);
    const GramMatrix expected = gram_matrix(plain);
    const GramMatrix weighted = gram_matrix(WeightedRows(plain, weights));
    EXPECT_EQ(sums.weighted.rows(), rows);
    for (std::size_t j = 0; j <= 5; ++j) {
      EXPECT_EQ(sums.weighted.least(j), weighted.least(j));
      for (std::size_t i = 0; i <= j; ++i) {
        EXPECT_EQ(sums.plain(i, j).value(), expected(i, j).value());
        EXPECT_EQ(sums.weighted(i, j).value(), weighted(i, j).value());
      }
    }
    weights.pop_back();
    EXPECT_THROW((void)gram_matrices(plain, weights), std::invalid_argument);
    weights.push_back(-1.0);
    EXPECT_THROW((void)gram_matrices(plain, weights), std::invalid_argument);
  }
}

TEST_P(GramKernels, DenormalAndZeroColumnsAreSummed) {
  Data data{.design = Matrix(300, 2),
            .y = std::vector<double>(300, std::numeric_limits<double>::denorm_min())};
  for (double& value : data.design.column(0)) value = 3.0;
  const GramMatrix gram = gram_matrix(MatrixRows(data.design, data.y));
  EXPECT_EQ(gram(1, 1).value(), 0.0);
  EXPECT_EQ(gram(0, 1).value(), 0.0);
  EXPECT_EQ(gram(0, 0).value(), 300.0 * 9.0 * gram.scales()[0] * gram.scales()[0]);
  EXPECT_LE(gram(0, 2).value(), 900.0 * std::numeric_limits<double>::denorm_min());
}

TEST_P(GramKernels, ResidualsAreRoundedOnce) {
  RandomStream random(5);
  const Data data = random_data(333, 5, random);
  const MatrixRows rows(data.design, data.y);
  const std::vector<double> coefficients{1e9, -1e9, 3.0, 1.0 / 3.0, -7.0};
  std::vector<double> residuals(333 - 100);
  compute_residuals(rows, coefficients, 100, 333, residuals);
  for (std::size_t r = 0; r < residuals.size(); ++r) {
    DoubleDouble expected = data.y[100 + r];
    for (std::size_t c = 0; c < 5; ++c) {
      expected = expected - exact_product(coefficients[c], data.design(100 + r, c) * rows.scales()[c]);
    }
    EXPECT_NEAR(residuals[r], expected.value(), 1e-15 * std::abs(expected.value()) + 1e-21);
  }
}

TEST_P(GramKernels, SquaredLengthsAreThoseOfTheTransformedRows) {
  RandomStream random(6);
  const Data data = random_data(200, 4, random);
  const MatrixRows rows(data.design, data.y);
  Matrix transform(4, 4);
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t r = 0; r <= c; ++r) transform(r, c) = random.normal();
  }
  std::vector<double> lengths(200);
  compute_squared_lengths(rows, transform, 0, 200, lengths);
  for (std::size_t r = 0; r < 200; ++r) {
    double expected = 0.0;
    for (std::size_t c = 0; c < 4; ++c) {
      double value = 0.0;
      for (std::size_t k = 0; k <= c; ++k) value += data.design(r, k) * rows.scales()[k] * transform(k, c);
      expected += value * value;
    }
    EXPECT_NEAR(lengths[r], expected, 1e-14 * (1.0 + expected));
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, GramKernels, testing::ValuesIn(test::instruction_sets()),
                         test::instruction_set_name);

bool same_bits(const GramMatrix& a, const GramMatrix& b) {
  bool same = a.rows() == b.rows();
  for (std::size_t j = 0; j <= a.regressors(); ++j) {
    same = same && a.least(j) == b.least(j) && a.greatest(j) == b.greatest(j);
    for (std::size_t i = 0; i <= j; ++i) {
      same = same && a(i, j).high == b(i, j).high && a(i, j).low == b(i, j).low;
    }
  }
  return same;
}

TEST(GramMatrix, IsTheSameForAnyThreads) {
  RandomStream random(8);
  const Data data = random_data(100'000, 3, random);
  const MatrixRows rows(data.design, data.y);
  const auto with_threads = [&rows](std::size_t threads) {
    const ThreadLimit limit(threads);
    return gram_matrix(rows);
  };
  const GramMatrix once = with_threads(1);
  EXPECT_TRUE(same_bits(once, with_threads(1)));
  EXPECT_TRUE(same_bits(once, with_threads(2)));
  EXPECT_TRUE(same_bits(once, with_threads(5)));
}

TEST(GramMatrix, SelectsClearsAndAdds) {
  RandomStream random(9);
  const Data data = random_data(50, 3, random);
  const GramMatrix gram = gram_matrix(MatrixRows(data.design, data.y));
  GramMatrix part = gram.select(std::vector<std::size_t>{2, 0});
  EXPECT_EQ(part.regressors(), 2U);
  EXPECT_EQ(part(0, 1).value(), gram(2, 0).value());
  EXPECT_EQ(part(0, 2).value(), gram(2, 3).value());
  EXPECT_EQ(part.least(0), gram.least(2));
  part.clear(0);
  EXPECT_EQ(part(1, 0).value(), 0.0);
  EXPECT_EQ(part(1, 1).value(), gram(0, 0).value());
  part.add(part);
  EXPECT_EQ(part.rows(), 100U);
  EXPECT_EQ(part(1, 1).value(), 2.0 * gram(0, 0).value());
}

TEST(GramMatrix, RowsRefuseWhatTheyCannotServe) {
  RandomStream random(10);
  Data data = random_data(9, 2, random);
  EXPECT_THROW((void)MatrixRows(data.design, std::span(data.y).first(8)), std::invalid_argument);
  const MatrixRows rows(data.design, data.y);
  EXPECT_THROW((void)WeightedRows(rows, std::vector<double>(8, 1.0)), std::invalid_argument);
  EXPECT_THROW((void)WeightedRows(rows, std::vector<double>(9, -1.0)), std::invalid_argument);
  data.y[3] = std::nan("");
  EXPECT_THROW((void)MatrixRows(data.design, data.y), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
