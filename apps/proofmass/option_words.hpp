// SPDX-License-Identifier: Apache-2.0
// The words that stand for the choices of the command line.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "proofmass/identify/model/options.hpp"

namespace proofmass::cli {

template <typename Value>
struct Word {
  std::string_view text;
  Value value;
};

inline constexpr std::array kRankLossWords{Word<RankLossPolicy>{"refuse", RankLossPolicy::refuse},
                                           Word<RankLossPolicy>{"drop", RankLossPolicy::drop}};
inline constexpr std::array kTrainerWords{Word<Trainer>{"varpro", Trainer::varpro},
                                          Word<Trainer>{"lm", Trainer::lm}};
inline constexpr std::array kFitnessWords{Word<SwarmFitness>{"separable", SwarmFitness::separable},
                                          Word<SwarmFitness>{"trained", SwarmFitness::trained},
                                          Word<SwarmFitness>{"forward", SwarmFitness::forward}};
inline constexpr std::array kExtractionWords{Word<Extraction>{"projection", Extraction::projection},
                                             Word<Extraction>{"taylor", Extraction::taylor}};
inline constexpr std::array kUpdateWords{Word<SwarmUpdate>{"sync", SwarmUpdate::synchronous},
                                         Word<SwarmUpdate>{"async", SwarmUpdate::asynchronous}};
inline constexpr std::array kTopologyWords{Word<SwarmTopology>{"global", SwarmTopology::global},
                                           Word<SwarmTopology>{"ring", SwarmTopology::ring},
                                           Word<SwarmTopology>{"von-neumann", SwarmTopology::von_neumann}};
inline constexpr std::array kWeightWords{Word<WeightSource>{"auto", WeightSource::automatic},
                                         Word<WeightSource>{"sigma", WeightSource::sigma},
                                         Word<WeightSource>{"model", WeightSource::model}};
inline constexpr std::array kScalingWords{Word<ChiSquareScaling>{"given", ChiSquareScaling::given},
                                          Word<ChiSquareScaling>{"chi2", ChiSquareScaling::scaled}};
inline constexpr std::array kLossWords{Word<LossKind>{"huber", LossKind::huber},
                                       Word<LossKind>{"bisquare", LossKind::bisquare},
                                       Word<LossKind>{"t", LossKind::student}};
inline constexpr std::array kGmdhFormWords{Word<GmdhForm>{"combi", GmdhForm::combi},
                                           Word<GmdhForm>{"mia", GmdhForm::mia}};
inline constexpr std::array kGmdhCriterionWords{
    Word<GmdhCriterion>{"press", GmdhCriterion::press},
    Word<GmdhCriterion>{"regularity", GmdhCriterion::regularity},
    Word<GmdhCriterion>{"unbiasedness", GmdhCriterion::unbiasedness}};
inline constexpr std::array kFishCoordinateWords{Word<FishCoordinates>{"whitened", FishCoordinates::whitened},
                                                 Word<FishCoordinates>{"columns", FishCoordinates::columns}};
inline constexpr std::array kSwitchWords{Word<bool>{"on", true}, Word<bool>{"off", false}};
inline constexpr std::array kPresetWords{Word<std::string_view>{"default", "default"},
                                         Word<std::string_view>{"paper", "paper"}};
inline constexpr std::array kModelWords{
    Word<std::string_view>{"linear", "linear"}, Word<std::string_view>{"quadratic", "quadratic"},
    Word<std::string_view>{"paper", "paper"}, Word<std::string_view>{"full", "full"}};

// "a, b, c".
template <typename Words>
[[nodiscard]] std::string list_of(const Words& words, std::string_view separator = ", ") {
  std::string list;
  for (const auto& word : words) list.append(list.empty() ? "" : separator).append(word.text);
  return list;
}

// The word of a value.
template <typename Words, typename Value>
[[nodiscard]] std::string word_of(const Words& words, const Value& value) {
  for (const auto& word : words) {
    if (word.value == value) return std::string(word.text);
  }
  return {};
}

}  // namespace proofmass::cli
