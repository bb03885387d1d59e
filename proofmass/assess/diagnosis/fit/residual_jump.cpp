// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/residual_jump.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/assess/diagnosis/fit/joint_departure.hpp"
#include "proofmass/assess/diagnosis/record/term_space.hpp"

namespace proofmass {
namespace {

constexpr double kUnlikelyJump = 1e-5;    // of all stretches of a clean record together
constexpr double kLeastJumpLeft = 0.01;   // of a jump's square: less lies within the terms
constexpr std::size_t kLeastStretch = 4;  // rows on either side
constexpr std::size_t kMostBorders = 200;
constexpr double kChosenPlace = 0.7;  // of its errors, beside effects whose place is not chosen by them
constexpr double kUnlikelyDirection = 1e-5;
constexpr double kNoMove = 0.01;  // of the range of Ai

// The rows from one border to another, and what the residuals have along their shape.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;  // not included
  double slope = 0.0;
  double explained = 0.0;  // of the residuals' sum of squares
};

// Sums over the rows before each border: of the shape's square, of its products with the residuals, and with
// each column of the terms, so that a stretch is judged without going through its rows.
class StretchSums {
 public:
  StretchSums(const FittedRows& rows, const std::vector<double>& shape, std::vector<std::size_t> borders)
      : borders_(std::move(borders)), terms_(rows.basis().columns()) {
    for (std::size_t c = 0; c < terms_; ++c) along_.push_back(dot(rows.basis().column(c), rows.residuals()));
    std::vector<double> sum(2 + terms_, 0.0);
    std::size_t row = 0;
    for (const std::size_t border : borders_) {
      for (; row < border; ++row) {
        sum[0] += shape[row] * shape[row];
        sum[1] += shape[row] * rows.residuals()[row];
        for (std::size_t c = 0; c < terms_; ++c) sum[2 + c] += shape[row] * rows.basis()(row, c);
      }
      sums_.insert(sums_.end(), sum.begin(), sum.end());
    }
  }

  // Between two borders, by their places.
  [[nodiscard]] Stretch between(std::size_t a, std::size_t b) const {
    const double* const low = &sums_[a * (2 + terms_)];
    const double* const high = &sums_[b * (2 + terms_)];
    const double whole = high[0] - low[0];
    double left = whole;
    double along = high[1] - low[1];
    for (std::size_t c = 0; c < terms_; ++c) {
      const double part = high[2 + c] - low[2 + c];
      left -= part * part;
      along -= part * along_[c];
    }
    Stretch stretch{.first = borders_[a], .last = borders_[b]};
    if (!(left > kLeastJumpLeft * whole)) return stretch;
    stretch.slope = along / left;
    stretch.explained = along * along / left;
    return stretch;
  }

 private:
  std::vector<std::size_t> borders_;
  std::size_t terms_;
  std::vector<double> along_;
  std::vector<double> sums_;
};

std::vector<std::size_t> borders_between(std::size_t rows) {
  std::vector<std::size_t> borders;
  const std::size_t count = std::min(rows, kMostBorders);
  for (std::size_t k = 0; k <= count; ++k) borders.push_back(k * rows / count);
  return borders;
}

Stretch strongest_between(const FittedRows& rows, const std::vector<double>& shape,
                          const std::vector<std::size_t>& borders) {
  const StretchSums sums(rows, shape, borders);
  Stretch strongest;
  for (std::size_t a = 1; a + 1 < borders.size(); ++a) {
    for (std::size_t b = a + 1; b < borders.size(); ++b) {
      const std::size_t within = borders[b] - borders[a];
      if (within < kLeastStretch || rows.rows() - within < kLeastStretch) continue;
      const Stretch one = sums.between(a, b);
      // A change that lasts to the end is simpler than one that ends a little before.
      const bool to_end = borders[b] == rows.rows() && one.explained > 0.99 * strongest.explained;
      if (one.explained > strongest.explained || to_end) strongest = one;
    }
  }
  return strongest;
}

// By borders at equal distances, and then by each row near those that are found.
Stretch strongest_stretch(const FittedRows& rows, const std::vector<double>& shape) {
  const Stretch rough = strongest_between(rows, shape, borders_between(rows.rows()));
  if (rows.rows() <= kMostBorders || !(rough.explained > 0.0)) return rough;
  const std::size_t distance = rows.rows() / kMostBorders + 1;
  std::vector<std::size_t> borders{0, rows.rows()};
  for (const std::size_t border : {rough.first, rough.last}) {
    const std::size_t last = std::min(rows.rows(), border + distance);
    for (std::size_t row = border - std::min(border, distance); row <= last; ++row) borders.push_back(row);
  }
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return strongest_between(rows, shape, borders);
}

struct OrderJump {
  Stretch stretch;
  Departure departure{};
  std::vector<double> column{};
  bool of_output = true;
};

// The probability of a stretch's slope by the noise of its own rows and by that of the others: the noise of
// a few rows may be another.
double own_probability(const FittedRows& rows, const std::vector<double>& beyond, const Stretch& stretch) {
  double inside = 0.0;
  double outside = 0.0;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    const double rest = rows.residuals()[row] - stretch.slope * beyond[row];
    const double square = std::max(rest * rest, rows.rounding() * rows.rounding());
    (row >= stretch.first && row < stretch.last ? inside : outside) += square;
  }
  const auto count = static_cast<double>(stretch.last - stretch.first);
  const auto others = static_cast<double>(rows.rows()) - count;
  const double few = std::min(count, others) - 1.0;
  const double variance = std::max(inside / (count - 1.0), outside / std::max(1.0, others - 1.0));
  return student_probability(std::sqrt(stretch.explained / variance), few);
}

OrderJump jump_along(const FittedRows& rows, const std::vector<double>& shape, bool of_output) {
  OrderJump jump{.stretch = strongest_stretch(rows, shape), .of_output = of_output};
  if (!(jump.stretch.explained > 0.0)) return jump;
  jump.column.assign(rows.rows(), 0.0);
  for (std::size_t row = jump.stretch.first; row < jump.stretch.last; ++row) jump.column[row] = shape[row];
  const std::vector<double> beyond = rows.beyond_terms(jump.column);
  jump.departure = rows.departure(beyond);
  const auto tried = static_cast<double>(rows.rows());
  jump.departure.probability =
      std::max(jump.departure.probability, own_probability(rows, beyond, jump.stretch)) * tried * tried;
  return jump;
}

Finding finding_of_jump(const FittedRows& rows, const OrderJump& jump) {
  const Unit& unit = rows.record().output_unit;
  const std::string course = jump.stretch.last == rows.rows() ? "jump" : "stretch";
  return {.code = jump.of_output ? Code::residuals_follow_order : Code::scale_factor_follows_order,
          .severity = Severity::warning,
          .figures = {{"course", jump.of_output ? course : "factor_" + course},
                      {"change", std::abs(jump.stretch.slope) / std::abs(unit.to_canonical)},
                      {"first", rows.record().line_of(jump.stretch.first)},
                      {"last", rows.record().line_of(jump.stretch.last - 1)},
                      {"unit", unit.symbol + (jump.of_output ? "" : "/g")},
                      {"scale", rows.scale() / std::abs(unit.to_canonical)},
                      {"errors", std::abs(jump.departure.errors)}}};
}

bool is_in_order_of_an_input(const Dataset& record) {
  const std::vector<Axis> axes = record.axes();
  return std::any_of(axes.begin(), axes.end(), [&](Axis axis) {
    const std::vector<double>& a = record.along(axis);
    return a.front() != a.back() &&
           (std::is_sorted(a.begin(), a.end()) || std::is_sorted(a.rbegin(), a.rend()));
  });
}

}  // namespace

std::optional<ResidualEffect> find_residual_jump(const FittedRows& rows) {
  if (rows.rows() < 2 * kLeastStretch || is_in_order_of_an_input(rows.record())) return std::nullopt;
  OrderJump jump = jump_along(rows, std::vector<double>(rows.rows(), 1.0), true);
  if (rows.record().has(Axis::input)) {
    OrderJump of_scale = jump_along(rows, rows.record().along(Axis::input), false);
    if (of_scale.stretch.explained > jump.stretch.explained) jump = std::move(of_scale);
  }
  if (!(jump.departure.probability < kUnlikelyJump)) return std::nullopt;
  Finding finding = finding_of_jump(rows, jump);
  const std::vector<std::vector<double>> columns{std::move(jump.column)};
  return ResidualEffect{.finding = std::move(finding),
                        .errors = kChosenPlace * std::abs(jump.departure.errors),
                        .columns = columns_beyond(rows, columns, kLeastJumpLeft).orthonormal};
}

std::optional<ResidualEffect> find_hysteresis(const FittedRows& rows) {
  if (!rows.record().has(Axis::input)) return std::nullopt;
  const std::vector<double>& a = rows.record().along(Axis::input);
  const auto [least, greatest] = std::minmax_element(a.begin(), a.end());
  std::vector<double> direction(a.size(), 0.0);
  for (std::size_t row = 1; row < a.size(); ++row) {
    const double move = a[row] - a[row - 1];
    const bool moved = std::abs(move) > kNoMove * (*greatest - *least);
    direction[row] = moved ? std::copysign(1.0, move) : direction[row - 1];
  }
  const std::vector<double> beyond = rows.beyond_terms(direction);
  const double size = sum_of_squares(beyond);
  if (!(size > kLeastJumpLeft * sum_of_squares(direction))) return std::nullopt;
  const Departure departure = rows.departure(beyond);
  if (!(departure.probability < kUnlikelyDirection)) return std::nullopt;
  const double slope = dot(beyond, rows.residuals()) / size;
  // How the first position was come to is not known.
  std::vector<double> start(a.size(), 0.0);
  for (std::size_t row = 0; row < a.size() && direction[row] == 0.0; ++row) start[row] = 1.0;
  const std::vector<std::vector<double>> shapes{std::move(direction), std::move(start)};
  Matrix columns = columns_beyond(rows, shapes, kLeastJumpLeft).orthonormal;
  const FittedRows left = rows.with_columns(columns);
  const Unit& unit = rows.record().output_unit;
  const double to_declared = 1.0 / std::abs(unit.to_canonical);
  return ResidualEffect{.finding = {.code = Code::residuals_follow_inputs,
                                    .severity = Severity::warning,
                                    .figures = {{"axis", std::string(axis_name(Axis::input))},
                                                {"shape", std::string("direction")},
                                                {"change", 2.0 * std::abs(slope) * to_declared},
                                                {"before", rows.standard_deviation() * to_declared},
                                                {"after", left.standard_deviation() * to_declared},
                                                {"unit", unit.symbol}}},
                        .errors = std::abs(departure.errors),
                        .columns = std::move(columns)};
}

}  // namespace proofmass
