// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/record_figures.hpp"

#include <algorithm>
#include <cmath>

#include "proofmass/assess/residuals/shown_rows.hpp"

namespace proofmass {
namespace {

template <class T>
std::vector<T> at_rows(const std::vector<T>& values, const std::vector<std::size_t>& rows) {
  std::vector<T> some;
  if (values.empty()) return some;
  some.reserve(rows.size());
  for (const std::size_t row : rows) some.push_back(values[row]);
  return some;
}

RowFigures at_rows(const RowFigures& all, const std::vector<std::size_t>& rows) {
  return {.parts = at_rows(all.parts, rows),
          .predicted = at_rows(all.predicted, rows),
          .residuals = at_rows(all.residuals, rows),
          .leverage = at_rows(all.leverage, rows),
          .studentised = at_rows(all.studentised, rows),
          .cooks_distance = at_rows(all.cooks_distance, rows)};
}

std::vector<std::size_t> largest(const std::vector<double>& values, std::size_t most) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::isfinite(values[k])) places.push_back(k);
  most = std::min(most, places.size());
  std::partial_sort(
      places.begin(), places.begin() + static_cast<std::ptrdiff_t>(most), places.end(),
      [&](std::size_t a, std::size_t b) { return values[a] != values[b] ? values[a] > values[b] : a < b; });
  places.resize(most);
  return places;
}

}  // namespace

RecordFigures record_figures(const Dataset& record, const Split& split, const Identification& result) {
  constexpr std::size_t kInfluential = 10;
  const RowFigures all = row_figures(record, split, result);
  const std::vector<double> fitted = at_rows(all.residuals, split.training);
  RecordFigures made;
  made.numbers = shown_rows(record, all);
  made.record = record.select(made.numbers);
  made.record.line = record.lines_of(made.numbers);
  made.rows = at_rows(all, made.numbers);
  for (const std::size_t number : made.numbers) {
    const auto place = std::lower_bound(split.test.begin(), split.test.end(), number);
    if (place != split.test.end() && *place == number)
      made.test_ranks.push_back(static_cast<std::size_t>(place - split.test.begin()) + 1);
  }
  made.total_rows = record.rows();
  made.histogram = histogram(fitted);
  made.quantiles = normal_quantiles(fitted);
  made.most_influential = largest(made.rows.cooks_distance, kInfluential);
  return made;
}

}  // namespace proofmass
