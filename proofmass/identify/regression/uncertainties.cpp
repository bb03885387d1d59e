// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/uncertainties.hpp"

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

// Whether some input that the terms use is uncertain.
bool find_input(const Dataset& data, const TermList& terms, const std::optional<double>& constant,
                Uncertainties& found) {
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
  if (replaced) found.findings.push_back({.code = Code::sigma_inputs_replaced});
  return any;
}

// Output units per g of input.
double sensitivity(std::string_view method, const Dataset& data, const TermList& terms,
                   const std::vector<double>& least_squares) {
  const auto ki = std::find(terms.begin(), terms.end(), Term::Ki);
  if (ki != terms.end()) return std::abs(least_squares[static_cast<std::size_t>(ki - terms.begin())]);
  if (data.output_unit.is_acceleration()) return 1.0;
  throw refusal(message(
      "{} cannot convert the uncertainty of the output, which is referred to the input, to {} without "
      "the term Ki: give a column sigma_E",
      method, data.output_unit.canonical_symbol()));
}

constexpr double kLeastSigma = 1e-30;
constexpr double kMostSigma = 1e30;

bool in_range(double sigma) { return sigma >= kLeastSigma && sigma <= kMostSigma; }

void require_usable_constant(const Message& what, double sigma) {
  if (in_range(sigma)) return;
  throw usage_error(
      message("{} is {:.3g} g, expected {:.0g} to {:.0g} g", what, sigma, kLeastSigma, kMostSigma));
}

void require_usable_column(const Dataset& record, const std::vector<double>& sigma, const std::string& column,
                           bool zero_is_exact, const Remedy& remedy) {
  for (std::size_t row = 0; row < sigma.size(); ++row) {
    if (in_range(sigma[row]) || (zero_is_exact && sigma[row] == 0.0)) continue;
    throw bad_data({.file = record.source, .row = record.line_of(row), .column = column},
                   fmt::format("{}", sigma[row]),
                   zero_is_exact ? Message("a standard uncertainty of 1e-30 to 1e30, or zero")
                                 : Message("a standard uncertainty above zero, of 1e-30 to 1e30"),
                   {remedy});
  }
}

Error missing_uncertainties(std::string_view method, bool output, bool inputs) {
  Message of_output;
  Message of_inputs;
  std::vector<Remedy> remedies;
  if (output) {
    of_output = message(
        "the uncertainty of the output: a column sigma_E in the record, or a constant referred to the "
        "input");
    remedies.push_back({"sigma-output-ug", ""});
  }
  if (inputs) {
    of_inputs = message(
        "the uncertainty of at least one input that the model uses, above zero: columns sigma_Ai, sigma_Ao, "
        "sigma_Ap in the record, or a constant for all axes; where inputs are exact, use ols");
    remedies.push_back({.option = "sigma-input-ug", .value = "", .with_previous = output});
  }
  const Message needed = output && inputs ? message("{}; and {}", of_output, of_inputs)
                         : output         ? of_output
                                          : of_inputs;
  return refusal(message("{} needs {}", method, needed), std::move(remedies));
}

}  // namespace

SigmaColumns UncertaintyOptions::sigma_columns() const noexcept {
  return {.output = !output,
          .inputs = !input,
          .instead_of_output = {"sigma-output-ug", ""},
          .instead_of_inputs = {"sigma-input-ug", ""}};
}

void require_usable_sigmas(const Dataset& record, const SigmaColumns& used) {
  if (used.output)
    require_usable_column(record, record.output_sigma, "sigma_E", false, used.instead_of_output);
  if (!used.inputs) return;
  for (const Axis axis : kAxes) {
    require_usable_column(record, record.acceleration_sigma[static_cast<std::size_t>(axis)],
                          fmt::format("sigma_{}", axis_name(axis)), true, used.instead_of_inputs);
  }
}

Uncertainties find_uncertainties(std::string_view method, const Dataset& data, const TermList& terms,
                                 const std::vector<double>& least_squares,
                                 const UncertaintyOptions& options) {
  Uncertainties found;
  require_usable_sigmas(data, options.sigma_columns());
  if (options.input && *options.input != 0.0)
    require_usable_constant("the uncertainty of the inputs", *options.input);
  const bool output_missing = !options.output && data.output_sigma.empty();
  const bool inputs_missing = !find_input(data, terms, options.input, found);
  if (output_missing || inputs_missing) throw missing_uncertainties(method, output_missing, inputs_missing);
  if (options.output) {
    const double sigma = *options.output * sensitivity(method, data, terms, least_squares);
    require_usable_constant("the uncertainty of the output", *options.output);
    if (!(sigma > 0.0)) {
      throw refusal(
          message("{} takes the uncertainty of the output in g, and the output does not change with the "
                  "input: its scale factor is zero",
                  method));
    }
    found.output.assign(data.rows(), sigma);
    if (!data.output_sigma.empty()) {
      found.findings.push_back({.code = Code::sigma_output_replaced});
    }
  } else {
    found.output = data.output_sigma;
  }
  return found;
}

std::vector<double> effective_weights(const Uncertainties& sigmas, const StaticModel& model,
                                      const Dataset& data) {
  std::vector<double> weights;
  weights.reserve(data.rows());
  for (std::size_t row = 0; row < data.rows(); ++row) {
    const double from_inputs = model.variance_from_inputs(data.at(row), across_axes(sigmas.input, row));
    weights.push_back(1.0 / (sigmas.output[row] * sigmas.output[row] + from_inputs));
  }
  return weights;
}

Finding explain_standard_errors(ChiSquareScaling scaling, double ratio) {
  return {.code = scaling == ChiSquareScaling::given ? Code::uncertainties_taken : Code::uncertainties_scaled,
          .figures = {{"factor", std::sqrt(ratio)}}};
}

}  // namespace proofmass
