// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/training/weight_path.hpp"

#include <gmock/gmock.h>

#include <array>

namespace proofmass {
namespace {

using ::testing::ElementsAre;

TEST(WeightPath, KeepsEpochsWhoseErrorIsLower) {
  TrainingPath path;
  add_to_path(path, 0, 1.0, std::array{1.0}, std::array{10.0});
  add_to_path(path, 1, 0.9999, std::array{2.0});  // would not show
  add_to_path(path, 2, 0.5, std::array{3.0});
  add_to_path(path, 3, 0.7, std::array{4.0});  // after a perturbation
  add_to_path(path, 4, 0.4, std::array{5.0});
  EXPECT_THAT(path.epochs, ElementsAre(0, 2, 4));
  EXPECT_THAT(path.weights, ElementsAre(ElementsAre(1.0, 10.0), ElementsAre(3.0), ElementsAre(5.0)));
}

}  // namespace
}  // namespace proofmass
