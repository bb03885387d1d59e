// SPDX-License-Identifier: Apache-2.0
// The result of the identification of a static model; the same form for every method.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "proofmass/core/ending.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/static_model.hpp"
#include "proofmass/core/units.hpp"

namespace proofmass {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

struct Coefficient {
  Term term = Term::K0;
  double value = 0.0;  // in the output's canonical unit per g^order; meaningless unless identified
  std::optional<double> standard_error;  // 1 sigma, same unit
  std::optional<Interval> ci95;          // two-sided 95 % interval by Student's t
  std::optional<double> t;               // value / standard error
  std::optional<double> p;               // two-sided, of the hypothesis that the coefficient is zero
  std::optional<double> vif;             // variance inflation factor
  bool identified = true;
  bool left_out = false;  // not identified by the method's choice though the rows could: it counts as zero
  std::optional<Finding> reason{};  // why it is not identified
};

// Fraction of the range of the measured outputs below which an output has no relative error.
inline constexpr double kMapeFloor = 0.01;

struct Metrics {
  std::size_t n = 0;
  double mae = 0.0;  // in the output's declared unit
  double mse = 0.0;  // squared
  double rmse = 0.0;
  // Over rows whose measured output is at least kMapeFloor of the range of the outputs: errors relative to an
  // output near zero say nothing. Absent when there is no such row.
  std::optional<double> mape_percent;
  std::size_t mape_rows = 0;
  std::optional<double> r2;  // absent when the measured output does not vary
};

// A named sequence with one value per iteration, such as a training curve or the convergence of the swarm.
struct Curve {
  std::string name;
  std::vector<double> values;
};

// An ni-H-1 network with tanh hidden layer and linear output, and the min-max scaling of its inputs and
// output to [-1, 1]. Weights in the order W (unit by unit, ni each), hidden biases, output weights, output
// bias.
struct TrainedNetwork {
  std::vector<Axis> inputs;
  std::size_t hidden = 0;
  std::vector<double> weights;
  std::vector<Interval> input_range;  // learned from the training rows, one an input, in g
  Interval output_range;              // in the output's canonical unit
  StaticModel skip{};                 // added to the network's output; has no terms in a plain network
};

// A row of the training data that a robust method suspects to be an outlier.
struct SuspectRow {
  std::size_t row = 0;              // among the training rows, from 1
  std::optional<std::size_t> line;  // of the file, when the record came from one
  double residual = 0.0;            // measured minus fitted, in the output's canonical unit
  double scaled_residual = 0.0;     // over the robust scale
  double weight = 0.0;              // of the row in the fit; 1 is full weight
};

// Errors of networks with one number of hidden units, on rows that they were not trained on.
struct HiddenTrial {
  std::size_t hidden = 0;
  std::size_t weights = 0;              // of a network of that size
  std::vector<double> validation_rmse;  // in the output's declared unit, one a repeat
  double mean = 0.0;                    // of those
  double best = 0.0;
  double spread = 0.0;  // their standard deviation
  bool chosen = false;
};

// Figures for judging the coefficients. Absent where a method has no such figure.
struct Diagnostics {
  std::optional<double> residual_sd;        // sqrt(RSS / dof), in the output's canonical unit
  std::optional<std::size_t> dof;           // n - number of parameters
  std::optional<std::size_t> interval_dof;  // of the coefficients' intervals, where it is not dof
  std::optional<double> r2_adjusted;
  std::optional<double> condition_raw;     // 2-norm condition number of the design matrix
  std::optional<double> condition_scaled;  // the same with columns scaled to unit length
  // What the method spent: epochs of training, evaluations of a swarm that trains nothing, steps of an
  // iterative solution, or models computed, all together. Absent for direct solutions.
  std::optional<std::size_t> iterations;
};

// What a method tells beside that, each in a part of its own.
struct NetworkDetails {
  std::optional<double> saturated_fraction;  // of hidden activations over the training rows: |tanh| > 0.99
  // Rms over the training rows of the model's projection of the network's residual: what the network adds to
  // least squares' coefficients.
  std::optional<double> induced_deviation;
  std::size_t training_epochs = 0;               // of all candidates together
  std::optional<std::size_t> swarm_evaluations;  // of the swarm's fitness, where there is a swarm
  std::vector<HiddenTrial> hidden_search;        // of the sizes tried, ascending; when one was asked for
};
struct RobustDetails {
  double scale = 0.0;                    // of the residuals: the standard deviation, were they normal
  std::vector<SuspectRow> suspect_rows;  // largest residual first
};
struct GmdhDetails {
  std::size_t models_tried = 0;
};
struct AfsaDetails {
  std::size_t swarm_evaluations = 0;
  // Distance of the search from the least-squares solution that it searches for:
  double optimum_rmse_ratio = 1.0;  // its root mean square residual over the least possible one
  double optimum_distance = 0.0;    // largest coefficient difference, in its standard errors
};
using Details = std::variant<std::monostate, NetworkDetails, RobustDetails, GmdhDetails, AfsaDetails>;

// Weights of a network on its way through training, in the order of TrainedNetwork, at epochs where its
// training error is visibly lower than before.
struct TrainingPath {
  std::vector<std::size_t> epochs;  // ascending, from 0, the start
  std::vector<std::vector<double>> weights;
  double last_rmse = 0.0;  // of the scaled output, at the last of them
};

// What the covariance of the coefficients goes by: the method's own model of the noise, or how they change
// when each row (HC3) or each mount (CR3) is left out.
enum class CovarianceKind : std::uint8_t { model, hc3, mount };
[[nodiscard]] std::string_view to_string(CovarianceKind kind) noexcept;
[[nodiscard]] std::optional<CovarianceKind> find_covariance_kind(std::string_view name) noexcept;

// Of the training rows in the fit, relative to one another.
struct RowWeights {
  std::vector<double> values;    // empty: all alike
  std::vector<double> slopes{};  // d(weight * residual)/d(residual), where it is not the weight; else empty
  bool fixed = true;             // whatever the outputs, so that leaving a row out changes no other's
};

struct Identification {
  std::string method;
  std::string model;  // preset name, or the list asked for
  std::uint64_t seed = 0;
  Unit output_unit;
  std::vector<Coefficient> coefficients;  // one a term asked for, canonical order
  // Of each axis that the training rows have, in g: beyond it, predictions extrapolate.
  std::vector<std::pair<Axis, Interval>> input_range;
  std::vector<double> covariance;  // of the identified coefficients, row-major; empty when unknown
  CovarianceKind covariance_kind = CovarianceKind::model;
  std::optional<TrainedNetwork>
      network;             // used for prediction by network methods; the others predict by the static model
  RowWeights row_weights;  // of a static model; no part of a result file
  TrainingPath training_path{};  // of a network; no part of a result file
  std::optional<Metrics> train, validation, test;
  // Of each training row as predicted by a fit without it, and without its mount; for methods that fit all
  // rows when they did, over the rows that the others determine.
  std::optional<Metrics> leave_one_out, leave_one_mount_out;
  Ending ending;
  std::vector<Curve> history;
  Diagnostics diagnostics;
  Details details;                // of the method; monostate for those that have none
  std::vector<Finding> findings;  // what must be known to read the result

  // The coefficient of a term. Throws a usage Error when the term was not asked for.
  [[nodiscard]] const Coefficient& find(Term term) const;
  // The identified coefficients as a model.
  [[nodiscard]] StaticModel static_model() const;
};

// The terms of the identified coefficients in the input's own unit: each divided by Ki, standard errors by
// the delta method with the full covariance where it is known: var(x/Ki) = (var x - 2 r cov(x, Ki) + r^2 var
// Ki) / Ki^2 with r = x/Ki (JCGM 100:2008, eq. (13)). Units g per g^order. Ki itself becomes exactly 1, by
// definition and so without a standard error. Intervals keep the coverage factor of the originals; p values
// are left out. Empty when Ki is not identified, is zero, or is less than five of its standard errors away
// from it.
[[nodiscard]] std::vector<Coefficient> referred_to_input(const Identification& result);

// Correlations of the identified coefficients, row-major; empty where the covariance is not known.
[[nodiscard]] std::vector<double> correlations_of(const Identification& result);

}  // namespace proofmass
