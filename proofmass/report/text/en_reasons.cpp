// SPDX-License-Identifier: Apache-2.0
// Why a term is not identified.
#include <fmt/format.h>

#include "proofmass/report/text/en.hpp"
#include "proofmass/report/text/sentence.hpp"

namespace proofmass {
namespace {

std::string aliased(const Finding& finding) {
  if (finding.terms.size() < 2) return "aliased with other terms";
  const auto product = info(finding.terms.front()).product;
  const TermList others(finding.terms.begin() + 1, finding.terms.end());
  if (others == TermList{Term::K0})
    return fmt::format("aliased with K0: {} is the same in every row", product);
  if (others.size() == 1) {
    return fmt::format("aliased with {}: over these rows {} is proportional to {}", join_names(others),
                       product, info(others.front()).product);
  }
  std::string products;
  for (const Term other : others) products.append(products.empty() ? "" : ", ").append(info(other).product);
  return fmt::format("aliased with {}: over these rows {} is a combination of {}", join_names(others),
                     product, products);
}

std::string hidden_by_rounding(const Finding& finding) {
  if (finding.terms.size() < 2) {
    return filled(
        "its input is no larger than the rounding of the inputs, which are written in steps of {step:.2g} g",
        finding);
  }
  return fmt::format("aliased with {} at the resolution of the record: ",
                     join_names({finding.terms.begin() + 1, finding.terms.end()})) +
         filled(
             "the inputs are written in steps of {step:.2g} g, and what separates these terms is no more "
             "than their rounding. Write the inputs with more digits, or test at more levels of "
             "acceleration",
             finding);
}

std::string hidden_by_uncertainty(const Finding& finding) {
  if (finding.terms.size() < 2)
    return filled("its input is no larger than the uncertainty of the inputs, {sigma:.2g} g", finding);
  return fmt::format("aliased with {} at the uncertainty of the inputs: ",
                     join_names({finding.terms.begin() + 1, finding.terms.end()})) +
         filled(
             "it is {sigma:.2g} g, and what separates these terms is no more than errors of that size. "
             "Measure the inputs better, or test at more levels of acceleration",
             finding);
}

std::string reason(const Finding& finding) {
  switch (finding.code) {
    case Code::term_without_column:
      return filled("the record has no column {column}", finding);
    case Code::term_input_zero:
      return filled("{product} is zero in every row", finding);
    case Code::term_aliased:
      return aliased(finding);
    case Code::term_beyond_rows:
      return filled("{rows:.0f} {rows:?row|rows} cannot determine more than {rows:.0f} {rows:?term|terms}",
                    finding);
    case Code::term_hidden_by_rounding:
      return hidden_by_rounding(finding);
    case Code::term_hidden_by_uncertainty:
      return hidden_by_uncertainty(finding);
    case Code::term_left_out:
      return filled(
          "left out by the search: the criterion is {without:.6g} {unit} without it, {with:.6g} {unit} with "
          "it",
          finding);
    case Code::term_without_expansion:
      return "|Ai|*Ai has no Taylor expansion at zero; use the projection";
    default:
      return english(finding);
  }
}

}  // namespace

std::string english_reason(const Finding& finding) {
  const std::string text = reason(finding);
  return has_figure(finding, "total")
             ? text + filled(" (among the {count:.0f} of {total:.0f} rows that have weight)", finding)
             : text;
}

}  // namespace proofmass
