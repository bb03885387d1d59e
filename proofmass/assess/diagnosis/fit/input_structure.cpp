// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/input_structure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/assess/diagnosis/fit/joint_departure.hpp"
#include "proofmass/assess/diagnosis/record/term_space.hpp"

namespace proofmass {
namespace {

constexpr double kUnlikelyStructure = 1e-6;   // of each of three tests along each axis
constexpr double kLeastStructureLeft = 1e-4;  // of a column's square: less lies within the terms
constexpr double kLeastTermLeftOver = 1e-6;   // of a regressor's square, likewise
constexpr double kNearZero = 0.01;            // of an input's range: the noise of an input that is zero
constexpr std::size_t kMostParts = 9;         // of an input's range
constexpr std::size_t kDofPerPart = 3;

using ShapeColumns = std::vector<std::vector<double>>;

// The fit as if all of the 21 terms that the rows can tell apart had been asked for.
FittedRows with_all_terms(const FittedRows& rows) {
  const ShapeColumns regressors = regressor_columns(rows.record(), full_terms());
  return rows.with_columns(columns_beyond(rows, regressors, kLeastTermLeftOver).orthonormal);
}

// Where the range of ascending values is divided into that many parts: each border in the widest gap near its
// place, so that readings of one set-up stay together.
std::vector<double> borders_of(const std::vector<double>& ascending, std::size_t parts) {
  const double width = (ascending.back() - ascending.front()) / static_cast<double>(parts);
  std::vector<double> borders;
  for (std::size_t k = 1; k < parts; ++k) {
    const double place = ascending.front() + static_cast<double>(k) * width;
    const auto first = std::lower_bound(ascending.begin(), ascending.end(), place - 0.4 * width);
    const auto last = std::upper_bound(first, ascending.end(), place + 0.4 * width);
    double border = place;
    double widest = 0.0;
    for (auto at = first; at < last; ++at) {
      const double below = at == ascending.begin() ? *at : *(at - 1);
      if (*at - below <= widest) continue;
      widest = *at - below;
      border = below + 0.5 * widest;
    }
    borders.push_back(border);
  }
  return borders;
}

// One column for each part of the range of the values, one in its rows.
ShapeColumns parts_of(const std::vector<double>& values, std::size_t parts) {
  std::vector<double> ascending(values);
  std::sort(ascending.begin(), ascending.end());
  const std::vector<double> borders = borders_of(ascending, parts);
  ShapeColumns columns(parts, std::vector<double>(values.size(), 0.0));
  for (std::size_t row = 0; row < values.size(); ++row) {
    const auto part = std::lower_bound(borders.begin(), borders.end(), values[row]) - borders.begin();
    columns[static_cast<std::size_t>(part)][row] = 1.0;
  }
  return columns;
}

// -1 and 1 by the sign of each value, 0 near zero.
std::vector<double> signs_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  std::vector<double> signs(values.size(), 0.0);
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::abs(values[row]) > kNearZero * largest) signs[row] = std::copysign(1.0, values[row]);
  }
  return signs;
}

std::vector<double> sizes_of(const std::vector<double>& values) {
  std::vector<double> sizes(values);
  for (double& size : sizes) size = std::abs(size);
  return sizes;
}

struct Shape {
  std::string name;    // "step", "slope", "other"
  double slope = 0.0;  // of the residuals, in the output's canonical unit by that of the shape
  double probability = 1.0;
  double explained = 0.0;  // of the residuals' sum of squares
  ShapeColumns columns{};
};

Shape shape_of(const FittedRows& rows, std::string name, std::vector<double> column) {
  Shape shape{.name = std::move(name)};
  const std::vector<double> beyond = rows.beyond_terms(column);
  const double size = sum_of_squares(beyond);
  if (!(size > kLeastStructureLeft * sum_of_squares(column))) return shape;
  const double along = dot(beyond, rows.residuals());
  shape.slope = along / size;
  shape.explained = along * along / size;
  shape.probability = rows.departure(beyond).probability;
  shape.columns.push_back(std::move(column));
  return shape;
}

Shape shape_of_parts(const FittedRows& rows, const std::vector<double>& values) {
  Shape shape{.name = "other"};
  const std::size_t parts = std::min(kMostParts, rows.dof() / kDofPerPart);
  if (parts < 3) return shape;
  shape.columns = parts_of(values, parts);
  const Matrix beyond = columns_beyond(rows, shape.columns, kLeastStructureLeft).orthonormal;
  if (beyond.columns() == 0) return shape;
  shape.probability = joint_probability(rows, beyond);
  return shape;
}

// Whether the residuals follow the columns still when the shape is taken off.
bool is_all(const FittedRows& rows, const Shape& shape, const ShapeColumns& columns) {
  if (shape.columns.empty() || shape.probability > kUnlikelyStructure) return false;
  const FittedRows left =
      rows.with_columns(columns_beyond(rows, shape.columns, kLeastStructureLeft).orthonormal);
  const Matrix others = columns_beyond(left, columns, kLeastStructureLeft).orthonormal;
  return joint_probability(left, others) > kUnlikelyStructure;
}

// How the residuals follow an axis: by a step or another slope where that is all.
struct AxisStructure {
  Axis axis = Axis::input;
  Shape shape;
  double probability = 1.0;
};

AxisStructure structure_along(const FittedRows& rows, Axis axis) {
  const std::vector<double>& values = rows.record().along(axis);
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  AxisStructure found{.axis = axis, .shape = {.name = "other"}};
  if (!(*greatest > *least)) return found;
  std::array shapes{shape_of(rows, "step", signs_of(values)), shape_of(rows, "slope", sizes_of(values)),
                    shape_of_parts(rows, values)};
  ShapeColumns columns;
  for (const Shape& shape : shapes) {
    found.probability = std::min(found.probability, shape.probability);
    columns.insert(columns.end(), shape.columns.begin(), shape.columns.end());
  }
  if (found.probability > kUnlikelyStructure) return found;
  if (shapes[1].explained > shapes[0].explained) std::swap(shapes[0], shapes[1]);
  found.shape = std::move(shapes[is_all(rows, shapes[0], columns) ? 0 : 2]);
  found.shape.columns = std::move(columns);
  return found;
}

// How far what the columns explain lies from zero, in standard errors, with allowance for their number.
double errors_of(const FittedRows& rows, const FittedRows& left) {
  const double explained = sum_of_squares(rows.residuals()) - sum_of_squares(left.residuals());
  const auto columns = static_cast<double>(rows.dof() - left.dof());
  return std::sqrt(std::max(0.0, explained / std::pow(left.standard_deviation(), 2) - columns));
}

}  // namespace

std::optional<ResidualEffect> find_input_structure(const FittedRows& fitted) {
  const FittedRows rows = with_all_terms(fitted);
  if (!rows.has_noise()) return std::nullopt;
  AxisStructure found;
  for (const Axis axis : rows.record().axes()) {
    AxisStructure one = structure_along(rows, axis);
    if (one.probability < found.probability) found = std::move(one);
  }
  if (!(found.probability < kUnlikelyStructure)) return std::nullopt;
  Matrix columns = columns_beyond(rows, found.shape.columns, kLeastStructureLeft).orthonormal;
  const FittedRows left = rows.with_columns(columns);
  const Unit& unit = rows.record().output_unit;
  const double to_declared = 1.0 / std::abs(unit.to_canonical);
  return ResidualEffect{.finding = {.code = Code::residuals_follow_inputs,
                                    .severity = Severity::warning,
                                    .figures = {{"axis", std::string(axis_name(found.axis))},
                                                {"shape", found.shape.name},
                                                {"change", 2.0 * std::abs(found.shape.slope) * to_declared},
                                                {"before", fitted.standard_deviation() * to_declared},
                                                {"after", left.standard_deviation() * to_declared},
                                                {"unit", unit.symbol}}},
                        .errors = errors_of(rows, left),
                        .columns = std::move(columns)};
}

}  // namespace proofmass
