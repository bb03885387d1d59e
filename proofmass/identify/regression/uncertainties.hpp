// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/static_model.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/identify/regression/uncertainty_options.hpp"

namespace proofmass {

// Throws bad data naming file, row and column where a standard uncertainty that a fit goes by is zero (the
// output's), or outside 1e-30 to 1e30 of its unit, where squares and their ratios leave the range of numbers.
void require_usable_sigmas(const Dataset& record, const SigmaColumns& used);

// Standard uncertainties of every row, for methods that take the inputs' into account.
struct Uncertainties {
  std::array<std::vector<double>, 3> input;  // of Ai, Ao, Ap in g; empty where the axis counts as exact
  std::vector<double> output;                // of E, in the output's canonical unit
  std::vector<Finding> findings;             // where they came from, if not from the record alone
};

// From the options' constants where given, otherwise from the record's sigma columns. `least_squares` are the
// terms' coefficients by least squares, for the constant of the output, which is referred to the input.
// Throws a refusal that says what to give when there are none for the output or for no axis that a term uses,
// or the output's constant needs a Ki that is not among the terms; what require_usable_sigmas throws; a usage
// Error on constants as unusable.
[[nodiscard]] Uncertainties find_uncertainties(std::string_view method, const Dataset& data,
                                               const TermList& terms,
                                               const std::vector<double>& least_squares,
                                               const UncertaintyOptions& options);

// 1 / (sigma_E² + sum over the axes of (dE/dA sigma_A)²) of each row: its weight to first order.
[[nodiscard]] std::vector<double> effective_weights(const Uncertainties& sigmas, const StaticModel& model,
                                                    const Dataset& data);

// How standard errors of these methods go by the uncertainties. `ratio` is the residual variance over that
// which the uncertainties lead to expect.
[[nodiscard]] Finding explain_standard_errors(ChiSquareScaling scaling, double ratio);

}  // namespace proofmass
