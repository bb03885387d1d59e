// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

#include "proofmass/identify/network/training/options.hpp"
#include "proofmass/identify/options/field.hpp"

namespace proofmass {

enum class Extraction { projection, taylor };  // coefficients out of a network
inline constexpr std::array kExtractionWords{Word<Extraction>{"projection", Extraction::projection},
                                             Word<Extraction>{"taylor", Extraction::taylor}};

// How a network is built and trained.
struct NetworkOptions {
  std::optional<std::size_t> hidden = 7;  // tanh units, the paper's choice; absent: chosen by trial
  std::size_t search_repeats = 5;         // trials of each size, at least 2
  TrainingOptions training{};
  Extraction extraction = Extraction::projection;
  bool early_stopping = false;        // ends training when the error on validation rows grows
  double validation_fraction = 0.15;  // of all rows of the record, taken from the training rows

  static constexpr auto fields = std::tuple{
      field("hidden", &NetworkOptions::hidden,
            "hidden units of the network, or search: chosen by trial on rows set aside", whole(1, kMostUnits),
            {.place = "bp.md#how-many-hidden-units", .absent = "search"}),
      field("search-repeats", &NetworkOptions::search_repeats, "trials of each size of hidden search",
            whole(2, kMostUnits), {.place = "bp.md#how-many-hidden-units"}),
      group(&NetworkOptions::training, TrainingOptions::fields),
      field("extract", &NetworkOptions::extraction, "how coefficients come out of the network",
            kExtractionWords, {.place = "bp.md#coefficients"}),
      field("early-stopping", &NetworkOptions::early_stopping,
            "set rows aside and stop when their error grows", kSwitchWords, {.place = "bp.md#how-it-ends"}),
      field("validation-fraction", &NetworkOptions::validation_fraction,
            "fraction of all rows set aside for early stopping, or for hidden search",
            Range<double>{.low = 0.0, .high = 1.0, .above_low = true, .below_high = true},
            {.place = "bp.md#how-it-ends", .former = "validation-share"})};
};

}  // namespace proofmass
