// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/identifiability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "proofmass/core/error.hpp"
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

std::string zero_reason(Term term, const Dataset& data, const AxisRanges& ranges) {
  for (const Axis axis : kAxes) {
    if (info(term).uses(axis) && !data.has(axis)) {
      return fmt::format("the record has no column {}", axis_name(axis));
    }
  }
  for (const Axis axis : kAxes) {
    if (info(term).uses(axis) && ranges[static_cast<std::size_t>(axis)] == 0.0) {
      return fmt::format("{} is zero in every row", axis_name(axis));
    }
  }
  return fmt::format("{} is zero in every row", info(term).product);
}

std::string confounded_reason(Term term, const TermList& others) {
  const auto product = info(term).product;
  if (others == TermList{Term::K0}) {
    return fmt::format("confounded with K0: {} is the same in every row", product);
  }
  if (others.size() == 1) {
    return fmt::format("confounded with {}: over these rows {} is proportional to {}", join_names(others),
                       product, info(others.front()).product);
  }
  std::string products;
  for (const Term other : others)
    products += fmt::format("{}{}", products.empty() ? "" : ", ", info(other).product);
  return fmt::format("confounded with {}: over these rows {} is a combination of {}", join_names(others),
                     product, products);
}

std::string loss_reason(const Unidentifiable& lost, const Dataset& data, const AxisRanges& ranges) {
  if (lost.confounded_with.empty()) return zero_reason(lost.term, data, ranges);
  return confounded_reason(lost.term, lost.confounded_with);
}

// The terms other than `lost` that the vanishing combination holds.
TermList support(const std::vector<double>& combination, const TermList& terms, Term lost, double threshold) {
  TermList others;
  for (std::size_t c = 0; c < terms.size(); ++c) {
    if (terms[c] != lost && std::abs(combination[c]) > threshold) others.push_back(terms[c]);
  }
  std::sort(others.begin(), others.end());
  return others;
}

std::string loss_message(const Dataset& data, const TermList& terms, const Identifiability& found) {
  std::string message =
      fmt::format("{}: the inputs cannot identify {} of the {} terms asked for:", data.source,
                  found.lost.size(), terms.size());
  for (const auto& lost : found.lost) message += fmt::format("\n  {}: {}", name(lost.term), lost.reason);
  return message + "\nFit without them, ask for fewer terms, or test in more mounts.";
}

void require_rows(const Dataset& data, const TermList& terms) {
  const std::size_t needed = terms.size() + 1;
  if (data.rows() >= needed) return;
  throw bad_data({.file = data.source, .row = 0, .column = {}}, fmt::format("{} rows to fit", data.rows()),
                 fmt::format("at least {}, one more than the {} terms asked for ({})", needed, terms.size(),
                             join_names(terms)),
                 {{"terms", ""}});
}

// Beyond these, squares and cubes leave the range of double precision and take standard errors with them.
constexpr double kLargestAcceleration = 1e40;  // g
constexpr double kLargestOutput = 1e100;

void require_rows_up_to(double limit, const Dataset& record, const std::vector<double>& values,
                        std::string_view column) {
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::abs(values[row]) <= limit) continue;
    throw bad_data({.file = record.source,
                    .row = record.line.empty() ? row + 1 : record.line[row],
                    .column = std::string(column)},
                   fmt::format("{}", values[row]), fmt::format("a value of at most {:.0g} in size", limit));
  }
}

void require_size(double largest, double limit, const Dataset& data, std::string_view column) {
  if (largest == 0.0 || (largest <= limit && largest >= 1.0 / limit)) return;
  throw bad_data({.file = data.source, .row = 0, .column = std::string(column)},
                 fmt::format("values up to {:.3g}", largest),
                 fmt::format("values whose largest is between {:.0g} and {:.0g}", 1.0 / limit, limit));
}

void require_varying_output(const TermSums& sums) {
  const std::size_t output = sums.terms().size();
  const double least = sums.gram().least(output);
  if (least < sums.gram().greatest(output)) return;
  throw bad_data({.file = sums.data().source, .row = 0, .column = "E"}, fmt::format("{} in every row", least),
                 "an output that varies with the input");
}

}  // namespace

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

Identifiability analyse_identifiability(const TermSums& sums, const TermList& terms) {
  const TermList ordered = lower_orders_first(terms);
  const Dataset& data = sums.data();
  const AxisRanges ranges = without_rounding(sums.ranges());
  GramMatrix gram = sums.gram(ordered);
  clear_rounding(gram, ordered, ranges);
  const RankAnalysis analysis = analyse_rank(gram);

  Identifiability result{.identified = {},
                         .lost = {},
                         .condition_raw = analysis.condition_raw,
                         .condition_scaled = analysis.condition_scaled};
  // Rounding in a combination's elements grows with the condition of the columns it is made of.
  const double threshold = std::max(1e-12, kRoundingZero * analysis.condition_scaled);
  for (std::size_t c = 0, next_lost = 0; c < ordered.size(); ++c) {
    const Term term = ordered[c];
    if (std::binary_search(analysis.independent.begin(), analysis.independent.end(), c)) {
      result.identified.push_back(term);
      continue;
    }
    const auto& combination = analysis.null_space[next_lost++];
    Unidentifiable lost{
        .term = term, .confounded_with = support(combination, ordered, term, threshold), .reason = {}};
    lost.reason = analysis.rank == data.rows() && !lost.confounded_with.empty()
                      ? fmt::format("{} rows settle no more than {} terms", data.rows(), data.rows())
                      : loss_reason(lost, data, ranges);
    result.lost.push_back(std::move(lost));
  }
  std::sort(result.identified.begin(), result.identified.end());
  std::sort(result.lost.begin(), result.lost.end(),
            [](const auto& a, const auto& b) { return a.term < b.term; });
  return result;
}

Identifiability require_identifiable(const Dataset& data, const TermList& terms, RankLossPolicy policy) {
  return require_identifiable(TermSums(data, terms), policy);
}

Identifiability require_identifiable(const TermSums& sums, RankLossPolicy policy) {
  if (sums.terms().empty()) throw usage_error("no terms to identify; ask for at least one");
  require_plausible_sizes(sums);
  require_rows(sums.data(), sums.terms());
  require_varying_output(sums);
  Identifiability found = analyse_identifiability(sums, sums.terms());
  const bool refused = policy == RankLossPolicy::refuse ? !found.lost.empty() : found.identified.empty();
  if (refused) {
    throw refusal(loss_message(sums.data(), sums.terms(), found), {{"on-rank-loss", "drop"}, {"terms", ""}});
  }
  return found;
}

}  // namespace proofmass
