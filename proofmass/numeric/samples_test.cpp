// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/samples.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace proofmass {
namespace {

TEST(Samples, PadsToWholeVectorsWithZeroRows) {
  for (const std::size_t rows : {0U, 1U, 7U, 8U, 9U, 128U}) {
    Samples samples(2, rows);
    EXPECT_EQ(samples.inputs(), 2U);
    EXPECT_EQ(samples.rows(), rows);
    EXPECT_EQ(samples.padded_rows() % Samples::kRowMultiple, 0U);
    EXPECT_LT(samples.padded_rows(), rows + Samples::kRowMultiple);
    for (std::size_t k = 0; k < 2; ++k) std::fill(samples.input(k).begin(), samples.input(k).end(), 3.0);
    std::fill(samples.target().begin(), samples.target().end(), 4.0);
    for (std::size_t row = 0; row < samples.padded_rows(); ++row) {
      const double here = row < rows ? 1.0 : 0.0;
      EXPECT_EQ(samples.mask_data()[row], here);
      EXPECT_EQ(samples.input_data(0)[row], 3.0 * here);
      EXPECT_EQ(samples.input_data(1)[row], 3.0 * here);
      EXPECT_EQ(samples.target_data()[row], 4.0 * here);
    }
  }
}

TEST(Samples, ColumnsStartCacheLines) {
  const Samples samples(3, 5);
  for (const double* column :
       {samples.input_data(0), samples.input_data(2), samples.target_data(), samples.mask_data()}) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(column) % 64, 0U);
  }
}

}  // namespace
}  // namespace proofmass
