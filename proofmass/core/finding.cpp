// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/finding.hpp"

#include <array>

namespace proofmass {
namespace {

// In the order of Code.
constexpr auto kCount = static_cast<std::size_t>(Code::outputs_unlike_plan) + 1;
constexpr std::array<std::string_view, kCount> kNames{"verbatim",
                                                      "term_without_column",
                                                      "term_input_zero",
                                                      "term_aliased",
                                                      "term_beyond_rows",
                                                      "term_hidden_by_rounding",
                                                      "term_left_out",
                                                      "term_without_expansion",
                                                      "record_decoded",
                                                      "record_preamble_skipped",
                                                      "record_header_in_comment",
                                                      "record_units_line",
                                                      "record_units_in_cells",
                                                      "record_unit_in_name",
                                                      "record_units_assumed",
                                                      "record_decimal_comma",
                                                      "record_fullwidth",
                                                      "record_numbers_converted",
                                                      "record_times_converted",
                                                      "record_labels_with_mark",
                                                      "record_comments_skipped",
                                                      "record_empty_rows_skipped",
                                                      "record_headers_skipped",
                                                      "record_overloads_left_out",
                                                      "record_column_unusable",
                                                      "record_end_mark",
                                                      "inputs_collinear",
                                                      "terms_apart_by_rounding",
                                                      "rounding_costs_digits",
                                                      "white_noise_assumed",
                                                      "sigma_output_unused",
                                                      "test_error_larger",
                                                      "weights_from_sigma",
                                                      "weights_from_model",
                                                      "variance_does_not_grow",
                                                      "scaling_unused",
                                                      "sigma_output_taken",
                                                      "sigma_output_scaled",
                                                      "sigma_output_too_small",
                                                      "sigma_output_too_large",
                                                      "rows_without_weight",
                                                      "weighted_noise_assumed",
                                                      "sigma_inputs_replaced",
                                                      "sigma_output_replaced",
                                                      "uncertainties_taken",
                                                      "uncertainties_scaled",
                                                      "total_least_squares_biased",
                                                      "independent_errors_assumed",
                                                      "huber_loss",
                                                      "bisquare_loss",
                                                      "student_loss",
                                                      "outlying_rows",
                                                      "scale_at_resolution",
                                                      "scale_at_rounding",
                                                      "scale_doubtful",
                                                      "robust_errors_asymptotic",
                                                      "terms_chosen",
                                                      "choice_taken_as_given",
                                                      "layers_grown",
                                                      "layers_expanded",
                                                      "layers_beyond_terms",
                                                      "layers_without_errors",
                                                      "layers_short_of_optimum",
                                                      "pairs_discarded",
                                                      "search_short_of_optimum",
                                                      "search_errors_added",
                                                      "coefficients_projected",
                                                      "coefficients_expanded",
                                                      "expansion_differs",
                                                      "network_misfit",
                                                      "network_above_rounding",
                                                      "network_moves_coefficients",
                                                      "structure_beyond_terms",
                                                      "hidden_choice_ignored",
                                                      "inputs_outside_range",
                                                      "other_plan_named",
                                                      "inputs_unlike_plan",
                                                      "outputs_unlike_plan"};
static_assert(!kNames.back().empty());

}  // namespace

std::string_view to_string(Severity severity) noexcept {
  return severity == Severity::warning ? "warning" : "note";
}

std::string_view to_string(Code code) noexcept { return kNames[static_cast<std::size_t>(code)]; }

std::vector<Code> all_codes() {
  std::vector<Code> codes;
  for (std::size_t k = 0; k < kNames.size(); ++k) codes.push_back(static_cast<Code>(k));
  return codes;
}

std::optional<Code> find_code(std::string_view name) noexcept {
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    if (kNames[k] == name) return static_cast<Code>(k);
  }
  return std::nullopt;
}

}  // namespace proofmass
