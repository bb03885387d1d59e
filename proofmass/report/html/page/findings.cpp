// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/page/findings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/text/findings.hpp"
#include "proofmass/report/text/label.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

Label severity_label(Severity severity) {
  switch (severity) {
    case Severity::basis:
      return Label::basis;
    case Severity::note:
      return Label::note;
    case Severity::warning:
      return Label::warning;
  }
  return Label::note;
}

// Of residuals along the axis that the finding names.
std::string_view figure_along_axis(const Finding& finding) {
  for (const Figure& figure : finding.figures) {
    const auto* const word = std::get_if<std::string>(&figure.value);
    if (figure.name != "axis" || word == nullptr) continue;
    if (*word == "Ao") return "residuals-ao";
    if (*word == "Ap") return "residuals-ap";
  }
  return "residuals-ai";
}

// A label such as "1e2" or "-5": it stays as the record has it, and with it the sentence.
bool has_name_like_a_number(const Finding& finding) {
  return std::any_of(finding.figures.begin(), finding.figures.end(), [](const Figure& figure) {
    const auto* const word = std::get_if<std::string>(&figure.value);
    return word != nullptr && typeset(*word) != *word;
  });
}

}  // namespace

std::string_view figure_of(const Finding& finding) {
  switch (finding.code) {
    case Code::residuals_follow_time:
    case Code::scale_factor_follows_time:
    case Code::time_backwards:
    case Code::time_standing:
      return "residuals-time";
    case Code::residuals_follow_temperature:
    case Code::scale_factor_follows_temperature:
    case Code::temperature_implausible:
      return "residuals-temperature";
    case Code::residuals_follow_order:
    case Code::scale_factor_follows_order:
    case Code::residuals_correlated:
    case Code::rows_shifted:
    case Code::rows_duplicated:
    case Code::output_held:
    case Code::output_stuck:
    case Code::output_repeated:
      return "residuals-order";
    case Code::residuals_follow_mount:
    case Code::scale_factor_follows_mount:
    case Code::alignment_follows_mount:
      return "residuals-mount";
    case Code::residuals_follow_inputs:
    case Code::model_too_short:
      return figure_along_axis(finding);
    case Code::output_clipped:
    case Code::output_saturated:
    case Code::output_wrapped:
    case Code::output_unsigned:
    case Code::output_copies_input:
    case Code::output_far_off:
    case Code::square_larger:
    case Code::gross_misfit:
    case Code::scale_factor_negative:
    case Code::scale_factor_unlike_one:
    case Code::rows_far_off:
    case Code::outlying_rows:
      return "predicted-measured";
    case Code::inputs_in_other_unit:
    case Code::inputs_are_angles:
    case Code::inputs_too_large:
    case Code::input_far_off:
    case Code::magnitude_unlike_others:
      return "excitation";
    case Code::sigma_output_too_small:
    case Code::sigma_output_too_large:
    case Code::sigma_output_uneven:
    case Code::sigma_output_far_off:
      return "histogram";
    case Code::inputs_collinear:
      return "correlations";
    default:
      return {};
  }
}

std::string finding(const Finding& found, const Text& more) {
  const auto words = [&](Language language) {
    const std::string said = sentence(found, language);
    return (has_name_like_a_number(found) ? said : typeset(said)) + more.in(language);
  };
  const Text text{words(Language::en), words(Language::zh)};
  const std::string kind = found.severity == Severity::warning ? "finding warning" : "finding";
  return element("div",
                 fmt::format("<strong>{}</strong>{}{}", both(text_of(severity_label(found.severity))),
                             both({": ", "："}), both(text)),
                 fmt::format("class=\"{}\"", kind));
}

std::string findings_of(std::span<const Finding> all, std::string_view figure) {
  std::string text;
  for (const Finding& one : all)
    if (one.severity != Severity::basis && figure_of(one) == figure) text += finding(one);
  return text;
}

}  // namespace proofmass::html
