// SPDX-License-Identifier: Apache-2.0
// Every method of identification there is, and the one interface of all.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/bp.hpp"
#include "proofmass/identify/network/hybrid.hpp"
#include "proofmass/identify/network/pso_bp.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"
#include "proofmass/identify/regression/eiv.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "proofmass/identify/regression/robust.hpp"
#include "proofmass/identify/regression/tls.hpp"
#include "proofmass/identify/regression/wls.hpp"
#include "proofmass/identify/search/afsa.hpp"
#include "proofmass/identify/search/gmdh.hpp"

namespace proofmass {

// A method with its options. Each is a struct of options with `info`, `fields` and a function `fit`.
using Method = std::variant<Ols, Wls, Robust, Bp, PsoBp, Tls, Eiv, Hybrid, Gmdh, Afsa>;

// All of them with default options, in the order in which they are listed.
[[nodiscard]] std::span<const Method> methods();

// Throws a usage Error listing the names there are when `name` is not among them.
[[nodiscard]] Method find_method(std::string_view name);

[[nodiscard]] const MethodInfo& info(const Method& method);

// Fits the training rows; network methods stop early on the validation rows when there are any, and the
// others have no use for them. Fills method, coefficients with covariance and standard errors, network,
// ending, history, findings and what of the diagnostics is the method's own; intervals and metrics are
// assess's. Throws a refusal when the terms cannot be identified or no usable fit came out, bad data when the
// record cannot serve the method, a usage Error on options that make no sense.
[[nodiscard]] Identification fit(const Method& method, const Dataset& training, const Dataset& validation,
                                 const IdentifyOptions& options, Progress& progress);

// Throws a usage Error when an option of the method is outside its range; so does every fit, before it
// starts.
void require_valid_options(const Method& method);

// The fraction of the rows that the method trains on: that asked for, otherwise the method's own, and less
// than one where whole mounts are to be set aside.
[[nodiscard]] double training_fraction(const Method& method, const IdentifyOptions& options);

// The record's sigma columns that a fit goes by; none for most methods.
[[nodiscard]] SigmaColumns sigma_columns(const Method& method);

// Whether it takes the inputs for uncertain, by columns of the record or by constants.
[[nodiscard]] bool takes_inputs_for_uncertain(const Method& method);

// The standard uncertainty of every input, in g, that takes the place of the record's columns.
[[nodiscard]] std::optional<double> constant_input_sigma(const Method& method);

// The options of the method's network; null where it has none of a size that the options say.
[[nodiscard]] NetworkOptions* network_options(Method& method);
[[nodiscard]] const NetworkOptions* network_options(const Method& method);

// Gives the method's network so many hidden units, and no more however it fits; nothing where the method has
// no network of a size that the options say.
void set_hidden(Method& method, std::size_t hidden);

// Sets the method as the paper has it; false where the paper says nothing of it.
bool apply_paper_preset(Method& method);

// The output that an identification predicts for each row of inputs, in the output's canonical unit: by its
// network when it has one, otherwise by its static model. Throws bad data when the inputs lack an axis that
// the fit used.
[[nodiscard]] std::vector<double> predict(const Identification& fit, const Dataset& inputs);

}  // namespace proofmass
