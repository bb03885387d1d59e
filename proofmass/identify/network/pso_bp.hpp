// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/network_options.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"
#include "proofmass/numeric/optimise/particle_swarm.hpp"

namespace proofmass {

enum class SwarmFitness {
  separable,
  trained,
  forward
};  // output layer solved inside; a few epochs of training; as is
inline constexpr std::array kFitnessWords{Word<SwarmFitness>{"separable", SwarmFitness::separable},
                                          Word<SwarmFitness>{"trained", SwarmFitness::trained},
                                          Word<SwarmFitness>{"forward", SwarmFitness::forward}};
inline constexpr std::array kUpdateWords{Word<SwarmUpdate>{"sync", SwarmUpdate::synchronous},
                                         Word<SwarmUpdate>{"async", SwarmUpdate::asynchronous}};
inline constexpr std::array kTopologyWords{Word<SwarmTopology>{"global", SwarmTopology::global},
                                           Word<SwarmTopology>{"ring", SwarmTopology::ring},
                                           Word<SwarmTopology>{"von-neumann", SwarmTopology::von_neumann}};

// PSO-BP: a particle swarm (Kennedy & Eberhart 1995 with the inertia of Shi & Eberhart 1998) seeks initial
// weights, the most promising and mutually different particles are trained, and the best network is kept
// (docs/pso-bp.md). With the paper's preset this is the paper's method (Shi et al., section 3); the defaults
// are ours: the swarm moves in the space of the hidden weights with the output layer solved inside, and the
// trainer is variable projection.
struct PsoBp {
  NetworkOptions network{};
  // Hidden units are added up to so many where the training error of network.hidden of them stays above least
  // squares'; not more than network.hidden: none.
  std::size_t grow_to = 12;
  std::size_t particles = 50;
  std::size_t iterations = 60;
  double inertia = 0.7298;     // constriction coefficients of Clerc & Kennedy 2002
  double cognitive = 1.49618;  // pull towards a particle's own best
  double social = 1.49618;     // pull towards its neighbourhood's best
  SwarmUpdate update = SwarmUpdate::synchronous;
  SwarmTopology topology = SwarmTopology::ring;
  double velocity_limit = 0.5;  // fraction of the width of the initial box, a dimension a step; 0: no limit
  SwarmFitness fitness = SwarmFitness::separable;
  std::size_t fitness_epochs = 20;   // of training an evaluation; fitness trained only
  std::size_t stall_iterations = 0;  // end after so many iterations without improvement; 0: never
  std::optional<double> target{};    // end when the best fitness (RMSE of the scaled output) reaches this
  std::size_t refined = 48;  // diverse particles handed to the trainer at most; the best result is kept
  // Positions to start from, one a particle, in the order of PerceptronShape (hidden weights alone when the
  // fitness is separable); the particles beyond those given start at random.
  std::vector<std::vector<double>> initial{};

  static constexpr MethodInfo info{
      .name = "pso-bp",
      .summary = "a tanh network whose initial weights come from a particle swarm",
      .page = "pso-bp.md",
      .predicts_by_network = true,
      .exact_without_noise = false};
  static constexpr auto fields = std::tuple{
      group(&PsoBp::network, NetworkOptions::fields),
      field(
          "grow-to", &PsoBp::grow_to,
          "units are added up to N where least squares says that more are needed; none when hidden is given, "
          "unless this is too",
          whole(0, kMostUnits), {.place = "pso-bp.md#more-hidden-units"}),
      field("particles", &PsoBp::particles, "particles of the swarm", whole(1, kMostMembers),
            {.place = "pso-bp.md#the-swarm"}),
      field("iterations", &PsoBp::iterations, "iterations of the swarm, at most; 0: particles as they start",
            whole(0), {.place = "pso-bp.md#the-swarm"}),
      field("inertia", &PsoBp::inertia, "inertia", between(0.0, 10.0), {.place = "pso-bp.md#the-swarm"}),
      field("cognitive", &PsoBp::cognitive, "pull towards a particle's own best", between(0.0, 10.0),
            {.place = "pso-bp.md#the-swarm"}),
      field("social", &PsoBp::social, "pull towards the neighbourhood's best", between(0.0, 10.0),
            {.place = "pso-bp.md#the-swarm"}),
      field("update", &PsoBp::update, "all particles at once, or one after the other", kUpdateWords,
            {.place = "pso-bp.md#the-swarm"}),
      field("topology", &PsoBp::topology,
            "the particles whose best one each particle follows: all, its two neighbours on a ring, or its "
            "four neighbours on a grid",
            kTopologyWords, {.place = "pso-bp.md#the-swarm"}),
      field("velocity-limit", &PsoBp::velocity_limit,
            "longest step, as a fraction of the initial box; 0: no limit", at_least(0.0),
            {.place = "pso-bp.md#the-swarm"}),
      field("fitness", &PsoBp::fitness,
            "error of a particle: with the output layer solved, after some epochs of training, or with the "
            "particle's own weights",
            kFitnessWords, {.place = "pso-bp.md#the-swarm"}),
      field("fitness-epochs", &PsoBp::fitness_epochs, "training epochs of one evaluation of fitness trained",
            whole(1), {.place = "pso-bp.md#the-swarm"}),
      field("stall", &PsoBp::stall_iterations, "end after N iterations without improvement; 0: never",
            whole(0), {.place = "pso-bp.md#how-it-ends"}),
      field("target", &PsoBp::target, "end at this fitness (RMSE of the scaled output)", at_least(0.0),
            {.place = "pso-bp.md#how-it-ends", .absent = "none"}),
      field("refine", &PsoBp::refined, "candidates handed to the trainer at most; the best result is kept",
            whole(1, kMostMembers), {.place = "pso-bp.md#from-swarm-to-network"})};
};

// Training stops early on the validation rows when there are any. Errors as fit in identify/method.hpp says,
// and a refusal when no particle trains.
[[nodiscard]] Identification fit(const PsoBp& method, const Dataset& training, const Dataset& validation,
                                 const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
