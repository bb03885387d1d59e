// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/finding.hpp"

#include <algorithm>
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
                                                      "term_hidden_by_uncertainty",
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
                                                      "record_columns_ignored",
                                                      "record_end_mark",
                                                      "inputs_collinear",
                                                      "terms_apart_by_rounding",
                                                      "rounding_costs_digits",
                                                      "white_noise_assumed",
                                                      "errors_by_rows",
                                                      "errors_by_mounts",
                                                      "sigma_output_unused",
                                                      "test_error_larger",
                                                      "left_out_exactly",
                                                      "left_out_in_one_step",
                                                      "rows_not_left_out",
                                                      "mounts_not_left_out",
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
                                                      "network_errors_compared",
                                                      "structure_beyond_terms",
                                                      "hidden_choice_ignored",
                                                      "inputs_in_other_unit",
                                                      "inputs_are_angles",
                                                      "inputs_too_large",
                                                      "input_far_off",
                                                      "magnitude_unlike_others",
                                                      "rows_shifted",
                                                      "output_unsigned",
                                                      "output_copies_input",
                                                      "output_clipped",
                                                      "output_saturated",
                                                      "output_held",
                                                      "output_stuck",
                                                      "output_repeated",
                                                      "output_wrapped",
                                                      "rows_duplicated",
                                                      "time_backwards",
                                                      "time_standing",
                                                      "temperature_implausible",
                                                      "scale_factor_negative",
                                                      "scale_factor_unlike_one",
                                                      "cross_axis_larger",
                                                      "cross_axis_large",
                                                      "few_degrees_of_freedom",
                                                      "gross_misfit",
                                                      "rows_far_off",
                                                      "model_too_short",
                                                      "residuals_follow_time",
                                                      "residuals_follow_temperature",
                                                      "residuals_follow_order",
                                                      "residuals_follow_mount",
                                                      "residuals_follow_inputs",
                                                      "scale_factor_follows_time",
                                                      "scale_factor_follows_temperature",
                                                      "scale_factor_follows_order",
                                                      "scale_factor_follows_mount",
                                                      "alignment_follows_mount",
                                                      "residuals_correlated",
                                                      "sigma_inputs_unused",
                                                      "sigma_output_uneven",
                                                      "output_far_off",
                                                      "sigma_output_far_off",
                                                      "square_larger",
                                                      "inputs_outside_range",
                                                      "other_plan_named",
                                                      "inputs_unlike_plan",
                                                      "outputs_unlike_plan"};
static_assert(!kNames.back().empty());

constexpr std::array<std::string_view, 3> kSeverities{"basis", "note", "warning"};

constexpr std::array kBasis{Code::left_out_exactly,
                            Code::left_out_in_one_step,
                            Code::rows_not_left_out,
                            Code::mounts_not_left_out,
                            Code::sigma_output_unused,
                            Code::outlying_rows,
                            Code::white_noise_assumed,
                            Code::errors_by_rows,
                            Code::errors_by_mounts,
                            Code::network_errors_compared,
                            Code::weights_from_sigma,
                            Code::weights_from_model,
                            Code::sigma_output_taken,
                            Code::sigma_output_scaled,
                            Code::weighted_noise_assumed,
                            Code::sigma_inputs_replaced,
                            Code::sigma_output_replaced,
                            Code::uncertainties_taken,
                            Code::uncertainties_scaled,
                            Code::total_least_squares_biased,
                            Code::independent_errors_assumed,
                            Code::huber_loss,
                            Code::bisquare_loss,
                            Code::student_loss,
                            Code::robust_errors_asymptotic,
                            Code::terms_chosen,
                            Code::choice_taken_as_given,
                            Code::layers_grown,
                            Code::layers_expanded,
                            Code::layers_beyond_terms,
                            Code::layers_without_errors,
                            Code::search_errors_added,
                            Code::coefficients_projected,
                            Code::coefficients_expanded,
                            Code::structure_beyond_terms,
                            Code::hidden_choice_ignored};

}  // namespace

std::string_view to_string(Severity severity) noexcept {
  return kSeverities[static_cast<std::size_t>(severity)];
}

std::optional<Severity> find_severity(std::string_view name) noexcept {
  const auto* const at = std::find(kSeverities.begin(), kSeverities.end(), name);
  if (at == kSeverities.end()) return std::nullopt;
  return static_cast<Severity>(at - kSeverities.begin());
}

Severity usual_severity(Code code) noexcept {
  return std::find(kBasis.begin(), kBasis.end(), code) == kBasis.end() ? Severity::note : Severity::basis;
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
