// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"

namespace proofmass {

// What the fish swim in: the design's triangular factor times the coefficients, where the misfit is a sphere;
// or the coefficients times the lengths of their columns.
enum class FishCoordinates { whitened, columns };
inline constexpr std::array kFishCoordinateWords{Word<FishCoordinates>{"whitened", FishCoordinates::whitened},
                                                 Word<FishCoordinates>{"columns", FishCoordinates::columns}};

// An artificial fish swarm over the coefficients of the static model, for the least root mean square residual
// (docs/afsa.md). What it seeks is the least-squares solution, which is computed beside it: the result says
// how far from it the search stays, and the covariance is least squares' with that distance added,
// s² (XᵀX)⁻¹ + d dᵀ. Lengths are fractions of the output's: a unit of a coordinate makes an output of the
// length (root of the sum of squares) of the measured one.
struct Afsa {
  std::size_t fish = 50;
  std::size_t iterations = 500;
  std::size_t tries = 10;     // points that a preying fish looks at before it swims at random
  double visual = 4.0;        // how far a fish sees, at first
  double step = 4.0;          // the longest stroke, at first
  double crowd_factor = 0.6;  // a place with more than this fraction of the fish within sight is crowded
  bool decay = true;          // the improved form: visual and step shrink by
  double decay_rate = 25.0;   // exp(-decay_rate * (t / iterations)^decay_exponent)
  double decay_exponent = 1.0;
  std::size_t stall_iterations = 0;  // end after so many iterations without a better best; 0: never
  std::optional<double> target{};    // end at this root mean square residual, in the output's canonical unit
  FishCoordinates coordinates = FishCoordinates::whitened;

  static constexpr MethodInfo info{
      .name = "afsa",
      .summary = "an artificial fish swarm over the coefficients; a reference for ols",
      .page = "afsa.md",
      .exact_without_noise = false};
  static constexpr auto fields = std::tuple{
      field("fish", &Afsa::fish, "fish of the swarm", whole(2, kMostMembers),
            {.place = "afsa.md#what-it-does"}),
      field("fish-iterations", &Afsa::iterations, "iterations, at most", whole(1),
            {.place = "afsa.md#what-it-does"}),
      field("fish-tries", &Afsa::tries, "points that a preying fish looks at before it swims at random",
            whole(0), {.place = "afsa.md#what-it-does"}),
      field("fish-visual", &Afsa::visual,
            "how far a fish sees at first; a distance of 1 changes the modelled output by the root mean "
            "square of the measured one",
            above(0.0), {.place = "afsa.md#what-it-does"}),
      field("fish-step", &Afsa::step, "longest move at first, in the same measure as visual", above(0.0),
            {.place = "afsa.md#what-it-does"}),
      field("crowd-factor", &Afsa::crowd_factor,
            "fraction of the fish within sight beyond which a place is crowded", between(0.0, 1.0),
            {.place = "afsa.md#what-it-does"}),
      field("fish-decay", &Afsa::decay, "let visual and step shrink", kSwitchWords,
            {.place = "afsa.md#what-it-does"}),
      field("fish-decay-rate", &Afsa::decay_rate,
            "rate in exp(-rate * (t / T)^exponent): visual and step end exp(-X) times as long as they began",
            between(0.0, 700.0), {.place = "afsa.md#what-it-does"}),
      field("fish-decay-exponent", &Afsa::decay_exponent,
            "X in exp(-rate * (t / T)^X), by which visual and step have shrunk at iteration t of T",
            between(1e-3, 1e3), {.place = "afsa.md#what-it-does"}),
      field("fish-coordinates", &Afsa::coordinates,
            "coefficients through the triangular factor, or times the lengths of their columns",
            kFishCoordinateWords, {.place = "afsa.md#what-it-does"}),
      field("fish-stall", &Afsa::stall_iterations, "end after N iterations without a better best; 0: never",
            whole(0), {.place = "afsa.md#what-it-does"}),
      field("fish-target", &Afsa::target,
            "end at this root mean square residual, in g where the output is an acceleration, else in its "
            "declared unit",
            at_least(0.0), {.place = "afsa.md#what-it-does", .absent = "none"})};
};

// Errors as fit in identify/method.hpp says.
[[nodiscard]] Identification fit(const Afsa& method, const Dataset& training, const IdentifyOptions& options,
                                 Progress& progress);

}  // namespace proofmass
