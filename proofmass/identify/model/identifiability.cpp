// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/identifiability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/input_errors.hpp"
#include "proofmass/numeric/linear/rank_analysis.hpp"

namespace proofmass {
namespace {

// What a computed zero leaves: a mount at 90 degrees gives its other axis 70 g * cos(pi/2) = 4e-15 g.
constexpr double kRoundingZero = 64.0 * std::numeric_limits<double>::epsilon();

TermList lower_orders_first(TermList terms) {
  std::stable_sort(terms.begin(), terms.end(),
                   [](Term a, Term b) { return info(a).order() < info(b).order(); });
  return terms;
}

// Zero for an axis that holds nothing but rounding beside the others.
AxisRanges without_rounding(AxisRanges ranges) {
  const double overall = *std::max_element(ranges.begin(), ranges.end());
  for (double& range : ranges) range = range > kRoundingZero * overall ? range : 0.0;
  return ranges;
}

// Makes columns zero that are so but for rounding; scaling to unit length would blow rounding up to a
// regressor.
void clear_rounding(GramMatrix& gram, const TermList& terms, const AxisRanges& ranges) {
  for (std::size_t c = 0; c < terms.size(); ++c) {
    if (!std::isnormal(gram.scales()[c])) throw std::invalid_argument("a regressor overflows");
    const double attainable = std::abs(regressor(terms[c], {.i = ranges[0], .o = ranges[1], .p = ranges[2]}));
    const double largest = std::max(-gram.least(c), gram.greatest(c)) / gram.scales()[c];
    if (largest <= kRoundingZero * attainable || attainable == 0.0) gram.clear(c);
  }
}

// Of a term whose regressor is zero in every row.
Finding zero_finding(Term term, const Dataset& data, const AxisRanges& ranges) {
  for (const Axis axis : kAxes) {
    if (info(term).uses(axis) && !data.has(axis)) {
      return {.code = Code::term_without_column,
              .terms = {term},
              .figures = {{"column", std::string(axis_name(axis))}}};
    }
  }
  std::string_view zero = info(term).product;
  for (const Axis axis : kAxes) {
    if (info(term).uses(axis) && ranges[static_cast<std::size_t>(axis)] == 0.0) {
      zero = axis_name(axis);
      break;
    }
  }
  return {.code = Code::term_input_zero, .terms = {term}, .figures = {{"product", std::string(zero)}}};
}

// Elements of a combination, of unit length, that rounding of the inputs cannot have made.
constexpr double kNoticeable = 0.01;

// Of the axes that the term uses, in g; of all axes for K0.
double largest_of(Term term, const Dataset& data, const std::array<double, 3>& by_axis) {
  double largest = 0.0;
  for (const Axis axis : data.axes()) {
    if (info(term).uses(axis) || info(term).order() == 0)
      largest = std::max(largest, by_axis[static_cast<std::size_t>(axis)]);
  }
  return largest;
}

// Names what hides the difference: the larger of rounding, whose standard deviation is that of a uniform
// distribution, and uncertainty.
Finding hidden_finding(TermList terms, const Dataset& data, const std::array<double, 3>& uncertainties) {
  const double step = largest_of(terms.front(), data, data.acceleration_resolution);
  const double sigma = largest_of(terms.front(), data, uncertainties);
  if (sigma > step / std::sqrt(12.0)) {
    return {
        .code = Code::term_hidden_by_uncertainty, .terms = std::move(terms), .figures = {{"sigma", sigma}}};
  }
  return {.code = Code::term_hidden_by_rounding, .terms = std::move(terms), .figures = {{"step", step}}};
}

// The terms other than `term` that the vanishing combination holds.
TermList support(const std::vector<double>& combination, const TermList& terms, Term term, double threshold) {
  TermList others;
  for (std::size_t c = 0; c < terms.size(); ++c) {
    if (terms[c] != term && std::abs(combination[c]) > threshold) others.push_back(terms[c]);
  }
  std::sort(others.begin(), others.end());
  return others;
}

// Why the term of column c is not identified, by the combination of columns that vanishes.
Finding unidentified(std::size_t c, const RankAnalysis& analysis, const std::vector<double>& combination,
                     const TermList& terms, const Dataset& data, const AxisRanges& ranges,
                     const std::array<double, 3>& uncertainties) {
  const Term term = terms[c];
  const bool hidden = std::find(analysis.hidden.begin(), analysis.hidden.end(), c) != analysis.hidden.end();
  // Rounding in a combination's elements grows with the condition of the columns it is made of.
  const double threshold = hidden ? kNoticeable : std::max(1e-12, kRoundingZero * analysis.condition_scaled);
  TermList aliased = support(combination, terms, term, threshold);
  if (aliased.empty() && !hidden) return zero_finding(term, data, ranges);
  aliased.insert(aliased.begin(), term);
  if (hidden) return hidden_finding(std::move(aliased), data, uncertainties);
  if (analysis.rank == data.rows())
    return {.code = Code::term_beyond_rows, .terms = std::move(aliased), .figures = {{"rows", data.rows()}}};
  return {.code = Code::term_aliased, .terms = std::move(aliased)};
}

Error not_identifiable(const Dataset& data, const TermList& terms, Identifiability found) {
  TermList names;
  for (const Finding& finding : found.unidentified) names.push_back(finding.terms.front());
  return refusal(
      message("{}: the inputs cannot identify {} of the {} asked for: {}. Fit without "
              "them, ask for fewer terms, or test in more mounts",
              data.source, names.size(), amount_of(terms.size(), "term", "terms"), join_names(names)),
      terms_remedies(found.identified), std::move(found.unidentified));
}

void require_rows(const Dataset& data, const TermList& terms) {
  const std::size_t needed = terms.size() + 1;
  if (data.rows() >= needed) return;
  throw bad_data({.file = data.source, .row = 0, .column = {}},
                 message("{} to fit", amount_of(data.rows(), "row", "rows")),
                 message("at least {}, one more than the {} asked for ({})", needed,
                         amount_of(terms.size(), "term", "terms"), join_names(terms)),
                 {{"terms", ""}});
}

// Beyond these, squares and cubes leave the range of double precision and take standard errors with them.
constexpr double kLargestAcceleration = 1e40;  // g
constexpr double kLargestOutput = 1e100;

void require_rows_up_to(double limit, const Dataset& record, const std::vector<double>& values,
                        std::string_view column) {
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::abs(values[row]) <= limit) continue;
    throw bad_data({.file = record.source, .row = record.line_of(row), .column = std::string(column)},
                   fmt::format("{}", values[row]), message("a value of at most {:.0g} in size", limit));
  }
}

void require_size(double largest, double limit, const Dataset& data, std::string_view column) {
  if (largest == 0.0 || (largest <= limit && largest >= 1.0 / limit)) return;
  throw bad_data({.file = data.source, .row = 0, .column = std::string(column)},
                 message("values up to {:.3g}", largest),
                 message("values whose largest is between {:.0g} and {:.0g}", 1.0 / limit, limit));
}

void require_varying_output(const TermSums& sums) {
  const std::size_t output = sums.terms().size();
  const double least = sums.gram().least(output);
  if (least < sums.gram().greatest(output)) return;
  throw bad_data({.file = sums.data().source, .row = 0, .column = "E"}, message("{} in every row", least),
                 "an output that varies with the input");
}

}  // namespace

std::vector<Remedy> terms_remedies(const TermList& identified) {
  if (identified.empty()) return {};
  std::string names;
  for (const Term term : identified) names.append(names.empty() ? "" : ",").append(name(term));
  return {{"on-rank-loss", "drop"}, {"terms", names}};
}

void sort_by_term(std::vector<Finding>& findings) {
  std::sort(findings.begin(), findings.end(),
            [](const Finding& a, const Finding& b) { return a.terms.front() < b.terms.front(); });
}

void require_plausible_rows(const Dataset& record) {
  for (const Axis axis : record.axes()) {
    require_rows_up_to(kLargestAcceleration, record, record.along(axis), axis_name(axis));
  }
  require_rows_up_to(kLargestOutput, record, record.output, "E");
}

void require_plausible_sizes(const TermSums& sums) {
  for (const Axis axis : sums.data().axes()) {
    require_size(sums.ranges()[static_cast<std::size_t>(axis)], kLargestAcceleration, sums.data(),
                 axis_name(axis));
  }
  if (sums.data().rows() == 0) return;
  const std::size_t output = sums.terms().size();
  require_size(std::max(-sums.gram().least(output), sums.gram().greatest(output)), kLargestOutput,
               sums.data(), "E");
}

Identifiability analyse_identifiability(const Dataset& data, const TermList& terms) {
  return analyse_identifiability(TermSums(data, terms), terms);
}

Identifiability analyse_identifiability(const TermSums& sums, const TermList& terms,
                                        std::optional<double> input_sigma) {
  const TermList ordered = lower_orders_first(terms);
  const Dataset& data = sums.data();
  const AxisRanges ranges = without_rounding(sums.ranges());
  GramMatrix gram = sums.gram(ordered);
  clear_rounding(gram, ordered, ranges);
  const std::array<double, 3> uncertainties = input_uncertainties(data, input_sigma);
  const auto errors = input_error_products(data, ordered, uncertainties);
  const RankAnalysis analysis = errors ? analyse_rank(gram, *errors) : analyse_rank(gram);

  Identifiability result{.identified = {},
                         .unidentified = {},
                         .condition_raw = analysis.condition_raw,
                         .condition_scaled = analysis.condition_scaled};
  for (std::size_t c = 0, next = 0; c < ordered.size(); ++c) {
    if (std::binary_search(analysis.independent.begin(), analysis.independent.end(), c)) {
      result.identified.push_back(ordered[c]);
    } else {
      result.unidentified.push_back(
          unidentified(c, analysis, analysis.null_space[next++], ordered, data, ranges, uncertainties));
    }
  }
  std::sort(result.identified.begin(), result.identified.end());
  sort_by_term(result.unidentified);
  return result;
}

Identifiability require_identifiable(const Dataset& data, const TermList& terms, RankLossPolicy policy,
                                     std::optional<double> input_sigma) {
  return require_identifiable(TermSums(data, terms), policy, input_sigma);
}

Identifiability require_identifiable(const TermSums& sums, RankLossPolicy policy,
                                     std::optional<double> input_sigma) {
  if (sums.terms().empty()) throw usage_error("no terms to identify; ask for at least one");
  require_plausible_sizes(sums);
  require_rows(sums.data(), sums.terms());
  require_varying_output(sums);
  Identifiability found = analyse_identifiability(sums, sums.terms(), input_sigma);
  const bool refused =
      policy == RankLossPolicy::refuse ? !found.unidentified.empty() : found.identified.empty();
  if (refused) {
    throw not_identifiable(sums.data(), sums.terms(), std::move(found));
  }
  return found;
}

}  // namespace proofmass
