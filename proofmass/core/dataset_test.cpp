// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/dataset.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace proofmass {
namespace {

Dataset without_output_axis() {
  Dataset record;
  record.acceleration = {std::vector{1.0, 2.0, 3.0}, {}, std::vector{10.0, 20.0, 30.0}};
  record.acceleration_sigma[2] = {0.1, 0.2, 0.3};
  record.output = {1.5, 2.5, 3.5};
  record.output_sigma = {0.01, 0.02, 0.03};
  record.mount = {"a", "b", "c"};
  record.temperature = {21, 22, 23};
  record.time = {0, 60, 120};
  record.line = {2, 3, 5};
  record.output_unit = *find_unit("mA");
  record.acceleration_unit = *find_unit("m/s^2");
  record.temperature_unit = *find_unit("K");
  record.time_unit = *find_unit("ms");
  record.source = "run.csv";
  record.source_sha256 = std::string(64, 'a');
  return record;
}

TEST(Dataset, SelectsRowsOfEveryColumnInTheOrderNamed) {
  const std::vector<std::size_t> rows{2, 0, 2};
  const Dataset part = without_output_axis().select(rows);
  EXPECT_EQ(part.rows(), 3U);
  EXPECT_EQ(part.along(Axis::input), (std::vector{3.0, 1.0, 3.0}));
  EXPECT_TRUE(part.along(Axis::output).empty());
  EXPECT_EQ(part.along(Axis::pendulous), (std::vector{30.0, 10.0, 30.0}));
  EXPECT_TRUE(part.acceleration_sigma[0].empty());
  EXPECT_EQ(part.acceleration_sigma[2], (std::vector{0.3, 0.1, 0.3}));
  EXPECT_EQ(part.output, (std::vector{3.5, 1.5, 3.5}));
  EXPECT_EQ(part.output_sigma, (std::vector{0.03, 0.01, 0.03}));
  EXPECT_EQ(part.mount, (std::vector<std::string>{"c", "a", "c"}));
  EXPECT_EQ(part.temperature, (std::vector{23.0, 21.0, 23.0}));
  EXPECT_EQ(part.time, (std::vector{120.0, 0.0, 120.0}));
  EXPECT_EQ(part.line, (std::vector<std::size_t>{5, 2, 5}));
  EXPECT_EQ(part.output_unit.symbol, "mA");
  EXPECT_EQ(part.acceleration_unit.symbol, "m/s^2");
  EXPECT_EQ(part.temperature_unit.symbol, "K");
  EXPECT_EQ(part.time_unit.symbol, "ms");
  EXPECT_EQ(part.source, "run.csv");
  EXPECT_EQ(part.source_sha256, std::string(64, 'a'));
  EXPECT_EQ(without_output_axis().select({}).rows(), 0U);
}

TEST(Dataset, AMissingAxisCountsAsZero) {
  const Dataset record = without_output_axis();
  EXPECT_EQ(record.axes(), (std::vector{Axis::input, Axis::pendulous}));
  EXPECT_EQ(record.at(1).i, 2.0);
  EXPECT_EQ(record.at(1).o, 0.0);
  EXPECT_EQ(record.at(1).p, 20.0);
}

TEST(Dataset, InputsAloneCountAsRows) {
  Dataset record = without_output_axis();
  record.output.clear();
  EXPECT_EQ(record.rows(), 3U);
}

}  // namespace
}  // namespace proofmass
