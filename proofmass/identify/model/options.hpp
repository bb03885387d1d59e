// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "proofmass/core/term.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/numeric/optimise/particle_swarm.hpp"
#include "proofmass/numeric/regression/robust_regression.hpp"

namespace proofmass {

enum class Trainer { varpro, lm };  // variable projection; textbook Levenberg-Marquardt
enum class SwarmFitness {
  separable,
  trained,
  forward
};                                             // output layer solved inside; a few epochs of training; as is
enum class Extraction { projection, taylor };  // coefficients out of a network

// How a network is built and trained. Defaults of the damping are those that MATLAB documents for trainlm.
struct NetworkOptions {
  std::size_t hidden = 7;          // tanh units; the paper's choice
  bool search_hidden = false;      // choose the number of tanh units by trial instead
  std::size_t search_repeats = 5;  // trials of each size, at least 2
  Trainer trainer = Trainer::varpro;
  std::size_t epochs = 1000;  // at most, for the training of one start
  std::size_t kicks = 2;  // perturbations in a row without gain before training goes on to a minimum (varpro)
  double mu = 1e-3;       // initial damping (lm)
  double mu_decrease = 0.1;             // factor after an accepted step (lm)
  double mu_increase = 10.0;            // factor after a rejected step (lm)
  double mu_max = 1e10;                 // training ends beyond this damping (lm)
  double minimum_gradient = 1e-7;       // |Jᵀe| of the scaled output that ends training (lm)
  std::size_t validation_failures = 6;  // successive epochs without improvement on the validation rows, if
                                        // there are any, that end training; the best epoch's weights are kept
  std::size_t starts = 1;               // bp: random starts; the best few are trained to the end
  std::size_t start_epochs = 20;        // bp: epochs each start is given before the best are chosen
  Extraction extraction = Extraction::projection;
};

// How the swarm seeks initial weights (Kennedy & Eberhart 1995 with the inertia of Shi & Eberhart 1998).
struct SwarmOptions {
  std::size_t particles = 50;
  std::size_t iterations = 60;
  double inertia = 0.7298;     // constriction coefficients of Clerc & Kennedy 2002
  double cognitive = 1.49618;  // pull towards a particle's own best
  double social = 1.49618;     // pull towards its neighbourhood's best
  SwarmUpdate update = SwarmUpdate::synchronous;
  SwarmTopology topology = SwarmTopology::ring;
  double velocity_limit = 0.5;  // share of the width of the initial box, a dimension a step; 0: no limit
  SwarmFitness fitness = SwarmFitness::separable;
  std::size_t fitness_epochs = 20;   // of training an evaluation; fitness trained only
  std::size_t stall_iterations = 0;  // end after so many iterations without improvement; 0: never
  std::optional<double> target;      // end when the best fitness (RMSE of the scaled output) reaches this
  std::size_t refined = 48;  // diverse particles handed to the trainer at most; the best result is kept
  // Positions to start from, one a particle, in the order of PerceptronShape (hidden weights alone when the
  // fitness is separable); the particles beyond those given start at random.
  std::vector<std::vector<double>> initial;
};

// How the hybrid method seeks its network.
struct HybridOptions {
  std::size_t most_hidden = 8;  // tanh units at most
  std::size_t patience = 2;     // sizes without a better criterion that end the search
  std::size_t particles = 30;   // of the swarm over the hidden weights
  std::size_t iterations = 20;
  std::size_t refined = 8;   // best particles trained to the end
  std::size_t epochs = 300;  // at most, of each
};

enum class GmdhForm { combi, mia };                            // terms of the model; a network of quadratics
enum class GmdhCriterion { press, regularity, unbiasedness };  // leave-one-out; checking rows; two halves

// How the group method of data handling seeks a structure.
struct GmdhOptions {
  GmdhForm form = GmdhForm::combi;
  GmdhCriterion criterion = GmdhCriterion::press;
  double checking_share = 0.3;   // of the training rows; criterion regularity only
  double tolerance = 0.0;        // combi: the fewest terms whose criterion, as a root mean square, is within
                                 // this share of the least
  std::size_t beam = 8;          // combi: subsets of each size that the stepwise search carries on
  std::size_t models = 100'000;  // combi: models that the exhaustive search after it may compute
  std::size_t layers = 8;        // mia: at most
  std::size_t survivors = 10;    // mia: neurons of a layer that feed the next
  bool inputs_in_every_layer = true;  // mia: the inputs feed every layer beside the survivors
  double improvement = 0.01;          // mia: ends when a layer lowers the criterion by less than this share
};

// Where weights come from: the record's sigma_E if it has one, else a model; that column; that model.
enum class WeightSource { automatic, sigma, model };
// Standard errors from sigma_E as it is, or multiplied by the root of chi²/dof.
enum class ChiSquareScaling { given, scaled };

// How rows are weighed by wls.
struct WlsOptions {
  WeightSource weights = WeightSource::automatic;
  ChiSquareScaling scaling = ChiSquareScaling::given;  // with weights from sigma_E only
  std::size_t iterations = 50;  // of estimating the variance model and refitting, at most
};

// How outlying rows are held down by robust.
struct RobustSettings {
  RobustOptions fit;           // the loss, its constant, the end of the iteration
  double outlier_limit = 4.0;  // robust scales beyond which a row is listed as suspect
};

// What tls and eiv take the uncertainties of inputs and output for.
struct UncertaintyOptions {
  std::optional<double> input;   // g; of every axis in every row, in place of the record's sigma_Ai, …
  std::optional<double> output;  // g, referred to the input (times |Ki|); in place of the record's sigma_E
  ChiSquareScaling scaling = ChiSquareScaling::given;  // chi² over output residuals and input offsets
  std::size_t iterations = 200;                        // eiv: at most
};

// What the fish swim in: the design's triangular factor times the coefficients, where the misfit is a sphere;
// or the coefficients times the lengths of their columns.
enum class FishCoordinates { whitened, columns };

// How afsa's fish swarm searches. Lengths are shares of the output's: a unit of a coordinate makes an output
// of the length (root of the sum of squares) of the measured one.
struct FishSwarmOptions {
  std::size_t fish = 50;
  std::size_t iterations = 500;
  std::size_t tries = 10;     // points that a preying fish looks at before it swims at random
  double visual = 4.0;        // how far a fish sees, at first
  double step = 4.0;          // the longest stroke, at first
  double crowd_factor = 0.6;  // a place with more than this share of the fish within sight is crowded
  bool decay = true;          // the improved form: visual and step shrink by
  double decay_rate = 25.0;   // exp(-decay_rate * (t / iterations)^decay_exponent)
  double decay_exponent = 1.0;
  std::size_t stall_iterations = 0;  // end after so many iterations without a better best; 0: never
  std::optional<double> target;      // end at this root mean square residual, in the output's canonical unit
  FishCoordinates coordinates = FishCoordinates::whitened;
};

struct IdentifyOptions {
  TermList terms;
  RankLossPolicy on_rank_loss = RankLossPolicy::refuse;
  std::uint64_t seed = 1;
  NetworkOptions network;
  SwarmOptions swarm;
  WlsOptions wls;
  RobustSettings robust;
  UncertaintyOptions uncertainty;
  HybridOptions hybrid;
  GmdhOptions gmdh;
  FishSwarmOptions fish;
};

}  // namespace proofmass
