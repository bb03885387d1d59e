// SPDX-License-Identifier: Apache-2.0
#include "identify_flags.hpp"

#include <fmt/format.h>

#include <limits>

#include "common_flags.hpp"
#include "initial_swarm.hpp"
#include "option_words.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/identify/method.hpp"

namespace proofmass::cli {
namespace {

using Settings = IdentifySettings;
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
constexpr std::uint64_t kMostUnits = 1000;
constexpr std::uint64_t kMostRepeats = 1000;
constexpr std::uint64_t kMostParticles = 100'000;
constexpr std::uint64_t kMostIterations = 1'000'000'000;

std::string method_help() {
  std::string text = "How to identify (default ols):";
  for (const proofmass::Method& method : methods())
    text += fmt::format("\n  {}: {}", method.name, method.summary);
  return text;
}

}  // namespace

template <typename Set>
void IdentifyFlags::real(CLI::App& verb, const std::string& option, double low, double high,
                         const std::string& help, Set set) {
  add_real(verb, option, {.low = low, .high = high}, help, [this, set](double value) {
    changes_.emplace_back([set, value](Settings& settings) { set(settings, value); });
  });
}

template <typename Set>
void IdentifyFlags::whole(CLI::App& verb, const std::string& option, std::uint64_t low, std::uint64_t high,
                          const std::string& help, Set set) {
  add_whole(verb, option, low, high, help, [this, set](std::uint64_t value) {
    changes_.emplace_back([set, value](Settings& settings) { set(settings, value); });
  });
}

template <typename Words, typename Set>
void IdentifyFlags::choice(CLI::App& verb, const std::string& option, const Words& words,
                           const std::string& help, Set set) {
  const auto take = [this, option, words, set](const std::string& text) {
    for (const auto& word : words) {
      if (word.text != text) continue;
      changes_.emplace_back([set, value = word.value](Settings& settings) { set(settings, value); });
      return;
    }
    throw usage_error(fmt::format("{}: found '{}', expected one of {}", option, text, list_of(words)));
  };
  verb.add_option_function<std::string>(option, take, help)->type_name(list_of(words, "|"));
}

void IdentifyFlags::add_method_option(CLI::App& verb) {
  const auto take_method = [this](const std::string& text) {
    changes_.emplace_back([text](Settings& s) { s.method = find_method(text).name; });
  };
  verb.add_option_function<std::string>("--method", take_method, method_help())->type_name("METHOD");
}

void IdentifyFlags::add_data_options(CLI::App& verb) {
  choice(verb, "--model", kModelWords, "Terms of the model: a preset (default paper)",
         [](Settings& s, std::string_view name) { s.model = name; });
  const auto take_terms = [this](const std::string& text) {
    changes_.emplace_back([text](Settings& s) { s.model = join_names(parse_terms(text)); });
  };
  verb.add_option_function<std::string>("--terms", take_terms, "Terms of the model, in place of --model")
      ->type_name("K0,Ki,...")
      ->excludes("--model");
  choice(verb, "--on-rank-loss", kRankLossWords,
         "What to do about terms that the data cannot separate (default refuse)",
         [](Settings& s, RankLossPolicy policy) { s.options.on_rank_loss = policy; });
  whole(verb, "--seed", 0, std::numeric_limits<std::uint64_t>::max(),
        "Seed of the split and of all random draws (default 1)",
        [](Settings& s, std::uint64_t seed) { s.options.seed = seed; });
  add_real(verb, "--split", {.low = 0.0, .high = 1.0, .above_low = true},
           "Share of the rows to train on, the rest are for testing; 1 fits all rows (default 0.7)",
           [this](double share) {
             changes_.emplace_back([share](Settings& s) { s.split.training_share = share; });
           });
}

void IdentifyFlags::add_hidden_options(CLI::App& verb) {
  const auto take_hidden = [this](const std::string& text) {
    const bool search = text == "search";
    if (!search && (text.empty() || text.find_first_not_of("0123456789") != std::string::npos)) {
      throw usage_error(fmt::format("--hidden: found '{}', expected a whole number from 1 to {}, or search",
                                    text, kMostUnits));
    }
    const std::uint64_t n = search ? 0 : whole_number("--hidden", text, 1, kMostUnits);
    changes_.emplace_back([search, n](Settings& s) {
      s.options.network.search_hidden = search;
      if (!search) s.options.network.hidden = n;
    });
  };
  verb.add_option_function<std::string>(
          "--hidden", take_hidden,
          "Hidden units of the network (default 7), or chosen by trial on rows set aside")
      ->type_name("N|search");
  whole(verb, "--search-repeats", 2, kMostRepeats, "Trials of each size of --hidden search (default 5)",
        [](Settings& s, std::uint64_t n) { s.options.network.search_repeats = n; });
}

void IdentifyFlags::add_network_options(CLI::App& verb) {
  const auto take_preset = [this](const std::string& text) {
    for (const auto& word : kPresetWords) {
      if (word.text == text) preset_ = text;
    }
    if (preset_ != text) {
      throw usage_error(fmt::format("--preset: found '{}', expected one of {}", text, list_of(kPresetWords)));
    }
  };
  verb.add_option_function<std::string>("--preset", take_preset, "Settings of the networks to begin with")
      ->type_name(list_of(kPresetWords, "|"));
  add_hidden_options(verb);
  choice(verb, "--trainer", kTrainerWords, "Variable projection (default) or textbook Levenberg-Marquardt",
         [](Settings& s, Trainer trainer) { s.options.network.trainer = trainer; });
  whole(verb, "--epochs", 1, kMostIterations, "At most N training epochs a start (default 1000)",
        [](Settings& s, std::uint64_t n) { s.options.network.epochs = n; });
  whole(verb, "--kicks", 0, kMostIterations,
        "Perturbations in a row without gain before varpro ends (default 2)",
        [](Settings& s, std::uint64_t n) { s.options.network.kicks = n; });
  whole(verb, "--starts", 1, kMostParticles,
        "Random starts of bp; the best few are trained to the end (default 1)",
        [](Settings& s, std::uint64_t n) { s.options.network.starts = n; });
  whole(verb, "--start-epochs", 1, kMostIterations,
        "Epochs each of several starts gets before the choice (default 20)",
        [](Settings& s, std::uint64_t n) { s.options.network.start_epochs = n; });
  choice(verb, "--extract", kExtractionWords, "How coefficients come out of the network (default projection)",
         [](Settings& s, Extraction extraction) { s.options.network.extraction = extraction; });
  choice(verb, "--early-stopping", kSwitchWords,
         "Set rows aside and stop when their error grows (default off)",
         [](Settings& s, bool on) { s.split.early_stopping = on; });
  real(verb, "--validation-share", kSmallest, 1.0,
       "Share of all rows set aside for early stopping (default 0.15)",
       [](Settings& s, double share) { s.split.validation_share = share; });
  whole(verb, "--validation-failures", 1, kMostIterations,
        "Epochs without improvement that stop early (default 6)",
        [](Settings& s, std::uint64_t n) { s.options.network.validation_failures = n; });
}

void IdentifyFlags::add_uncertainty_options(CLI::App& verb) {
  real(verb, "--sigma-input-ug", 0.0, kLargest,
       "Uncertainty of the accelerations for tls and eiv, in ug, in place of the record's sigma_Ai, ...",
       [](Settings& s, double sigma) { s.options.uncertainty.input = 1e-6 * sigma; });
  real(verb, "--sigma-output-ug", kSmallest, kLargest,
       "Uncertainty of the output for tls and eiv, in ug referred to the input, in place of sigma_E",
       [](Settings& s, double sigma) { s.options.uncertainty.output = 1e-6 * sigma; });
  whole(verb, "--eiv-iterations", 1, kMostIterations, "At most N iterations of eiv (default 200)",
        [](Settings& s, std::uint64_t n) { s.options.uncertainty.iterations = n; });
}

void IdentifyFlags::add_damping_options(CLI::App& verb) {
  real(verb, "--mu", kSmallest, kLargest, "Initial damping of --trainer lm (default 0.001)",
       [](Settings& s, double mu) { s.options.network.mu = mu; });
  real(verb, "--mu-decrease", kSmallest, 1.0, "Factor of the damping after an accepted step (default 0.1)",
       [](Settings& s, double factor) { s.options.network.mu_decrease = factor; });
  real(verb, "--mu-increase", 1.0 + 1e-6, kLargest,
       "Factor of the damping after a rejected step (default 10)",
       [](Settings& s, double factor) { s.options.network.mu_increase = factor; });
  real(verb, "--mu-max", kSmallest, kLargest, "Damping that ends training (default 1e10)",
       [](Settings& s, double mu) { s.options.network.mu_max = mu; });
  real(verb, "--minimum-gradient", 0.0, kLargest, "Gradient that ends training (default 1e-7)",
       [](Settings& s, double gradient) { s.options.network.minimum_gradient = gradient; });
}

void IdentifyFlags::add_swarm_options(CLI::App& verb) {
  whole(verb, "--particles", 2, kMostParticles, "Particles of the swarm (default 50)",
        [](Settings& s, std::uint64_t n) { s.options.swarm.particles = n; });
  whole(verb, "--iterations", 1, kMostIterations, "At most N iterations of the swarm (default 60)",
        [](Settings& s, std::uint64_t n) { s.options.swarm.iterations = n; });
  real(verb, "--inertia", 0.0, 10.0, "Inertia (default 0.7298)",
       [](Settings& s, double w) { s.options.swarm.inertia = w; });
  real(verb, "--cognitive", 0.0, 10.0, "Pull towards a particle's own best (default 1.49618)",
       [](Settings& s, double c) { s.options.swarm.cognitive = c; });
  real(verb, "--social", 0.0, 10.0, "Pull towards the neighbourhood's best (default 1.49618)",
       [](Settings& s, double c) { s.options.swarm.social = c; });
  choice(verb, "--update", kUpdateWords, "All particles at once (default), or one after the other",
         [](Settings& s, SwarmUpdate update) { s.options.swarm.update = update; });
  choice(verb, "--topology", kTopologyWords, "Who follows whom (default ring)",
         [](Settings& s, SwarmTopology topology) { s.options.swarm.topology = topology; });
  real(verb, "--velocity-limit", 0.0, kLargest,
       "Longest step, as a share of the initial box; 0: no limit (default 0.5)",
       [](Settings& s, double limit) { s.options.swarm.velocity_limit = limit; });
  choice(verb, "--fitness", kFitnessWords,
         "Error with the output layer solved (default), after training, or as it is",
         [](Settings& s, SwarmFitness fitness) { s.options.swarm.fitness = fitness; });
  whole(verb, "--fitness-epochs", 1, kMostIterations,
        "Training epochs of one evaluation of --fitness trained (default 20)",
        [](Settings& s, std::uint64_t n) { s.options.swarm.fitness_epochs = n; });
  whole(verb, "--refine", 1, kMostParticles,
        "Particles (or starts of bp) handed to the trainer at most; the best result is kept (default 48)",
        [](Settings& s, std::uint64_t n) { s.options.swarm.refined = n; });
}

void IdentifyFlags::add_swarm_endings(CLI::App& verb) {
  const auto take_initial = [this](const std::string& path) {
    changes_.emplace_back([path](Settings& s) {
      s.options.swarm.initial = read_positions(path);
      s.initial_swarm = path;
    });
  };
  verb.add_option_function<std::string>("--initial-swarm", take_initial,
                                        "Positions to start from: a line a particle, numbers between commas")
      ->type_name("FILE");
  whole(verb, "--stall", 0, kMostIterations,
        "End after N iterations without improvement; 0: never (default 0)",
        [](Settings& s, std::uint64_t n) { s.options.swarm.stall_iterations = n; });
  real(verb, "--target", 0.0, kLargest, "End at this fitness (RMSE of the scaled output)",
       [](Settings& s, double target) { s.options.swarm.target = target; });
}

void IdentifyFlags::add_weight_options(CLI::App& verb) {
  choice(verb, "--weights", kWeightWords,
         "Weights of wls: sigma_E when there is one (default), sigma_E, or noise that grows with |A|",
         [](Settings& s, WeightSource source) { s.options.wls.weights = source; });
  choice(verb, "--sigma-scale", kScalingWords,
         "Standard errors of wls, tls, eiv by the sigmas as given (default), or scaled by chi2/dof",
         [](Settings& s, ChiSquareScaling scaling) {
           s.options.wls.scaling = s.options.uncertainty.scaling = scaling;
         });
  choice(verb, "--loss", kLossWords, "Loss of robust (default bisquare)",
         [](Settings& s, LossKind loss) { s.options.robust.fit.loss = loss; });
  real(verb, "--tuning", 1e-3, 1e6,
       "Constant of the loss: Huber's k (default 1.345), Tukey's c (4.685), degrees of freedom of t "
       "(estimated)",
       [](Settings& s, double tuning) { s.options.robust.fit.tuning = tuning; });
  real(verb, "--outlier-limit", kSmallest, kLargest,
       "Robust scales beyond which robust lists a row as suspect (default 4)",
       [](Settings& s, double limit) { s.options.robust.outlier_limit = limit; });
}

void IdentifyFlags::add_gmdh_options(CLI::App& verb) {
  choice(verb, "--gmdh-form", kGmdhFormWords, "Terms of the model (default combi), or layers of quadratics",
         [](Settings& s, GmdhForm form) { s.options.gmdh.form = form; });
  choice(verb, "--gmdh-criterion", kGmdhCriterionWords,
         "Errors at rows left out one by one (default press), at checking rows, or two halves' difference",
         [](Settings& s, GmdhCriterion criterion) { s.options.gmdh.criterion = criterion; });
  real(verb, "--gmdh-checking-share", kSmallest, 1.0,
       "Share of the training rows that criterion regularity checks on (default 0.3)",
       [](Settings& s, double share) { s.options.gmdh.checking_share = share; });
  real(verb, "--gmdh-tolerance", 0.0, kLargest,
       "combi: take the fewest terms within this share of the least criterion (default 0)",
       [](Settings& s, double share) { s.options.gmdh.tolerance = share; });
  whole(verb, "--gmdh-beam", 1, kMostParticles, "combi: subsets the stepwise search carries (default 8)",
        [](Settings& s, std::uint64_t n) { s.options.gmdh.beam = n; });
  whole(verb, "--gmdh-models", 0, kMostIterations,
        "combi: models of the exhaustive search at most; 0: stepwise alone (default 100000)",
        [](Settings& s, std::uint64_t n) { s.options.gmdh.models = n; });
  whole(verb, "--gmdh-layers", 1, kMostUnits, "mia: layers at most (default 8)",
        [](Settings& s, std::uint64_t n) { s.options.gmdh.layers = n; });
  whole(verb, "--gmdh-survivors", 2, kMostUnits, "mia: neurons that feed the next layer (default 10)",
        [](Settings& s, std::uint64_t n) { s.options.gmdh.survivors = n; });
  choice(verb, "--gmdh-inputs", kSwitchWords, "mia: the inputs feed every layer (default on)",
         [](Settings& s, bool on) { s.options.gmdh.inputs_in_every_layer = on; });
  real(verb, "--gmdh-improvement", 0.0, 1.0,
       "mia: end when a layer lowers the criterion by less than this share (default 0.01)",
       [](Settings& s, double share) { s.options.gmdh.improvement = share; });
}

void IdentifyFlags::add_fish_options(CLI::App& verb) {
  whole(verb, "--fish", 2, kMostParticles, "Fish of afsa (default 50)",
        [](Settings& s, std::uint64_t n) { s.options.fish.fish = n; });
  whole(verb, "--fish-iterations", 1, kMostIterations, "At most N iterations of afsa (default 500)",
        [](Settings& s, std::uint64_t n) { s.options.fish.iterations = n; });
  whole(verb, "--fish-tries", 0, kMostIterations,
        "Points that a preying fish looks at before it swims at random (default 10)",
        [](Settings& s, std::uint64_t n) { s.options.fish.tries = n; });
  real(verb, "--fish-visual", kSmallest, kLargest,
       "How far a fish sees at first, in lengths of the output (default 4)",
       [](Settings& s, double visual) { s.options.fish.visual = visual; });
  real(verb, "--fish-step", kSmallest, kLargest,
       "Longest stroke at first, in lengths of the output (default 4)",
       [](Settings& s, double step) { s.options.fish.step = step; });
  real(verb, "--crowd-factor", 0.0, 1.0,
       "Share of the fish within sight beyond which a place is crowded (default 0.6)",
       [](Settings& s, double factor) { s.options.fish.crowd_factor = factor; });
  whole(verb, "--fish-stall", 0, kMostIterations,
        "End after N iterations without a better best; 0: never (default 0)",
        [](Settings& s, std::uint64_t n) { s.options.fish.stall_iterations = n; });
  real(verb, "--fish-target", 0.0, kLargest,
       "End at this root mean square residual, in the output's canonical unit (g, A, V, ...)",
       [](Settings& s, double target) { s.options.fish.target = target; });
}

void IdentifyFlags::add_fish_form(CLI::App& verb) {
  choice(verb, "--fish-coordinates", kFishCoordinateWords,
         "Coefficients through the triangular factor (default), or times the lengths of their columns",
         [](Settings& s, FishCoordinates coordinates) { s.options.fish.coordinates = coordinates; });
  choice(verb, "--fish-decay", kSwitchWords, "Let visual and step shrink (default on)",
         [](Settings& s, bool on) { s.options.fish.decay = on; });
  real(verb, "--fish-decay-rate", 0.0, 700.0, "They end exp(-X) times as long as they began (default 25)",
       [](Settings& s, double rate) { s.options.fish.decay_rate = rate; });
  real(verb, "--fish-decay-exponent", 1e-3, 1e3,
       "Power of the share of iterations done in that exponent (default 1)",
       [](Settings& s, double exponent) { s.options.fish.decay_exponent = exponent; });
}

void IdentifyFlags::add_to(CLI::App& verb, Method method) {
  if (method == Method::option) add_method_option(verb);
  add_data_options(verb);
  add_weight_options(verb);
  add_uncertainty_options(verb);
  add_gmdh_options(verb);
  add_network_options(verb);
  add_damping_options(verb);
  add_swarm_options(verb);
  add_swarm_endings(verb);
  add_fish_options(verb);
  add_fish_form(verb);
}

IdentifySettings IdentifyFlags::settings() const {
  Settings settings;
  settings.preset = preset_;
  if (preset_ == "paper") {
    apply_paper_preset(settings.options, settings.split);
  }
  for (const Change& change : changes_) change(settings);
  settings.options.terms = parse_terms(settings.model);
  if (settings.options.network.search_hidden && !settings.options.swarm.initial.empty()) {
    throw usage_error("--initial-swarm is for one size of network; give --hidden a number with it");
  }
  return settings;
}

}  // namespace proofmass::cli
