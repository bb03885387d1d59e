// SPDX-License-Identifier: Apache-2.0
// Faults of a record and of a fit: cause, consequence, remedy.
#include "proofmass/report/text/en_diagnosis.hpp"

#include <array>

#include "proofmass/report/text/templates_internal.hpp"

namespace proofmass {
namespace {

constexpr std::string_view kRows =
    "a few rows are far off, the others are not. Use the method robust, and look at the rows that it "
    "suspects";
constexpr std::string_view kMixed =
    "the inputs or the outputs of some rows are in another unit than those of the others (a ratio of 9.8, "
    "or of 1000). Convert them to one";
constexpr std::array kPhrases{
    NamedPhrase{"hint", "output_si", "the output seems to be in m/s². State its unit: E[m/s^2]"},
    NamedPhrase{"hint", "inputs_si", "the inputs seem to be in m/s². State their unit: Ai[m/s^2]"},
    NamedPhrase{"hint", "output_milli", "the output seems to be in mg. State its unit: E[mg]"},
    NamedPhrase{"hint", "inputs_milli", "the inputs seem to be in mg. State their unit: Ai[mg]"},
    NamedPhrase{"hint", "output_micro", "the output seems to be in ug. State its unit: E[ug]"},
    NamedPhrase{"hint", "output_milli_si", "the output seems to be in mm/s². State its unit: E[mm/s^2]"},
    NamedPhrase{"hint", "output_gal", "the output seems to be in Gal. State its unit: E[Gal]"},
    NamedPhrase{"hint", "inputs_gal", "the inputs seem to be in Gal. State their unit: Ai[Gal]"},
    NamedPhrase{"hint", "output_milli_inputs_si",
                "the output seems to be in mg and the inputs in m/s². State the units: E[mg], Ai[m/s^2]"},
    NamedPhrase{"hint", "turned",
                "with Ko = {ko:.4g} and Kp = {kp:.4g} g/g it is that of an instrument turned by {angle:.3g} "
                "degrees from the axes of the record, or of outputs that stand beside the inputs of another "
                "position. Turn the inputs by that angle, or move the outputs to their own rows"},
    NamedPhrase{"hint", "mixed", kMixed},
    NamedPhrase{"hint", "rows", kRows},
    NamedPhrase{"hint", "undeclared", "no unit is declared for E, and g is assumed. State it, as in E[V]"},
    NamedPhrase{"hint", "declared",
                "the unit of E or of the inputs is not what the record says, or the wrong column is read"},
    NamedPhrase{"reason", "terms",
                "terms of the static model that are left out explain most of it. Ask for the model full, and "
                "drop the terms that are not identifiable"},
    NamedPhrase{"reason", "rows",
                "a few rows are far off, the others are not{named}. Correct or leave out what is wrong, or "
                "use the method robust, and look at the rows that it suspects"},
    NamedPhrase{"named", "lines", ": {count:?line|lines} {lines}"},
    NamedPhrase{"reason", "mixed",
                "the inputs or the outputs of some rows are in another unit than those of the others, or "
                "of another scale (a ratio of 9.8, or of 1000). The coefficients mean nothing as they are. "
                "Convert the rows to one unit; of those along the input axis they are {count:?line|lines} "
                "{lines}"},
    NamedPhrase{
        "reason", "unrelated",
        "the output hardly depends on the inputs. The wrong column is read, or rows are in another order"},
    NamedPhrase{"reason", "unknown",
                "the inputs explain part of the output only. Plot the output against each input"},
    NamedPhrase{"direction", "below", "below their inputs. Move the column of the outputs up by as many"},
    NamedPhrase{"direction", "above", "above their inputs. Move the column of the outputs down by as many"},
    NamedPhrase{"shape", "step",
                "as if the output jumped by {change:.3g} {unit} where {axis} changes its sign"},
    NamedPhrase{
        "shape", "slope",
        "as if the response to {axis} differed by {change:.3g} {unit}/g between positive and negative "
        "{axis}"},
    NamedPhrase{"shape", "direction",
                "as if the output differed by {change:.3g} {unit} between rows to which {axis} has risen "
                "and rows to which it has fallen"},
    NamedPhrase{"shape", "other", "by another amount in each part of its range"},
    NamedPhrase{"course", "gradual",
                "over the record they change by {change:.3g} {unit}, {errors:.3g} standard errors (noise "
                "{scale:.3g} {unit}). If the rows are in the order of the test this is a drift, which moves "
                "the coefficients: leave the warm-up out, or repeat a reference position and take the drift "
                "off the output"},
    NamedPhrase{"course", "jump",
                "from line {first:.0f} on they lie {change:.3g} {unit} from those before, {errors:.3g} "
                "standard errors (noise {scale:.3g} {unit}). The bias has changed there, or the mounting: "
                "this moves the coefficients. Identify the parts of the record apart, or repeat a reference "
                "position in each and take the difference off the output"},
    NamedPhrase{"course", "stretch",
                "from line {first:.0f} to line {last:.0f} they lie {change:.3g} {unit} from the others, "
                "{errors:.3g} standard errors (noise {scale:.3g} {unit}). These rows are of another "
                "mounting, or of another instrument, and move the coefficients. Identify them apart, or "
                "leave them out"},
    NamedPhrase{"course", "factor_gradual",
                "over the record Ki changes by {change:.3g} {unit}, {errors:.3g} standard errors. If the "
                "rows are in the order of the test the scale factor drifts: wait until the instrument is "
                "warm, or split the record and identify the parts"},
    NamedPhrase{"course", "factor_jump",
                "from line {first:.0f} on Ki differs by {change:.3g} {unit} from that before, {errors:.3g} "
                "standard errors. The gain, the range of the readout or the instrument has changed there, "
                "and Ki is an average. Identify the parts of the record apart"},
    NamedPhrase{"course", "factor_stretch",
                "from line {first:.0f} to line {last:.0f} Ki differs by {change:.3g} {unit} from that of "
                "the other rows, {errors:.3g} standard errors. The gain was another in these rows, or they "
                "are of another instrument, and Ki is an average. Identify them apart, or leave them out"},
    NamedPhrase{
        "magnitudes", "all_axes",
        "|A| is {least:.5g} to {largest:.5g} in every row and was read in {read}: it looks like 1 g in "
        "{written}. Every coefficient is then wrong by powers of the ratio. State the unit in the "
        "header, as in Ai[{written}]"},
    NamedPhrase{"magnitudes", "one_axis",
                "the largest |Ai|, {largest:.5g} both ways, was read in {read}: it looks like 1 g in "
                "{written}. Every coefficient is then wrong by powers of the ratio. State the unit in the "
                "header, as in Ai[{written}]"},
    NamedPhrase{"magnitudes", "one_of_axes",
                "{axis} was read in {read}, and seems to be in {written}: |A| has {after:.0f} "
                "{after:?value|values} over the record if it is, and {before:.0f} if it is not. Every "
                "coefficient of {axis} is then wrong by powers of the ratio. State the unit in the header, "
                "as in {axis}[{written}]"},
    NamedPhrase{"size", "power", "2^{bits:.0f} = {turn:.0f}"},
    NamedPhrase{"size", "other", "{turn:.7g} {unit}"},
    NamedPhrase{"within", "rows",
                "of neighbouring rows are correlated ({correlation:.2f}, {errors:.3g} standard errors): the "
                "output wanders, or terms are missing"},
    NamedPhrase{
        "within", "mounts",
        "of neighbouring rows are correlated ({correlation:.2f}, {errors:.3g} standard errors) within "
        "mounts, and not from one mount to the next: errors of the stand (alignment, radius, fixture) "
        "have this effect"},
    NamedPhrase{"weight", "none", "counts for nothing"},
    NamedPhrase{"weight", "all", "decides alone about the coefficients"},
    NamedPhrase{"which", "largest", "largest"},
    NamedPhrase{"which", "smallest", "smallest"}};

}  // namespace

std::span<const NamedPhrase> english_diagnosis_phrases() noexcept { return kPhrases; }

std::string_view english_diagnosis(Code code) noexcept {
  switch (code) {
    case Code::inputs_in_other_unit:
      return "{magnitudes}";
    case Code::inputs_are_angles:
      return "the outputs follow the {function} of the inputs read as angles in {written}, and not the "
             "inputs: they are angles of a dividing head. The coefficients mean nothing as they are. Give "
             "the {function} of the angle, times local gravity, as Ai";
    case Code::inputs_too_large:
      return "the accelerations go up to {largest:.3g} g (read in {read}), and no test stand for "
             "accelerometers makes more than {limit:g} g: they are in another unit, or the wrong columns "
             "are read. State the unit in the header, as in Ai[ug]";
    case Code::input_far_off:
      return "{axis} is {value:g} {unit} in line {line:.0f}, more than {limit:g} times what it is in "
             "nearly all other rows ({count:.0f} {count:?row|rows} of that kind, and nothing between): the "
             "mark of a missing value, or a slip. Such a row decides alone about the terms of {axis}. "
             "Correct it or leave it out: {count:?line|lines} {lines}";
    case Code::magnitude_unlike_others:
      return "|A| is {value:.7g} {unit} in line {line:.0f}, and {others:.7g} {unit} in nearly all other "
             "rows ({count:.0f} {count:?row is|rows are} unlike them): an input is probably mistyped "
             "there. Such a row can decide alone about terms that the others do not tell apart, whose "
             "values are then wrong by any amount. Correct the inputs or leave the {count:?row|rows} out: "
             "{count:?line|lines} {lines}";
    case Code::rows_shifted:
      return "the outputs follow the inputs of other rows: they stand {shift:.0f} {shift:?row|rows} "
             "{direction}. The coefficients mean nothing as they are";
    case Code::output_unsigned:
      return "the outputs have one sign, and follow the inputs closely if those with negative Ai are "
             "turned round: the meter or the file has lost their sign. The coefficients mean nothing as "
             "they are. Record the outputs with their sign";
    case Code::output_copies_input:
      return "the outputs equal {axis} in every row: one column is a copy of the other, and the "
             "coefficients say nothing of an instrument. Name the column of the outputs";
    case Code::output_clipped:
      return "{count:.0f} rows with different inputs have exactly the {which} output, {value:.8g} {unit}: "
             "the output is clipped there, and coefficients that fit it are wrong. Leave these rows out, or "
             "widen the range of the meter: lines {lines}";
    case Code::output_saturated:
      return "the outputs end at {value:.6g} {unit}, although the inputs of {count:.0f} rows ask for up to "
             "{expected:.6g} {unit} (by the other rows): the output saturates or folds back there, and "
             "coefficients that fit it are wrong. Leave these rows out, or widen the range of the meter: "
             "lines {lines}";
    case Code::output_stuck:
      return "the output stays within {spread:.3g} {unit} of {value:.8g} {unit} in {longest:.0f} rows in "
             "sequence (lines {first:.0f} to {last:.0f}) while the inputs ask for a change of "
             "{expected:.3g} {unit}: the output is stuck, and coefficients that fit it are wrong. Leave "
             "these rows out";
    case Code::output_repeated:
      return "{count:.0f} rows with different inputs have exactly the same output, {value:.8g} {unit}: a "
             "reading that is missing or was not renewed, and coefficients that fit it are wrong. Leave "
             "these rows out: lines {lines}";
    case Code::output_held:
      return "the output repeats from row to row {repeats:.0f} times while the inputs change (longest: "
             "{longest:.0f} rows at {value:.8g} {unit}, lines {first:.0f} to {last:.0f}): the output is "
             "stuck or held, and coefficients that fit it are wrong. Leave these rows out, or read the meter "
             "once a row";
    case Code::output_wrapped:
      return "the outputs jump, in the order of their Ai, and follow the inputs when whole multiples of "
             "{size} are added to {percent:.3g} % of the rows: signed counts read as unsigned, or a "
             "counter or converter that ran over. The coefficients mean nothing as they are. Read the "
             "counts as signed, widen the counter's range, or put the jumps right before identifying";
    case Code::rows_duplicated:
      return "{count:.0f} {count:?row repeats|rows repeat} an earlier row, inputs and output (line "
             "{first:.0f} repeats line {original:.0f}): rows pasted twice count twice, and standard errors "
             "are too small. Leave the {count:?repetition out: line|repetitions out: lines} {lines}";
    case Code::time_backwards:
      return "t runs backwards in {count:.0f} of {total:.0f} rows: records joined or sorted by something "
             "else, a clock that was set, or marks in place of times. Drift cannot be judged then. Correct "
             "t, or put the rows in the order of the test: {count:?line|lines} {lines}";
    case Code::time_standing:
      return "t stands still in {count:.0f} of {total:.0f} rows: rows pasted twice, or a clock that stopped: "
             "{count:?line|lines} {lines}";
    case Code::temperature_implausible:
      return "T is {value:g} {unit} in line {line:.0f} ({count:.0f} {count:?row|rows}), more than "
             "{limit:g} {unit} from the other rows or below absolute zero: a mark for a missing reading, "
             "or another unit. Whether the residuals follow T is not judged then. Correct T, or leave the "
             "{count:?row|rows} out: {count:?line|lines} {lines}";
    case Code::scale_factor_negative:
      return "Ki is negative ({value:.6g} {unit}): the output falls while the acceleration along the input "
             "axis grows. The input axis points the other way, or the leads of the output are swapped";
    case Code::scale_factor_unlike_one:
      return "Ki is {value:.6g} g/g, far from 1: {hint}";
    case Code::cross_axis_larger:
      return "{terms} ({value:.6g} {unit}) is larger than Ki ({ki:.6g} {unit}): the columns of the axes are "
             "swapped, or the instrument is mounted along another axis than the record says. Name the "
             "columns as they are";
    case Code::square_larger:
      return "{terms} ({value:.6g} {unit}²) makes more of the output than Ki ({ki:.6g} {unit}): the output "
             "goes with the square of an input, as a power does, or a reading without its sign. The "
             "coefficients are not those of an accelerometer. Name the column of the outputs, or give the "
             "readings themselves";
    case Code::cross_axis_large:
      return "{terms} is {percent:.3g} % of Ki, as of an instrument turned by {angle:.3g}° from the axes "
             "of the record, or of outputs that stand beside the inputs of another position. Align the "
             "instrument or turn the inputs by that angle, or move the outputs to their own rows";
    case Code::few_degrees_of_freedom:
      return "{rows:.0f} rows leave {dof:.0f} {dof:?degree|degrees} of freedom: standard errors are "
             "themselves uncertain by about {percent:.0f} %, and a misfit cannot show. Use more rows, or "
             "fewer terms";
    case Code::gross_misfit:
      return "the fit does not explain the outputs (R² is {r2:.3g}): {reason}";
    case Code::model_too_short:
      return "the residuals follow {count:.0f} {count:?term|terms} that the model lacks and that the rows "
             "can identify: {terms} ({errors:.3g} standard errors). With them the residuals' standard "
             "deviation would fall from {before:.3g} to {after:.3g} {unit}; without them what they "
             "contribute is in the other coefficients too. Add them, or ask for the model full and drop "
             "what is not identifiable";
    case Code::rows_far_off:
      return "{count:.0f} {count:?row lies|rows lie} too far from the fit to be noise (line {line:.0f} by "
             "{residual:.3g} {unit}; the scale of residuals there is {scale:.3g} {unit}), and "
             "{count:?moves|move} the "
             "coefficients. Correct or leave out what is wrong, or use the method robust: "
             "{count:?line|lines} {lines}";
    case Code::residuals_follow_time:
      return "the residuals follow t: over the record they change by {change:.3g} {unit}, {errors:.3g} "
             "standard errors (noise {scale:.3g} {unit}). A drift moves the coefficients. Leave the warm-up "
             "out, or repeat a reference position through the test and take the drift off the output";
    case Code::residuals_follow_temperature:
      return "the residuals follow T: over its range they change by {change:.3g} {unit}, {errors:.3g} "
             "standard errors (noise {scale:.3g} {unit}). A drift moves the coefficients. Wait until the "
             "temperature is steady, or take its effect off the output";
    case Code::residuals_follow_order:
      return "the residuals follow the order of the rows: {course}";
    case Code::residuals_follow_mount:
      return "the residuals follow the mount, in {count:.0f} of {total:.0f} mounts: in {mount} they average "
             "{mean:.3g} {unit}, {errors:.3g} standard errors from zero. Errors of the stand (alignment, "
             "radius, fixture) have this effect. They are common to all rows of a mount, and the standard "
             "errors, which take rows for independent, are too small";
    case Code::residuals_follow_inputs:
      return "the residuals follow {axis}, beyond every term of the static model: {shape}. Their standard "
             "deviation is {before:.3g} {unit}, and {after:.3g} {unit} when this is taken off. A readout "
             "that changes its range, a dead zone or hysteresis has this effect, and the coefficients of "
             "{axis} are then averages. Check the readout, identify the parts of the range apart, or use "
             "the method hybrid";
    case Code::scale_factor_follows_time:
      return "the scale factor follows t: over the record Ki changes by {change:.3g} {unit}, {errors:.3g} "
             "standard errors. Ki is then an average over the record. Wait until the instrument is warm, or "
             "split the record and identify the parts";
    case Code::scale_factor_follows_temperature:
      return "the scale factor follows T: over its range Ki changes by {change:.3g} {unit}, {errors:.3g} "
             "standard errors. Wait until the temperature is steady, or take its effect off the output";
    case Code::scale_factor_follows_order:
      return "the scale factor follows the order of the rows: {course}";
    case Code::scale_factor_follows_mount:
      return "the scale factor differs from mount to mount, in {count:.0f} of {total:.0f} mounts: in {mount} "
             "Ki is off by {mean:.3g} {unit}, {errors:.3g} standard errors. A wrong radius of the mount has "
             "this effect, and an instrument that was changed or adjusted between mounts";
    case Code::alignment_follows_mount:
      return "the response across the input axis differs from mount to mount, in {count:.0f} of "
             "{total:.0f} mounts: in {mount} {terms} is off by {mean:.3g} {unit}, {errors:.3g} standard "
             "errors. An instrument that is not aligned in its mount has this effect (1 mrad: 1e-3 of the "
             "acceleration across). Align it, or correct the inputs of this mount by its angle";
    case Code::residuals_correlated:
      return "the residuals {within}. Standard errors take rows for independent, and are too small. Find "
             "what wanders, or judge by the errors of rows and mounts that are left out";
    case Code::sigma_inputs_unused:
      return "the columns sigma_A... are not used: {method} takes the inputs for exact. Their uncertainties "
             "explain {percent:.3g} % of the residuals' variance. eiv takes them into account";
    case Code::sigma_output_uneven:
      return "sigma_E does not go with the residuals: over the {count:.0f} rows with sigma_E of "
             "{limit:.3g} {unit} and more they are {large:.3g} times it, over the others {small:.3g} "
             "times. Weights by sigma_E favour the wrong rows, and standard errors from it are wrong. "
             "Check the unit and the rows of sigma_E";
    case Code::output_far_off:
      return "E is {value:g} {unit} in line {line:.0f}, more than {limit:g} times what it is at most in the "
             "other rows ({count:.0f} {count:?row|rows} of that kind, and nothing between): the mark of an "
             "overload or of a missing value, or a slip. Such a row decides alone about the coefficients. "
             "Correct it or leave it out: {count:?line|lines} {lines}";
    case Code::sigma_output_far_off:
      return "sigma_E is {value:.3g} {unit} in line {line:.0f}, and {others:.3g} {unit} by the median "
             "({count:.0f} {count:?row|rows} of that kind, and nothing between): the mark of a missing "
             "value, or a slip. Weighted by sigma_E such a row {weight}. Correct sigma_E, or leave the "
             "{count:?row|rows} out: {count:?line|lines} {lines}";
    default:
      return {};
  }
}

std::string_view english_diagnosis_phrase(std::string_view figure, std::string_view word) noexcept {
  for (const NamedPhrase& one : kPhrases) {
    if (one.figure == figure && one.word == word) return one.phrase;
  }
  return {};
}

}  // namespace proofmass
