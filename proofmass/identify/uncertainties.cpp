// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/uncertainties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

bool used(Axis axis, const TermList& terms) {
  return std::any_of(terms.begin(), terms.end(), [axis](Term term) { return info(term).uses(axis); });
}

bool any_above_zero(const std::vector<double>& column) {
  return std::any_of(column.begin(), column.end(), [](double sigma) { return sigma > 0.0; });
}

void find_input(std::string_view method, const Dataset& data, const TermList& terms,
                const std::optional<double>& constant, Uncertainties& found) {
  bool replaced = false;
  bool any = false;
  for (const Axis axis : data.axes()) {
    if (!used(axis, terms)) continue;
    const auto k = static_cast<std::size_t>(axis);
    const std::vector<double>& recorded = data.acceleration_sigma[k];
    replaced = replaced || (constant && !recorded.empty());
    found.input[k] = constant ? std::vector<double>(data.rows(), *constant) : recorded;
    if (!any_above_zero(found.input[k])) found.input[k].clear();
    any = any || !found.input[k].empty();
  }
  if (!any) {
    throw refusal(fmt::format(
        "{} needs the uncertainty of at least one input that the model uses, above zero: columns sigma_Ai, "
        "sigma_Ao, sigma_Ap in the record, or --sigma-input-ug for all axes; where inputs are exact, use ols",
        method));
  }
  if (replaced) found.notes.emplace_back("--sigma-input-ug takes the place of the record's sigma columns");
}

// Output units per g of input.
double sensitivity(std::string_view method, const Dataset& data, const TermList& terms,
                   const std::vector<double>& least_squares) {
  const auto ki = std::find(terms.begin(), terms.end(), Term::Ki);
  if (ki != terms.end()) return std::abs(least_squares[static_cast<std::size_t>(ki - terms.begin())]);
  if (data.output_unit.is_acceleration()) return 1.0;
  throw refusal(
      fmt::format("{} cannot tell what --sigma-output-ug is in {} without the term Ki; give a column sigma_E",
                  method, data.output_unit.canonical_symbol()));
}

void require_positive(const Dataset& data) {
  for (std::size_t row = 0; row < data.rows(); ++row) {
    if (data.output_sigma[row] > 0.0) continue;
    throw bad_data(
        {.file = data.source, .row = data.line.empty() ? row + 1 : data.line[row], .column = "sigma_E"},
        fmt::format("{}", data.output_sigma[row]), "a standard uncertainty above zero");
  }
}

}  // namespace

Uncertainties find_uncertainties(std::string_view method, const Dataset& data, const TermList& terms,
                                 const std::vector<double>& least_squares,
                                 const UncertaintyOptions& options) {
  Uncertainties found;
  if (!options.output && data.output_sigma.empty()) {
    throw refusal(
        fmt::format("{} needs the uncertainty of the output: a column sigma_E in the record, or "
                    "--sigma-output-ug, referred to the input",
                    method));
  }
  find_input(method, data, terms, options.input, found);
  if (options.output) {
    const double sigma = *options.output * sensitivity(method, data, terms, least_squares);
    if (!(sigma > 0.0)) throw usage_error("--sigma-output-ug must be above zero");
    found.output.assign(data.rows(), sigma);
    if (!data.output_sigma.empty()) {
      found.notes.emplace_back("--sigma-output-ug takes the place of the record's sigma_E");
    }
  } else {
    require_positive(data);
    found.output = data.output_sigma;
  }
  return found;
}

std::string describe_standard_errors(ChiSquareScaling scaling, double ratio) {
  const double factor = std::sqrt(ratio);
  if (scaling == ChiSquareScaling::given) {
    return fmt::format(
        "standard errors take the uncertainties given as they are; the residuals are {:.3g} times as large "
        "as "
        "these lead to expect",
        factor);
  }
  return fmt::format(
      "standard errors take from the uncertainties given only their ratios, and are scaled by {:.3g}, the "
      "size of the residuals over that expected",
      factor);
}

}  // namespace proofmass
