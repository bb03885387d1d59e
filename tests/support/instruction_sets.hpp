// SPDX-License-Identifier: Apache-2.0
// Runs a kernel test once on every instruction set that was compiled in and that the processor has:
//   class MyKernels : public test::OnInstructionSet {};
//   INSTANTIATE_TEST_SUITE_P(InstructionSets, MyKernels, testing::ValuesIn(test::instruction_sets()),
//                            test::instruction_set_name);
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <string>
#include <vector>

#include "proofmass/numeric/network/perceptron_kernels.hpp"

namespace proofmass::test {

inline std::vector<std::int64_t> instruction_sets() { return hwy::SupportedAndGeneratedTargets(); }

inline std::string instruction_set_name(const testing::TestParamInfo<std::int64_t>& set) {
  return hwy::TargetName(set.param);
}

class OnInstructionSet : public testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override {
    hwy::SetSupportedTargetsForTest(GetParam());
    ASSERT_STREQ(kernel_target(), hwy::TargetName(GetParam()));
  }
  void TearDown() override { hwy::SetSupportedTargetsForTest(0); }
};

}  // namespace proofmass::test
