// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/shown_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"

namespace proofmass {
namespace {

// Adds the rows with the largest and the least values of a column.
void add_ends(std::vector<std::size_t>& rows, const std::vector<double>& column, std::size_t count) {
  if (column.empty()) return;
  std::vector<std::size_t> order;
  for (std::size_t row = 0; row < column.size(); ++row)
    if (std::isfinite(column[row])) order.push_back(row);
  count = std::min(count, order.size());
  const auto by = [&](auto compare) {
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                      [&](std::size_t a, std::size_t b) {
                        return column[a] != column[b] ? compare(column[a], column[b]) : a < b;
                      });
    rows.insert(rows.end(), order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
  };
  by(std::less<>());
  by(std::greater<>());
}

}  // namespace

std::vector<std::size_t> shown_rows(const Dataset& record, const RowFigures& figures, std::size_t most) {
  const std::size_t n = record.rows();
  std::vector<std::size_t> rows(n);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  if (n <= most) return rows;
  constexpr std::size_t kFew = 4;
  // One of each stretch, at a place drawn at random: equal steps may fall in with the levels of a test plan.
  rows = thinned_rows(n, most * 9 / 10);
  add_ends(rows, figures.residuals, most / 40);
  add_ends(rows, figures.cooks_distance, most / 100);
  add_ends(rows, figures.leverage, kFew);
  for (const auto& column : record.acceleration) add_ends(rows, column, kFew);
  for (const auto* column : {&record.output, &record.temperature, &record.time})
    add_ends(rows, *column, kFew);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

}  // namespace proofmass
