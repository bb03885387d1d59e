// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/scaling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

Dataset two_axes() {
  Dataset record;
  record.source = "bench.csv";
  record.acceleration[0] = {-2.0, 6.0, 4.0};
  record.acceleration[2] = {0.5, 0.5, 0.5};
  record.output = {10.0, 20.0, 40.0};
  return record;
}

TEST(LearnScaling, TakesTheRangesOfTheRows) {
  const TrainedNetwork network = learn_scaling(two_axes());
  EXPECT_THAT(network.inputs, ElementsAre(Axis::input, Axis::pendulous));
  ASSERT_EQ(network.input_range.size(), 2U);
  EXPECT_EQ(network.input_range[0].low, -2.0);
  EXPECT_EQ(network.input_range[0].high, 6.0);
  EXPECT_EQ(network.output_range.low, 10.0);
  EXPECT_EQ(network.output_range.high, 40.0);
  EXPECT_EQ(output_half_range(network), 15.0);
  EXPECT_TRUE(network.weights.empty());
}

TEST(ScaleRows, MapsTheRangeToMinusOneToOneAndGoesOnBeyond) {
  const TrainedNetwork network = learn_scaling(two_axes());
  Dataset other = two_axes();
  other.acceleration[0] = {-2.0, 6.0, 10.0};
  other.output = {10.0, 40.0, 25.0};
  Samples samples = scale_rows(network, other);
  EXPECT_THAT(samples.input(0), ElementsAre(-1.0, 1.0, 2.0));
  EXPECT_THAT(samples.input(1), Each(0.0)) << "an input that does not vary";
  EXPECT_THAT(samples.target(), ElementsAre(-1.0, 1.0, 0.0));
  other.output.clear();
  EXPECT_THAT(scale_rows(network, other).target(), Each(0.0));
}

TEST(ScaleRows, NamesTheAxisThatIsMissing) {
  const TrainedNetwork network = learn_scaling(two_axes());
  Dataset other = two_axes();
  other.acceleration[2].clear();
  try {
    (void)scale_rows(network, other);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_THAT(error.what(), HasSubstr("bench.csv"));
    EXPECT_THAT(error.what(), HasSubstr("'Ap'"));
  }
}

TEST(CanonicalOrder, IsTheSameForAnyOrderOfTheRows) {
  Dataset record = test::make_twin({.rows = 200});
  // Repeated inputs, as dwells give them: the output decides.
  for (auto& column : record.acceleration) column[17] = column[42];
  RandomStream random(3);
  const Dataset shuffled = record.select(random_permutation(record.rows(), random));
  const Dataset a = in_canonical_order(record);
  const Dataset b = in_canonical_order(shuffled);
  EXPECT_EQ(a.output, b.output);
  EXPECT_EQ(a.acceleration, b.acceleration);
  EXPECT_NE(a.output, record.output);
  EXPECT_TRUE(std::is_sorted(a.acceleration[0].begin(), a.acceleration[0].end()));
}

TEST(NetworkOutputs, AreInTheUnitOfTheRecord) {
  Dataset record = test::make_twin({.rows = 37});
  for (double& value : record.output) value = 2500.0 + 40.0 * value;
  const TrainedNetwork network = test::random_network(record, 5);
  const std::vector<double> outputs = network_outputs(network, record);
  ASSERT_EQ(outputs.size(), 37U);
  for (std::size_t row = 0; row < outputs.size(); ++row) {
    const auto expected = static_cast<double>(test::network_output(network, record.at(row)));
    EXPECT_NEAR(outputs[row], expected, 1e-12 * 2500.0) << row;
  }
}

TEST(NetworkOutputs, HeedNoOutputColumn) {
  Dataset record = test::make_twin({.rows = 20});
  const TrainedNetwork network = test::random_network(record, 3);
  const std::vector<double> with = network_outputs(network, record);
  record.output.clear();
  EXPECT_EQ(network_outputs(network, record), with);
}

}  // namespace
}  // namespace proofmass
