// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/units/input_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/assess/diagnosis/record/linear_fit.hpp"
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"

namespace proofmass {
namespace {

constexpr double kAgrees = 0.05;  // of the scale factor with one
constexpr double kCloseTolerance = 0.003;
constexpr double kTolerance = 0.015;  // gravity over the Earth, and a head that is a little off

constexpr std::size_t kLeastRowsOfLevels = 12;
constexpr double kSameLevel = 1e-5;      // of |A|
constexpr double kStepsOfLevel = 2.0;    // of the inputs, that rows of one |A| are apart at most
constexpr std::size_t kFewerLevels = 3;  // times fewer than before
constexpr std::size_t kRowsOfLevel = 4;  // at least, on the average
constexpr std::array kAxisUnits{"g", "m/s^2", "mg"};

// What one g reads as, in g, where the values are in `written` but taken for the unit `read`.
struct Mistake {
  const char* written;
  const char* read;
  double one_g;
};
constexpr std::array kMistakes{Mistake{"m/s^2", "g", kStandardGravity},
                               Mistake{"mg", "g", 1e3},
                               Mistake{"ft/s^2", "g", kStandardGravity / 0.3048},
                               Mistake{"mm/s^2", "g", 1e3 * kStandardGravity},
                               Mistake{"Gal", "g", 1e2 * kStandardGravity},
                               Mistake{"g", "m/s^2", 1.0 / kStandardGravity},
                               Mistake{"g", "mg", 1e-3}};

struct Magnitudes {
  double least = 0.0;
  double greatest = 0.0;
};

// Of |A|; of the largest |Ai| alone where the record has no other axis, for a tumble passes through zero.
// Nothing where |A| varies by more than one value of gravity explains.
std::optional<Magnitudes> magnitudes(const Dataset& record) {
  const bool one_axis = record.axes() == std::vector<Axis>{Axis::input};
  Magnitudes range{.least = std::numeric_limits<double>::infinity(), .greatest = 0.0};
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const double size = magnitude(record.at(row));
    range.least = std::min(range.least, size);
    range.greatest = std::max(range.greatest, size);
    if (!one_axis && range.least < (1.0 - 3.0 * kTolerance) * range.greatest) return std::nullopt;
  }
  if (one_axis) {
    const auto [low, high] =
        std::minmax_element(record.along(Axis::input).begin(), record.along(Axis::input).end());
    if (*low < 0.0 && std::abs(*low + *high) < kTolerance * *high) range.least = range.greatest;
  }
  return range;
}

// Whether an output that is declared an acceleration grows as the inputs do: then their range is what it is,
// by chance near that of another unit.
bool output_agrees(const Dataset& record) {
  if (!record.output_unit.is_acceleration() || !record.output_unit_declared) return false;
  const LinearFit fit = fit_linear(record.select(thinned_rows(record.rows())));
  return std::abs(std::abs(fit.scale_factor) - 1.0) < kAgrees;
}

// How many values |A| has: those next to each other, as closely as the inputs are written, are one.
std::size_t count_levels(const Dataset& record) {
  double step = 0.0;
  for (const double s : record.acceleration_resolution) step = std::max(step, s);
  std::vector<double> sizes;
  for (std::size_t row = 0; row < record.rows(); ++row) sizes.push_back(magnitude(record.at(row)));
  std::sort(sizes.begin(), sizes.end());
  std::size_t levels = 1;
  for (std::size_t k = 1; k < sizes.size(); ++k) {
    if (sizes[k] - sizes[k - 1] > std::max(kSameLevel * sizes[k], kStepsOfLevel * step)) ++levels;
  }
  return levels;
}

Dataset with_axis_times(Dataset record, Axis axis, double factor) {
  for (double& a : record.acceleration[static_cast<std::size_t>(axis)]) a *= factor;
  return record;
}

// One axis in another unit than the others: where it is taken for that, |A| has the few values that stands
// have, 1 g of a dividing head and the levels of a centrifuge.
std::optional<Finding> find_axis_in_other_unit(const Dataset& record) {
  if (record.rows() < kLeastRowsOfLevels || record.axes().size() < 2) return std::nullopt;
  const Dataset rows = record.select(thinned_rows(record.rows(), kSampledRows));
  const std::size_t before = count_levels(rows);
  if (before < kFewerLevels) return std::nullopt;
  for (const Axis axis : record.axes()) {
    for (const char* const symbol : kAxisUnits) {
      const auto unit = find_unit(symbol);
      if (!unit || unit->symbol == record.acceleration_unit.symbol) continue;
      const double factor = unit->to_canonical / record.acceleration_unit.to_canonical;
      const std::size_t after = count_levels(with_axis_times(rows, axis, factor));
      if (after * kFewerLevels > before || after * kRowsOfLevel > rows.rows()) continue;
      // An axis that is made too small to matter leaves the few values of the others.
      if (after * kFewerLevels > count_levels(with_axis_times(rows, axis, 0.0))) continue;
      return Finding{.code = Code::inputs_in_other_unit,
                     .severity = Severity::warning,
                     .figures = {{"magnitudes", std::string("one_of_axes")},
                                 {"axis", std::string(axis_name(axis))},
                                 {"before", before},
                                 {"after", after},
                                 {"read", record.acceleration_unit.symbol},
                                 {"written", unit->symbol}}};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Finding> find_other_input_unit(const Dataset& record) {
  if (record.rows() < 2 || record.axes().empty()) return std::nullopt;
  const bool one_axis = record.axes().size() == 1;
  const bool agrees = output_agrees(record);
  if (one_axis && agrees) return std::nullopt;
  // An output that agrees with the inputs may be in their unit; then they are 1 g more closely than by
  // chance.
  const double tolerance = agrees ? kCloseTolerance : kTolerance;
  const auto range = magnitudes(record);
  if (!range) return find_axis_in_other_unit(record);
  for (const Mistake& mistake : kMistakes) {
    if (record.acceleration_unit.symbol != mistake.read) continue;
    if (range->least < (1.0 - tolerance) * mistake.one_g ||
        range->greatest > (1.0 + tolerance) * mistake.one_g)
      continue;
    return Finding{.code = Code::inputs_in_other_unit,
                   .severity = Severity::warning,
                   .figures = {{"magnitudes", std::string(one_axis ? "one_axis" : "all_axes")},
                               {"least", range->least / record.acceleration_unit.to_canonical},
                               {"largest", range->greatest / record.acceleration_unit.to_canonical},
                               {"read", std::string(mistake.read)},
                               {"written", std::string(mistake.written)}}};
  }
  return find_axis_in_other_unit(record);
}

}  // namespace proofmass
