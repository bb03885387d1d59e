// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/en.hpp"

#include <string_view>

#include "proofmass/report/text/en_diagnosis.hpp"
#include "proofmass/report/text/sentence.hpp"
#include "proofmass/report/text/templates_internal.hpp"

namespace proofmass {
namespace {

// Figures by name in braces, as fmt formats them; {terms} are the finding's. Empty where english_reason says
// it.
std::string_view sentence(Code code) noexcept {
  switch (code) {
    case Code::verbatim:
      return "{text}";
    case Code::term_without_column:
    case Code::term_input_zero:
    case Code::term_aliased:
    case Code::term_beyond_rows:
    case Code::term_hidden_by_rounding:
    case Code::term_hidden_by_uncertainty:
    case Code::term_left_out:
    case Code::term_without_expansion:
      break;  // see english_reason
    case Code::record_decoded:
      return "the record is not in UTF-8: it was read as {encoding}";
    case Code::record_preamble_skipped:
      return "{count:.0f} {count:?line above the header is|lines above the header are} skipped: {lines}";
    case Code::record_header_in_comment:
      return "line {lines}, a comment, is taken for the header";
    case Code::record_units_line:
      return "line {lines} is taken for the units of the columns";
    case Code::record_units_in_cells:
      return "units are taken from the cells, in {count:.0f} {count:?row|rows}";
    case Code::record_unit_in_name:
      return "the end of the name {column} is taken for its unit, {unit}";
    case Code::record_units_assumed:
      return "no unit is declared for {columns}: {unit} is assumed";
    case Code::record_decimal_comma:
      return "numbers have a decimal comma";
    case Code::record_fullwidth:
      return "full-width punctuation and digits are read as ASCII";
    case Code::record_numbers_converted:
      return "{count:.0f} {count:?row has|rows have} numbers in full-width digits, with a Unicode minus or "
             "blank, or with an exponent of Fortran (1.5D+00), which are read as usual: {count:?line|lines} "
             "{lines}";
    case Code::record_times_converted:
      return "times of day or dates in the column t are read as seconds since the first row";
    case Code::record_labels_with_mark:
      return "{count:.0f} {count:?line that begins with # is a row, because it has|lines that begin with # "
             "are rows, because they have} a row's numbers: {lines}";
    case Code::record_comments_skipped:
      return "{count:.0f} comment {count:?line among the data is|lines among the data are} skipped: {lines}";
    case Code::record_empty_rows_skipped:
      return "{count:.0f} {count:?row of empty fields is|rows of empty fields are} skipped: {lines}";
    case Code::record_headers_skipped:
      return "{count:.0f} {count:?repetition of the header is|repetitions of the header are} skipped: "
             "{lines}";
    case Code::record_overloads_left_out:
      return "{count:.0f} {count:?row is|rows are} left out because a meter marked a value beyond its range: "
             "{count:?line|lines} {lines}";
    case Code::record_column_unusable:
      return "the column {column} is not used: {count:.0f} of {total:.0f} rows {count:?has|have} no number "
             "there";
    case Code::record_columns_ignored:
      return "{count:.0f} {count:?column of the file is|columns of the file are} not used: {columns}";
    case Code::record_end_mark:
      return "Ctrl-Z at the end of the file is left out";
    case Code::inputs_collinear:
      return "the inputs are collinear: variance inflation factors above {limit:g} ({inflated}). The "
             "standard errors of these coefficients are large; test in more mounts to make them smaller";
    case Code::terms_apart_by_rounding:
      return "some columns of the design differ by {separation:.0e} of their size only. Where the record's "
             "inputs are rounded as coarsely as that, rounding alone separates these terms, and their values "
             "mean nothing";
    case Code::rounding_costs_digits:
      return "the condition number with scaled columns is {condition:.1e}: rounding costs about {digits:.0f} "
             "of 16 digits";
    case Code::white_noise_assumed:
      return "standard errors assume exact inputs and white output noise of the same variance in every row";
    case Code::errors_by_rows:
      return "standard errors come from how the coefficients change when each row is left out (HC3): they "
             "hold for noise of any variance that is independent from row to row, and assume exact inputs";
    case Code::errors_by_mounts:
      return "standard errors come from how the coefficients change when each of {count:.0f} mounts is left "
             "out (CR3): they hold for any errors that are independent from mount to mount; intervals have "
             "{dof:.0f} {dof:?degree|degrees} of freedom";
    case Code::sigma_output_unused:
      return "sigma_E is not used: {method} gives all rows the same weight";
    case Code::test_error_larger:
      return "the test error ({test:.3g} {unit}) is {ratio:.3g} times the training error ({train:.3g} "
             "{unit}): the model does not generalise. Check that test and training rows cover the same "
             "mounts and levels";
    case Code::left_out_exactly:
      return "all rows are fitted; the errors under leave-one-out are those of each row predicted by the fit "
             "to the others (exact)";
    case Code::left_out_in_one_step:
      return "all rows are fitted; the errors under leave-one-out are those of each row predicted by the fit "
             "to the others (in one step from the fit to all with the weights of the rows held, which makes "
             "them a little too small)";
    case Code::rows_not_left_out:
      return "{count:.0f} of {total:.0f} rows cannot be left out: without {count:?it|each of them} the "
             "others do not determine the coefficients";
    case Code::mounts_not_left_out:
      return "{count:.0f} of {total:.0f} mounts cannot be left out: without {count:?it|each of them} the "
             "others do not determine the coefficients";
    case Code::weights_from_sigma:
      return "weights are 1 / sigma_E² from the record";
    case Code::weights_from_model:
      return "weights come from the residuals by restricted maximum likelihood: sigma² = s0² + s1² |A|², s0 "
             "= {s0:.5g} {unit}, s1 = {s1:.5g} {unit}/g, |A| over {axes}";
    case Code::variance_does_not_grow:
      return "the residuals do not grow with |A|, or |A| is the same in every row: all rows have the same "
             "weight, and the result is that of ols";
    case Code::scaling_unused:
      return "standard errors are not scaled by chi²/dof: the weights come from the residuals, not from "
             "sigma_E, and chi² is then the number of degrees of freedom by construction";
    case Code::sigma_output_taken:
      return "chi²/dof is {ratio:.5g} (about 1 ± {spread:.2g} when sigma_E is right); standard errors take "
             "sigma_E as it is; scaled by chi²/dof they would be {factor:.5g} times as large";
    case Code::sigma_output_scaled:
      return "chi²/dof is {ratio:.5g} (about 1 ± {spread:.2g} when sigma_E is right); standard errors are "
             "scaled by it; with sigma_E as it is they would be {factor:.5g} times as large";
    case Code::sigma_output_too_small:
      return "the residuals are larger than sigma_E allows (chi²/dof {ratio:.5g}): sigma_E is too small, the "
             "model lacks terms, or there are outliers. Standard errors that go by sigma_E are then too "
             "small";
    case Code::sigma_output_too_large:
      return "the residuals are smaller than sigma_E says (chi²/dof {ratio:.5g}): sigma_E is too large, and "
             "so are standard errors that go by it";
    case Code::rows_without_weight:
      return "{count:.0f} of {total:.0f} rows {count:?has no weight beside the others, because its|have no "
             "weight beside the others, because their} sigma_E is so much larger: {count:?it does|they do} "
             "not count as degrees of freedom";
    case Code::weighted_noise_assumed:
      return "standard errors assume exact inputs and independent output noise of the variance given; the "
             "residual standard deviation is over all rows alike";
    case Code::sigma_inputs_replaced:
      return "the constant given for the inputs' uncertainty takes the place of the record's sigma columns";
    case Code::sigma_output_replaced:
      return "the constant given for the output's uncertainty takes the place of the record's sigma_E";
    case Code::uncertainties_taken:
      return "standard errors take the uncertainties given as they are; the residuals are {factor:.3g} times "
             "as large as these predict";
    case Code::uncertainties_scaled:
      return "standard errors take only the ratios of the uncertainties given, and are scaled by "
             "{factor:.3g}, the size of the residuals over that expected";
    case Code::total_least_squares_biased:
      return "total least squares is biased for powers and products: it assumes that the errors of all "
             "regressors are independent, of mean zero and alike in every row. The bias grows with the "
             "square of the input noise; eiv is free of it";
    case Code::independent_errors_assumed:
      return "standard errors assume errors of inputs and output that are independent from row to row and "
             "from axis to axis; errors common to many rows (radius, misalignment, speed of the stand) are "
             "not corrected";
    case Code::huber_loss:
      return "Huber's loss with k = {tuning:g}";
    case Code::bisquare_loss:
      return "Tukey's bisquare loss with c = {tuning:g}";
    case Code::student_loss:
      return "likelihood of Student's t with {tuning:.4g} {tuning:?degree|degrees} of freedom ({origin}) and "
             "scale {scale:.5g} {unit}";
    case Code::outlying_rows:
      return "{count:.0f} of {total:.0f} rows {count:?lies|lie} beyond {limit:g} robust scales; the robust "
             "scale (median absolute residual / 0.6745) is {scale:.5g} {unit}";
    case Code::scale_at_resolution:
      return "the output lies on a grid with a step of {step:.5g} {unit}, and more than half of the "
             "residuals are smaller than its rounding ({rounding:.3g} {unit}, step / sqrt(12)). The robust "
             "scale takes every residual as spread over one step; otherwise rows one step away would count "
             "as outliers";
    case Code::scale_at_rounding:
      return "more than half of the residuals are no more than rounding; the robust scale is held at "
             "{scale:.2g} {unit}";
    case Code::scale_doubtful:
      return "the robust scale cannot be trusted: it is {over_shortest_half:.3g} times that of the half of "
             "the residuals that lie closest together, and the 60 % quantile gives {quantile_ratio:.3g} "
             "times the scale (both are near 1 in a sound fit). Nearly half of the rows may be outliers, or "
             "the rows fall into two groups: the fit, its standard errors and the list of suspect rows may "
             "be wrong. Plot the residuals, and split the record or leave the bad rows out";
    case Code::robust_errors_asymptotic:
      return "standard errors are asymptotic (Huber 1981); they assume exact inputs and independent output "
             "noise with one symmetric distribution in every row; the residual standard deviation counts "
             "outliers in full";
    case Code::terms_chosen:
      return "{count:.0f} of {total:.0f} terms chosen by {criterion} (root mean square {value:.6g} {unit}): "
             "{terms}";
    case Code::choice_taken_as_given:
      return "coefficients are those of ordinary least squares with the chosen terms on all training rows. "
             "Their standard errors take the choice as given and leave out its uncertainty: a coefficient "
             "left out is small, not known to be zero";
    case Code::layers_grown:
      return "a network of quadratic neurons from {inputs:.0f} {inputs:?input|inputs}, the best of layer "
             "{layer:.0f}, chosen by {criterion} (root mean square {value:.6g} {unit})";
    case Code::layers_expanded:
      return "over the training rows the rms error of the network is {network:.4g} {unit}, that of its "
             "expansion into the terms, which predicts, {expansion:.4g} {unit}";
    case Code::layers_beyond_terms:
      return "the part of the network outside the 21 terms is {beyond_all:.4g} {unit} (rms over the training "
             "rows), outside the terms asked for {beyond_asked:.4g} {unit}";
    case Code::layers_without_errors:
      return "coefficients of a network of quadratics have no standard errors; those of form combi have";
    case Code::layers_short_of_optimum:
      return "the expansion's rms error over the training rows is {ratio:.3g} times that of least squares on "
             "the same terms, and its coefficients are worse accordingly. Use ols, or form combi";
    case Code::pairs_discarded:
      return "{count:.0f} {count:?pair|pairs} of inputs gave no neuron, because the rows cannot tell apart "
             "its six regressors; {total:.0f} {total:?pair|pairs} gave one";
    case Code::search_short_of_optimum:
      return "the search ends {distance:.2g} standard errors of least squares from its solution in {terms} "
             "(the farthest coefficient), with {ratio:.6g} times its root mean square residual; ols reaches "
             "that solution directly";
    case Code::search_errors_added:
      return "standard errors are those of least squares (exact inputs, white output noise of the same "
             "variance in every row) with the distance from its solution added in quadrature; the search "
             "itself has none";
    case Code::coefficients_projected:
      return "coefficients are the least-squares projection of the network onto the terms";
    case Code::coefficients_expanded:
      return "coefficients are the network's Taylor expansion at zero specific force: they have no standard "
             "errors, and third-order terms are far less certain than by projection";
    case Code::expansion_differs:
      return "Taylor expansion and projection differ by more than three standard errors in {terms}";
    case Code::network_misfit:
      return "the network's residual standard deviation is {ratio:.3g} times that of least squares with "
             "every term that the rows can separate: this is misfit, not white noise, so standard errors, "
             "intervals, t and p do not hold. Use more hidden units or more starts, or least squares";
    case Code::network_above_rounding:
      return "the network leaves more than rounding, which is all that least squares with every term that "
             "the rows can separate leaves: this is misfit, not white noise, so standard errors, intervals, "
             "t and p do not hold";
    case Code::network_moves_coefficients:
      return "the network's misfit moves the coefficients by {induced:.3g} {unit} (rms over the rows), more "
             "than noise does ({typical:.3g} {unit}): the standard errors hold that difference. More hidden "
             "units, or "
             "least squares, come closer";
    case Code::network_errors_compared:
      return "standard errors are those of least squares with the same terms on the same rows, and beside "
             "them the difference of the two coefficients, which shows what the network cannot represent; "
             "they "
             "assume exact inputs and white noise of one variance";
    case Code::structure_beyond_terms:
      return "the record has structure that the terms asked for lack, from the sensor or from the stand. A "
             "network beside the terms predicts it. The coefficients are the least-squares projection of "
             "terms and network together onto the terms, over the rows of the record; between these rows "
             "the output may differ from what the coefficients alone give";
    case Code::hidden_choice_ignored:
      return "standard errors assume exact inputs and white noise of one variance, and ignore that the "
             "number of hidden units was chosen on the same rows";
    case Code::inputs_in_other_unit:
    case Code::inputs_are_angles:
    case Code::inputs_too_large:
    case Code::input_far_off:
    case Code::magnitude_unlike_others:
    case Code::rows_shifted:
    case Code::output_unsigned:
    case Code::output_copies_input:
    case Code::output_clipped:
    case Code::output_saturated:
    case Code::output_held:
    case Code::output_stuck:
    case Code::output_repeated:
    case Code::output_wrapped:
    case Code::rows_duplicated:
    case Code::time_backwards:
    case Code::time_standing:
    case Code::temperature_implausible:
    case Code::scale_factor_negative:
    case Code::scale_factor_unlike_one:
    case Code::cross_axis_larger:
    case Code::cross_axis_large:
    case Code::few_degrees_of_freedom:
    case Code::gross_misfit:
    case Code::rows_far_off:
    case Code::model_too_short:
    case Code::residuals_follow_time:
    case Code::residuals_follow_temperature:
    case Code::residuals_follow_order:
    case Code::residuals_follow_mount:
    case Code::residuals_follow_inputs:
    case Code::scale_factor_follows_time:
    case Code::scale_factor_follows_temperature:
    case Code::scale_factor_follows_order:
    case Code::scale_factor_follows_mount:
    case Code::alignment_follows_mount:
    case Code::residuals_correlated:
    case Code::sigma_inputs_unused:
    case Code::sigma_output_uneven:
    case Code::output_far_off:
    case Code::sigma_output_far_off:
    case Code::square_larger:
      return english_diagnosis(code);
    case Code::inputs_outside_range:
      return "{count:.0f} of {total:.0f} rows {count:?lies|lie} outside the range that the result was "
             "identified on (first: line {line:.0f}): the prediction is an extrapolation there";
    case Code::other_plan_named:
      return "the record says that it was simulated from {named}, the truth is {plan}: the distances from "
             "the truth may mean nothing. Give the record's own plan";
    case Code::inputs_unlike_plan:
      return "the record's accelerations are from {least:.4g} to {largest:.4g} g, those of the truth's plan "
             "from {from:.4g} to {to:.4g} g";
    case Code::outputs_unlike_plan:
      return "the record's outputs lie {ratio:.3g} times as far from the truth's as its noise explains (by "
             "the median over the rows): the truth may belong to another record, and the distances from it "
             "then mean nothing. Give the plan that the record was simulated from";
  }
  return "";
}

// Of a scale that nothing speaks against, on too few rows to know.
constexpr std::string_view kScaleOfFewRows =
    "the robust scale can hardly be checked with {spare:.0f} {spare:?row|rows} more than terms: if many "
    "rows are outliers, the fit, its standard errors and the list of suspect rows may be wrong without a "
    "warning. Measure at least {enough:.0f} rows more than terms";

// Words of a finding that are names of a choice.
std::string_view phrase(std::string_view figure, std::string_view word) noexcept {
  if (figure == "criterion") {
    if (word == "press") return "PRESS over {rows:.0f} rows";
    if (word == "regularity") return "regularity on {second:.0f} checking rows of {rows:.0f}";
    if (word == "unbiasedness") return "unbiasedness of halves of {first:.0f} and {second:.0f} rows";
  }
  if (figure == "origin") {
    if (word == "given") return "given";
    if (word == "default") return "by default";
    if (word == "estimated") return "estimated";
  }
  return english_diagnosis_phrase(figure, word);
}

}  // namespace

std::string_view english_template(Code code) noexcept { return sentence(code); }
std::string_view english_scale_of_few_rows() noexcept { return kScaleOfFewRows; }
std::string_view english_phrase(std::string_view figure, std::string_view word) noexcept {
  return phrase(figure, word);
}

std::string english(const Finding& finding) {
  const bool few_rows = finding.code == Code::scale_doubtful && has_figure(finding, "spare");
  const std::string_view words = few_rows ? kScaleOfFewRows : sentence(finding.code);
  if (!words.empty()) return filled(words, finding, phrase);
  std::string text = join_names({finding.terms.begin(), finding.terms.begin() + !finding.terms.empty()}) +
                     " is not identified: " + english_reason(finding);
  const bool aliased = finding.code == Code::term_aliased || finding.code == Code::term_hidden_by_rounding ||
                       finding.code == Code::term_hidden_by_uncertainty;
  if (!aliased || finding.terms.size() < 2) return text;
  return text + "; whatever it contributes is in the value of " +
         join_names({finding.terms.begin() + 1, finding.terms.end()});
}

}  // namespace proofmass
