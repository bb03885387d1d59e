// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/sample_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/scalar_perceptron.hpp"

namespace proofmass {
namespace {

TEST(SampleRows, AreOneOfEachStretchWithTheirColumns) {
  RandomStream random(1);
  const Samples samples = test::random_samples(2, 1003, random);
  ColumnBlock fixed(2, samples.padded_rows());
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    fixed.column(0)[row] = static_cast<double>(row);
    fixed.column(1)[row] = -samples.target()[row];
  }
  const SampleRows some = one_of_each_stretch(samples, fixed, 100);
  ASSERT_EQ(some.samples.rows(), 100U);
  for (std::size_t row = 0; row < 100; ++row) {
    const auto from = static_cast<std::size_t>(some.fixed.column(0)[row]);
    EXPECT_GE(from, row * 1003 / 100);
    EXPECT_LT(from, (row + 1) * 1003 / 100);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(some.samples.input_data(k)[row], samples.input_data(k)[from]);
    }
    EXPECT_EQ(some.samples.target()[row], samples.target()[from]);
    EXPECT_EQ(some.fixed.column(1)[row], -samples.target()[from]);
  }
  // Kernels also process the padding.
  for (std::size_t row = 100; row < some.samples.padded_rows(); ++row) {
    EXPECT_EQ(some.samples.mask_data()[row], 0.0);
    EXPECT_EQ(some.fixed.column(0)[row], 0.0);
  }
}

TEST(SampleRows, MeetNoPeriodInStep) {
  constexpr std::size_t kStretches = 4096;
  for (const std::size_t period : {2U, 24U, 100U}) {
    Samples samples(1, period * kStretches);
    for (std::size_t row = 0; row < samples.rows(); ++row) {
      samples.input(0)[row] = static_cast<double>(row % period);
    }
    const SampleRows some = one_of_each_stretch(samples, kNoColumns, kStretches);
    std::vector<std::size_t> met(period, 0);
    for (std::size_t row = 0; row < kStretches; ++row) {
      ++met[static_cast<std::size_t>(some.samples.input_data(0)[row])];
    }
    const auto [least, most] = std::minmax_element(met.begin(), met.end());
    EXPECT_GE(*least, kStretches / period / 2) << period;
    EXPECT_LE(*most, 2 * kStretches / period) << period;
  }
}

TEST(SampleRows, AllOfThemAreTheSamples) {
  RandomStream random(2);
  const Samples samples = test::random_samples(1, 17, random);
  const SampleRows all = one_of_each_stretch(samples, kNoColumns, 17);
  for (std::size_t row = 0; row < 17; ++row) {
    EXPECT_EQ(all.samples.input_data(0)[row], samples.input_data(0)[row]);
  }
}

}  // namespace
}  // namespace proofmass
