// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/search/gmdh_criterion.hpp"

#include <algorithm>
#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

struct Part {
  Matrix design;
  std::vector<double> y;
  [[nodiscard]] Regression regression() const { return {.design = design, .y = y}; }
};

Part select(const Matrix& design, std::span<const double> y, std::span<const std::size_t> rows) {
  Part part{.design = Matrix(rows.size(), design.columns()), .y = std::vector<double>(rows.size())};
  for (std::size_t c = 0; c < design.columns(); ++c) {
    for (std::size_t r = 0; r < rows.size(); ++r) part.design(r, c) = design(rows[r], c);
  }
  for (std::size_t r = 0; r < rows.size(); ++r) part.y[r] = y[rows[r]];
  return part;
}

Message advice() { return message("; criterion press needs no such division"); }

std::vector<Remedy> press() { return {{"gmdh-criterion", "press"}}; }

void require_usable(const Dataset& training, const TermList& terms, std::span<const std::size_t> rows) {
  if (rows.size() <= terms.size()) {
    throw bad_data({.file = training.source, .row = 0, .column = ""}, amount_of(rows.size(), "row", "rows"),
                   message("at least {} in each part that the criterion divides the training rows into{}",
                           terms.size() + 1, advice()),
                   press());
  }
  const Identifiability part = analyse_identifiability(training.select(rows), terms);
  if (part.unidentified.empty()) return;
  throw refusal(
      message("a part of {}, which the criterion sets apart, cannot identify {}{}",
              amount_of(rows.size(), "row", "rows"), name(part.unidentified.front().terms.front()), advice()),
      press(), part.unidentified);
}

}  // namespace

GmdhRows::GmdhRows(const Dataset& training, const TermList& terms, const Gmdh& options, std::uint64_t seed)
    : kind_(options.criterion), rows_(training.rows()) {
  if (kind_ == GmdhCriterion::press) return;
  const double fraction = kind_ == GmdhCriterion::unbiasedness ? 0.5 : options.checking_fraction;
  RandomStream random(seed, stream_id("gmdh rows"));
  first_ = random_permutation(rows_, random);
  const auto checking = static_cast<std::ptrdiff_t>(std::llround(fraction * static_cast<double>(rows_)));
  second_.assign(first_.begin(), first_.begin() + checking);
  first_.erase(first_.begin(), first_.begin() + checking);
  for (auto* rows : {&first_, &second_}) {
    std::sort(rows->begin(), rows->end());
    require_usable(training, terms, *rows);
  }
}

std::unique_ptr<SubsetCriterion> GmdhRows::criterion(const Matrix& design, std::span<const double> y) const {
  if (kind_ == GmdhCriterion::press) return press_criterion({.design = design, .y = y});
  const Part first = select(design, y, first_);
  const Part second = select(design, y, second_);
  return kind_ == GmdhCriterion::regularity ? regularity_criterion(first.regression(), second.regression())
                                            : unbiasedness_criterion(first.regression(), second.regression());
}

std::span<const std::size_t> GmdhRows::fitting() const noexcept {
  if (kind_ == GmdhCriterion::regularity) return first_;
  return {};
}

std::vector<Figure> GmdhRows::figures() const {
  return {{"criterion", word_of(kGmdhCriterionWords, kind_)},
          {"rows", rows_},
          {"first", first_.size()},
          {"second", second_.size()}};
}

}  // namespace proofmass
