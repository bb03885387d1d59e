// SPDX-License-Identifier: Apache-2.0
// What must be known to read a result, as data: the words are in report/text, in the reader's language.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "proofmass/core/term.hpp"

namespace proofmass {

enum class Severity : std::uint8_t {
  basis,    // what the figures of a method rest on: said of every result of it
  note,     // what was seen in this record or fit
  warning,  // the figures may be wrong, or mean something else than they seem to
};
[[nodiscard]] std::string_view to_string(Severity severity) noexcept;
[[nodiscard]] std::optional<Severity> find_severity(std::string_view name) noexcept;

// What was found. Each has a name in snake case, which is its value in JSON, and a sentence in report/text.
enum class Code : std::uint8_t {
  verbatim,  // a sentence of another version's result, in the figure "text"
  // Why a term is not identified: the first of the terms; the others are those that it is aliased with.
  term_without_column,
  term_input_zero,
  term_aliased,
  term_beyond_rows,
  term_hidden_by_rounding,
  term_hidden_by_uncertainty,
  term_left_out,
  term_without_expansion,
  // Reading a record.
  record_decoded,
  record_preamble_skipped,
  record_header_in_comment,
  record_units_line,
  record_units_in_cells,
  record_unit_in_name,
  record_units_assumed,
  record_decimal_comma,
  record_fullwidth,
  record_numbers_converted,
  record_times_converted,
  record_labels_with_mark,
  record_comments_skipped,
  record_empty_rows_skipped,
  record_headers_skipped,
  record_overloads_left_out,
  record_column_unusable,
  record_columns_ignored,
  record_end_mark,
  // Any method.
  inputs_collinear,
  terms_apart_by_rounding,
  rounding_costs_digits,
  white_noise_assumed,
  errors_by_rows,
  errors_by_mounts,
  sigma_output_unused,
  test_error_larger,
  left_out_exactly,
  left_out_in_one_step,
  rows_not_left_out,
  mounts_not_left_out,
  // wls
  weights_from_sigma,
  weights_from_model,
  variance_does_not_grow,
  scaling_unused,
  sigma_output_taken,
  sigma_output_scaled,
  sigma_output_too_small,
  sigma_output_too_large,
  rows_without_weight,
  weighted_noise_assumed,
  // tls, eiv
  sigma_inputs_replaced,
  sigma_output_replaced,
  uncertainties_taken,
  uncertainties_scaled,
  total_least_squares_biased,
  independent_errors_assumed,
  // robust
  huber_loss,
  bisquare_loss,
  student_loss,
  outlying_rows,
  scale_at_resolution,
  scale_at_rounding,
  scale_doubtful,
  robust_errors_asymptotic,
  // gmdh
  terms_chosen,
  choice_taken_as_given,
  layers_grown,
  layers_expanded,
  layers_beyond_terms,
  layers_without_errors,
  layers_short_of_optimum,
  pairs_discarded,
  // afsa
  search_short_of_optimum,
  search_errors_added,
  // networks
  coefficients_projected,
  coefficients_expanded,
  expansion_differs,
  network_misfit,
  network_above_rounding,
  network_moves_coefficients,
  network_errors_compared,
  // hybrid
  structure_beyond_terms,
  hidden_choice_ignored,
  // Faults of the record, and of a fit to it.
  inputs_in_other_unit,
  inputs_are_angles,
  inputs_too_large,
  input_far_off,
  magnitude_unlike_others,
  rows_shifted,
  output_unsigned,
  output_copies_input,
  output_clipped,
  output_saturated,
  output_held,
  output_stuck,
  output_repeated,
  output_wrapped,
  rows_duplicated,
  time_backwards,
  time_standing,
  temperature_implausible,
  scale_factor_negative,
  scale_factor_unlike_one,
  cross_axis_larger,
  cross_axis_large,
  few_degrees_of_freedom,
  gross_misfit,
  rows_far_off,
  model_too_short,
  residuals_follow_time,
  residuals_follow_temperature,
  residuals_follow_order,
  residuals_follow_mount,
  residuals_follow_inputs,
  scale_factor_follows_time,
  scale_factor_follows_temperature,
  scale_factor_follows_order,
  scale_factor_follows_mount,
  alignment_follows_mount,
  residuals_correlated,
  sigma_inputs_unused,
  sigma_output_uneven,
  output_far_off,
  sigma_output_far_off,
  square_larger,
  // predict
  inputs_outside_range,
  // compare with a known truth
  other_plan_named,
  inputs_unlike_plan,
  outputs_unlike_plan,
};
[[nodiscard]] std::string_view to_string(Code code) noexcept;
[[nodiscard]] std::optional<Code> find_code(std::string_view name) noexcept;
// Basis or note: a warning is said where it is found.
[[nodiscard]] Severity usual_severity(Code code) noexcept;
// All of them, in order.
[[nodiscard]] std::vector<Code> all_codes();

// A number, or a word that is no sentence: a unit, a name, or a choice by its name in a table of options.
struct Figure {
  Figure(std::string_view figure, double number) : name(figure), value(number) {}
  Figure(std::string_view figure, std::size_t count) : name(figure), value(static_cast<double>(count)) {}
  Figure(std::string_view figure, std::string word) : name(figure), value(std::move(word)) {}
  std::string name;
  std::variant<double, std::string> value;
  friend bool operator==(const Figure&, const Figure&) = default;
};

struct Finding {
  Code code = Code::verbatim;
  Severity severity = usual_severity(code);
  TermList terms{};                  // that it is about
  std::vector<std::size_t> lines{};  // of the record's file, or row numbers from 1 where it has none
  std::vector<Figure> figures{};
  friend bool operator==(const Finding&, const Finding&) = default;
};

}  // namespace proofmass
