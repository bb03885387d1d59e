// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/mount_effects.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/assess/diagnosis/fit/joint_departure.hpp"

namespace proofmass {
namespace {

constexpr double kUnlikelyEffect =
    2.5e-5;  // of all mounts together, in each of two tests of each of four kinds
constexpr std::size_t kLeastMountRows = 3;
constexpr double kLeastLeft = 0.01;  // of an effect's square: less lies within the terms
constexpr double kWorthATest = 3.0;  // standard errors, roughly
constexpr std::size_t kMostJudged = 50;
constexpr double kPlain = 4.0;          // standard errors, of a mount that is counted
constexpr double kMostJointWork = 1e9;  // operations
using MountRows = std::vector<std::vector<std::size_t>>;

// What the outputs of a mount have too much of: one (an offset), Ai (a scale factor), or Ao or Ap (an angle),
// by row.
struct Kind {
  Code code = Code::verbatim;
  std::vector<double> shape;
  Term term = Term::K0;
};

struct MountEffect {
  ResidualEffect effect;
  double probability = 1.0;
};

struct Effect {
  std::size_t mount = 0;
  double size = 0.0;    // of the slope along the shape, in the output's canonical unit
  double left = 0.0;    // of the shape's square, beyond the terms
  double errors = 0.0;  // in standard errors
  double probability = 1.0;
};

// The slope of a mount's residuals along the shape, by the scale of the residuals.
Effect rough_effect(const FittedRows& rows, const Kind& kind, const MountRows& mounts, std::size_t mount) {
  const std::vector<std::size_t>& members = mounts[mount];
  double before = 0.0;
  double along = 0.0;
  for (const std::size_t row : members) {
    before += kind.shape[row] * kind.shape[row];
    along += kind.shape[row] * rows.residuals()[row];
  }
  double left = before;
  for (std::size_t c = 0; c < rows.basis().columns(); ++c) {
    double part = 0.0;
    for (const std::size_t row : members) part += rows.basis()(row, c) * kind.shape[row];
    left -= part * part;
  }
  if (!(left > kLeastLeft * before)) return {.mount = mount};
  return {
      .mount = mount, .size = along / left, .left = left, .errors = along / std::sqrt(left) / rows.scale()};
}

// The same against the noise of all rows and, lest a mount with more of it than others looks like an effect,
// against that of the mount's own rows.
void judge(const FittedRows& rows, const Kind& kind, const MountRows& mounts, Effect& effect) {
  const std::vector<std::size_t>& members = mounts[effect.mount];
  std::vector<double> shape(rows.rows(), 0.0);
  for (const std::size_t row : members) shape[row] = kind.shape[row];
  const std::vector<double> weights = rows.beyond_terms(std::move(shape));
  const Departure departure = rows.departure(weights);
  double squares = 0.0;
  for (const std::size_t row : members) {
    const double rest = rows.residuals()[row] - effect.size * weights[row];
    squares += std::max(rest * rest, rows.rounding() * rows.rounding());
  }
  const double own_dof = static_cast<double>(members.size()) - 1.0;
  const double own = effect.size * std::sqrt(effect.left / (squares / own_dof));
  effect.errors = departure.errors;
  effect.probability = std::max(departure.probability, student_probability(own, own_dof));
}

// Of each mount; judged where it is worth it, of many mounts the strongest.
std::vector<Effect> effects_of(const FittedRows& rows, const Kind& kind, const MountRows& mounts) {
  std::vector<Effect> effects;
  effects.reserve(mounts.size());
  for (std::size_t mount = 0; mount < mounts.size(); ++mount)
    effects.push_back(rough_effect(rows, kind, mounts, mount));
  std::stable_sort(effects.begin(), effects.end(),
                   [](const Effect& a, const Effect& b) { return std::abs(a.errors) > std::abs(b.errors); });
  for (std::size_t k = 0; k < std::min(effects.size(), kMostJudged); ++k) {
    if (std::abs(effects[k].errors) >= kWorthATest) judge(rows, kind, mounts, effects[k]);
  }
  return effects;
}

MountRows mounts_to_judge(const Dataset& record) {
  MountRows mounts = rows_by_mount(record.mount);
  std::erase_if(mounts, [&record](const auto& members) { return record.mount[members.front()].empty(); });
  if (mounts.size() < 2) return {};
  std::erase_if(mounts, [](const auto& members) { return members.size() < kLeastMountRows; });
  return mounts;
}

Matrix columns_of(const FittedRows& rows, const Kind& kind, const MountRows& mounts) {
  const auto count = static_cast<double>(mounts.size());
  const auto columns = count + static_cast<double>(rows.basis().columns());
  if (count * columns * static_cast<double>(rows.rows()) > kMostJointWork) return {};
  std::vector<std::vector<double>> shapes;
  shapes.reserve(mounts.size());
  for (const std::vector<std::size_t>& members : mounts) {
    std::vector<double>& shape = shapes.emplace_back(rows.rows(), 0.0);
    for (const std::size_t row : members) shape[row] = kind.shape[row];
  }
  return columns_beyond(rows, shapes, kLeastLeft).orthonormal;
}

Finding finding_of(const FittedRows& rows, const Kind& kind, const MountRows& mounts,
                   const std::vector<Effect>& effects, const Effect& strongest) {
  const Dataset& record = rows.record();
  const auto count = std::count_if(effects.begin(), effects.end(),
                                   [](const Effect& effect) { return std::abs(effect.errors) > kPlain; });
  const bool offset = kind.code == Code::residuals_follow_mount;
  return {.code = kind.code,
          .severity = Severity::warning,
          .terms = {kind.term},
          .figures = {{"count", std::max<std::size_t>(1, static_cast<std::size_t>(count))},
                      {"total", rows_by_mount(record.mount).size()},
                      {"mount", record.mount[mounts[strongest.mount].front()]},
                      {"mean", strongest.size / record.output_unit.to_canonical},
                      {"unit", record.output_unit.symbol + (offset ? "" : "/g")},
                      {"errors", std::abs(strongest.errors)}}};
}

std::vector<Kind> kinds_of(const Dataset& record) {
  std::vector<Kind> kinds{{Code::residuals_follow_mount, std::vector<double>(record.rows(), 1.0), Term::K0}};
  for (const auto& [axis, term] :
       {std::pair{Axis::input, Term::Ki}, {Axis::output, Term::Ko}, {Axis::pendulous, Term::Kp}}) {
    if (!record.has(axis)) continue;
    const Code code = term == Term::Ki ? Code::scale_factor_follows_mount : Code::alignment_follows_mount;
    kinds.push_back({code, record.along(axis), term});
  }
  return kinds;
}

std::optional<MountEffect> effect_of_kind(const FittedRows& rows, const Kind& kind, const MountRows& mounts) {
  const std::vector<Effect> effects = effects_of(rows, kind, mounts);
  const Effect strongest = *std::max_element(
      effects.begin(), effects.end(),
      [](const Effect& a, const Effect& b) { return std::abs(a.errors) < std::abs(b.errors); });
  double probability = 1.0;
  for (const Effect& effect : effects)
    probability = std::min(probability, effect.probability * static_cast<double>(mounts.size()));
  Matrix columns = columns_of(rows, kind, mounts);
  if (columns.columns() > 0) probability = std::min(probability, joint_probability(rows, columns, mounts));
  if (!(probability < kUnlikelyEffect)) return std::nullopt;
  return MountEffect{.effect = {.finding = finding_of(rows, kind, mounts, effects, strongest),
                                .errors = std::abs(strongest.errors),
                                .columns = std::move(columns)},
                     .probability = probability};
}

}  // namespace

std::optional<ResidualEffect> find_mount_effect(const FittedRows& rows) {
  const MountRows mounts = mounts_to_judge(rows.record());
  if (mounts.empty()) return std::nullopt;
  std::optional<MountEffect> found;
  for (const Kind& kind : kinds_of(rows.record())) {
    auto effect = effect_of_kind(rows, kind, mounts);
    if (effect && (!found || effect->probability < found->probability)) found = std::move(effect);
  }
  if (!found) return std::nullopt;
  return std::move(found->effect);
}

}  // namespace proofmass
