// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/scale_factor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "proofmass/assess/diagnosis/fit/likely_reason.hpp"
#include "proofmass/assess/diagnosis/record/unexplained.hpp"

namespace proofmass {
namespace {

constexpr double kFarFromUnity = 0.1;  // from one
constexpr double kNear = 0.005;        // to a ratio of units: local gravity, and a sensor's own scale factor
constexpr double kMuchCloser = 9.0;    // in what of the outputs' variance is not explained
constexpr double kLeastErrorsOfScale = 5.0;  // standard errors
constexpr double kTurned = 0.02;             // of sqrt(Ki² + Ko² + Kp²) from one
constexpr double kLargeMisalignment = 0.05;  // of Ki: three degrees
constexpr double kBeyondLinear = 0.1;        // of the outputs' variance
constexpr double kLeastTurn = 0.1;           // cross axis over Ki, and its inverse

// What Ki is when a quantity is in another unit than it is taken for, in g.
struct UnitRatio {
  double ratio;
  const char* hint;
};
constexpr std::array kRatios{UnitRatio{kStandardGravity, "output_si"},
                             UnitRatio{1.0 / kStandardGravity, "inputs_si"},
                             UnitRatio{1e3, "output_milli"},
                             UnitRatio{1e-3, "inputs_milli"},
                             UnitRatio{1e6, "output_micro"},
                             UnitRatio{1e2 * kStandardGravity, "output_gal"},
                             UnitRatio{1e-2 / kStandardGravity, "inputs_gal"},
                             UnitRatio{1e3 * kStandardGravity, "output_milli_si"},
                             UnitRatio{1e3 / kStandardGravity, "output_milli_inputs_si"}};

const Coefficient* coefficient_of(const Identification& result, Term term) {
  const auto at = std::find_if(result.coefficients.begin(), result.coefficients.end(),
                               [term](const Coefficient& c) { return c.term == term && c.identified; });
  return at == result.coefficients.end() ? nullptr : &*at;
}

double value_of(const Identification& result, Term term) {
  const Coefficient* const found = coefficient_of(result, term);
  return found == nullptr ? 0.0 : found->value;
}

double error_of(const Coefficient& coefficient) { return coefficient.standard_error.value_or(0.0); }

// The angle, in degrees, by which an instrument with Ki near one is turned away from its input axis; zero
// where its coefficients are not those of one that is. Of a tumble in two planes, each may have the angle.
double turn_of(const Identification& result) {
  const double ki = std::abs(value_of(result, Term::Ki));
  const double ko = std::abs(value_of(result, Term::Ko));
  const double kp = std::abs(value_of(result, Term::Kp));
  for (const double across : {std::hypot(ko, kp), std::max(ko, kp)}) {
    const double angle = std::atan2(across, ki);
    // A turn makes Ki the cosine: one that is nearer to 1 has another cause.
    if (std::abs(std::hypot(ki, across) - 1.0) < kTurned && across > kLeastTurn * ki &&
        ki > kLeastTurn * across && 1.0 - ki > 0.5 * (1.0 - std::cos(angle)))
      return angle * 180.0 / std::numbers::pi;
  }
  return 0.0;
}

Finding unlike_one(const FittedRows& rows, const Identification& result, double ki) {
  Finding finding{.code = Code::scale_factor_unlike_one,
                  .severity = Severity::warning,
                  .terms = {Term::Ki},
                  .figures = {{"value", ki}}};
  const auto hint = [&finding](std::string name) { finding.figures.emplace_back("hint", std::move(name)); };
  for (const auto& [ratio, name] : kRatios) {
    if (std::abs(std::abs(ki) / ratio - 1.0) >= kNear) continue;
    hint(name);
    return finding;
  }
  const double unexplained = result.train && result.train->r2 ? 1.0 - *result.train->r2 : 1.0;
  const std::string reason = likely_reason(rows, unexplained / kMuchCloser);
  if (!reason.empty() && reason != "terms") {
    hint(reason);
    return finding;
  }
  hint(rows.record().output_unit_declared ? "declared" : "undeclared");
  return finding;
}

// Of an instrument that is not aligned; of any unit.
std::optional<Finding> large_cross_axis(const Identification& result, const Coefficient& ki) {
  const Coefficient* largest = nullptr;
  for (const Term cross : {Term::Ko, Term::Kp}) {
    const Coefficient* const found = coefficient_of(result, cross);
    if (found != nullptr && (largest == nullptr || std::abs(found->value) > std::abs(largest->value)))
      largest = found;
  }
  if (largest == nullptr) return std::nullopt;
  const double ratio = std::abs(largest->value / ki.value);
  const double doubt = kLeastErrorsOfScale * (error_of(*largest) + ratio * error_of(ki)) / std::abs(ki.value);
  if (!(ratio - doubt > kLargeMisalignment)) return std::nullopt;
  return Finding{
      .code = Code::cross_axis_large,
      .severity = Severity::warning,
      .terms = {largest->term},
      .figures = {{"percent", 100.0 * ratio}, {"angle", std::atan(ratio) * 180.0 / std::numbers::pi}}};
}

std::optional<Finding> larger_cross_axis(const Identification& result, const Coefficient& ki, Term cross,
                                         const std::string& unit) {
  const Coefficient* const found = coefficient_of(result, cross);
  if (found == nullptr) return std::nullopt;
  const double doubt = kLeastErrorsOfScale * std::hypot(error_of(*found), error_of(ki));
  if (std::abs(found->value) - std::abs(ki.value) <= doubt) return std::nullopt;
  return Finding{.code = Code::cross_axis_larger,
                 .severity = Severity::warning,
                 .terms = {cross},
                 .figures = {{"value", found->value}, {"ki", ki.value}, {"unit", unit}}};
}

// The output goes with the square of an input: it was squared, or is a power.
std::optional<Finding> larger_square(const FittedRows& rows, const Identification& result,
                                     const Coefficient& ki, const std::string& unit) {
  // A mistyped input lets terms that cancel each other in all other rows have any value.
  if (unexplained_by_linear_terms(rows.record()) < kBeyondLinear) return std::nullopt;
  for (const auto& [term, axis] :
       {std::pair{Term::Kii, Axis::input}, {Term::Koo, Axis::output}, {Term::Kpp, Axis::pendulous}}) {
    const Coefficient* const found = coefficient_of(result, term);
    if (found == nullptr) continue;
    double largest = 0.0;
    for (const double a : rows.record().along(axis)) largest = std::max(largest, std::abs(a));
    const double doubt = kLeastErrorsOfScale * std::hypot(largest * error_of(*found), error_of(ki));
    if (largest * std::abs(found->value) - std::abs(ki.value) <= doubt) continue;
    return Finding{.code = Code::square_larger,
                   .severity = Severity::warning,
                   .terms = {term},
                   .figures = {{"value", found->value}, {"ki", ki.value}, {"unit", unit}}};
  }
  return std::nullopt;
}

}  // namespace

std::vector<Finding> find_implausible_scale_factor(const FittedRows& rows, const Identification& result) {
  std::vector<Finding> findings;
  const Coefficient* const ki = coefficient_of(result, Term::Ki);
  if (ki == nullptr) return findings;
  const Unit& unit = rows.record().output_unit;
  const std::string symbol = unit.canonical_symbol() + "/g";
  const double turn = unit.is_acceleration() ? turn_of(result) : 0.0;
  if (turn != 0.0) {
    findings.push_back({.code = Code::scale_factor_unlike_one,
                        .severity = Severity::warning,
                        .terms = {Term::Ki},
                        .figures = {{"value", ki->value},
                                    {"hint", std::string("turned")},
                                    {"angle", turn},
                                    {"ko", value_of(result, Term::Ko)},
                                    {"kp", value_of(result, Term::Kp)}}});
    return findings;
  }
  if (auto found = larger_square(rows, result, *ki, symbol)) return {std::move(*found)};
  for (const Term cross : {Term::Ko, Term::Kp}) {
    if (auto found = larger_cross_axis(result, *ki, cross, symbol)) findings.push_back(std::move(*found));
  }
  if (!findings.empty()) return findings;  // whatever Ki is then, it is not the scale factor
  if (auto found = large_cross_axis(result, *ki)) findings.push_back(std::move(*found));
  if (ki->value < -kLeastErrorsOfScale * error_of(*ki)) {
    findings.push_back({.code = Code::scale_factor_negative,
                        .severity = Severity::warning,
                        .terms = {Term::Ki},
                        .figures = {{"value", ki->value}, {"unit", symbol}}});
  }
  if (unit.is_acceleration() && std::abs(std::abs(ki->value) - 1.0) > kFarFromUnity)
    findings.push_back(unlike_one(rows, result, ki->value));
  return findings;
}

}  // namespace proofmass
