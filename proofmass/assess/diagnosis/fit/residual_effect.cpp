// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/residual_effect.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "proofmass/assess/diagnosis/fit/joint_departure.hpp"

namespace proofmass {
namespace {

constexpr double kLeastColumnLeft = 1e-6;  // of a column's square: less lies within the effects before

constexpr double kAsStrong = 1.0 - 1e-6;  // what two names of one effect differ by

struct Found {
  FindEffect find = nullptr;
  ResidualEffect effect;
  bool stays = true;
};

bool stays_beside(const FittedRows& rows, const Found& one, const Found& other) {
  const Matrix& columns = other.effect.columns;
  return columns.columns() == 0 || one.find(rows.with_columns(columns)).has_value();
}

// Of two effects, marks the one that the other explains.
void compare(const FittedRows& rows, Found& a, Found& b) {
  if (!a.stays || !b.stays) return;
  const bool a_stays = stays_beside(rows, a, b);
  const bool b_stays = stays_beside(rows, b, a);
  if (a_stays && b_stays) return;
  const bool a_first = a_stays == b_stays ? a.effect.errors > kAsStrong * b.effect.errors : a_stays;
  (a_first ? b : a).stays = false;
}

}  // namespace

std::vector<ResidualEffect> find_effects(const FittedRows& rows, std::span<const FindEffect> sought) {
  std::vector<Found> found;
  for (const FindEffect find : sought) {
    if (auto effect = find(rows)) found.push_back({.find = find, .effect = std::move(*effect)});
  }
  for (std::size_t a = 0; a < found.size(); ++a) {
    for (std::size_t b = a + 1; b < found.size(); ++b) compare(rows, found[a], found[b]);
  }
  // What dropped an effect may have been dropped itself.
  for (Found& one : found) {
    if (one.stays) continue;
    one.stays = std::all_of(found.begin(), found.end(), [&](const Found& other) {
      return !other.stays || stays_beside(rows, one, other);
    });
  }
  std::vector<ResidualEffect> effects;
  for (Found& one : found) {
    if (one.stays) effects.push_back(std::move(one.effect));
  }
  return effects;
}

FittedRows without_effects(const FittedRows& rows, std::span<const ResidualEffect> effects) {
  FittedRows left = rows;
  for (const ResidualEffect& effect : effects) {
    std::vector<std::vector<double>> columns;
    for (std::size_t c = 0; c < effect.columns.columns(); ++c) {
      const std::span<const double> column = effect.columns.column(c);
      columns.emplace_back(column.begin(), column.end());
    }
    left = left.with_columns(columns_beyond(left, columns, kLeastColumnLeft).orthonormal);
  }
  return left;
}

}  // namespace proofmass
