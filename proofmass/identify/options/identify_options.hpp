// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>

#include "proofmass/core/term.hpp"
#include "proofmass/identify/options/field.hpp"

namespace proofmass {

enum class RankLossPolicy { refuse, drop };
inline constexpr std::array kRankLossWords{Word<RankLossPolicy>{"refuse", RankLossPolicy::refuse},
                                           Word<RankLossPolicy>{"drop", RankLossPolicy::drop}};

// What every method takes.
struct IdentifyOptions {
  TermList terms = paper_terms();
  RankLossPolicy on_rank_loss = RankLossPolicy::refuse;
  std::uint64_t seed = 1;
  double split = 0.7;

  static constexpr auto fields =
      std::tuple{field("on-rank-loss", &IdentifyOptions::on_rank_loss,
                       "what to do about terms that the data cannot separate", kRankLossWords,
                       {.place = "ols.md#terms-that-cannot-be-separated"}),
                 field("seed", &IdentifyOptions::seed, "seed of the split and of all random draws",
                       whole(0, std::numeric_limits<std::uint64_t>::max()), {.place = "numerics.md"}),
                 field("split", &IdentifyOptions::split,
                       "fraction of the rows to train on, the rest are for testing; 1 fits all rows",
                       above(0.0, 1.0), {.place = "commands.md#identify"})};
};

}  // namespace proofmass
