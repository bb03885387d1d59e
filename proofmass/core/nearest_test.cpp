// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/nearest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace proofmass {
namespace {

constexpr std::array<std::string_view, 5> kNames{"identify", "inspect", "compare", "--method", "--methods"};

TEST(NearestName, FindsWhatWasMeant) {
  EXPECT_EQ(nearest_name("identfy", kNames), "identify");
  EXPECT_EQ(nearest_name("Indentify", kNames), "identify");
  EXPECT_EQ(nearest_name("comapre", kNames), "compare");
  EXPECT_EQ(nearest_name("--metod", kNames), "--method");
  EXPECT_EQ(nearest_name("inspekt", kNames), "inspect");
}

TEST(NearestName, DoesNotGuess) {
  for (const char* const word : {"", "x", "frobnicate", "--loss", "ident"})
    EXPECT_EQ(nearest_name(word, kNames), "") << word;
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'i'), kNames), "");
  EXPECT_EQ(nearest_name("identify", {}), "");
}

TEST(NearestName, IsSaidAsAQuestion) {
  EXPECT_EQ(did_you_mean("inspec", kNames).english(), "; did you mean inspect?");
  EXPECT_EQ(did_you_mean("zzz", kNames).english(), "");
}

}  // namespace
}  // namespace proofmass
