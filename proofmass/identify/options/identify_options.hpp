// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>

#include "proofmass/core/identification.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/method_info.hpp"

namespace proofmass {

enum class RankLossPolicy { refuse, drop };
inline constexpr std::array kRankLossWords{Word<RankLossPolicy>{"refuse", RankLossPolicy::refuse},
                                           Word<RankLossPolicy>{"drop", RankLossPolicy::drop}};

enum class SplitBy { row, mount };
inline constexpr std::array kSplitByWords{Word<SplitBy>{"row", SplitBy::row},
                                          Word<SplitBy>{"mount", SplitBy::mount}};

inline constexpr std::array kTrainingFractions{kTrainingFraction};  // for the helps

inline constexpr std::array kCovarianceWords{Word<CovarianceKind>{"model", CovarianceKind::model},
                                             Word<CovarianceKind>{"hc3", CovarianceKind::hc3},
                                             Word<CovarianceKind>{"mount", CovarianceKind::mount}};

// What every method takes. In a help, {methods} are those that fit all rows when no split is asked for.
struct IdentifyOptions {
  TermList terms = paper_terms();
  RankLossPolicy on_rank_loss = RankLossPolicy::refuse;
  std::uint64_t seed = 1;
  std::optional<double> split{};
  SplitBy split_by = SplitBy::row;
  CovarianceKind covariance = CovarianceKind::model;

  static constexpr auto fields = std::tuple{
      field("on-rank-loss", &IdentifyOptions::on_rank_loss,
            "what to do about terms that the data cannot separate", kRankLossWords,
            {.place = "ols.md#terms-that-cannot-be-separated"}),
      field("seed", &IdentifyOptions::seed, "seed of the split and of all random draws",
            whole(0, std::numeric_limits<std::uint64_t>::max()), {.place = "numerics.md"}),
      field(
          "split", &IdentifyOptions::split,
          "fraction of the rows to train on, the rest are for testing; 1 fits all rows, which is "
          "the default of {methods}; {} that of the others, and of compare",
          above(0.0, 1.0),
          {.place = "commands.md#which-rows-are-fitted", .absent = "default", .figures = kTrainingFractions}),
      field("split-by", &IdentifyOptions::split_by,
            "whether rows are drawn one by one, or all rows of a mount together (with a split of {} "
            "where none is given)",
            kSplitByWords, {.place = "commands.md#which-rows-are-fitted", .figures = kTrainingFractions}),
      field("covariance", &IdentifyOptions::covariance,
            "what standard errors go by: the method's model of the noise, or how the coefficients change "
            "when each row (hc3) or each mount is left out",
            kCovarianceWords, {.place = "uncertainty.md#covariances"})};
};

}  // namespace proofmass
