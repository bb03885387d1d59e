// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/wrapped_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "proofmass/assess/diagnosis/record/linear_fit.hpp"
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kLeastRows = 6;
constexpr std::size_t kLeastMoved = 2;
constexpr double kJump = 0.5;        // of the range of the outputs
constexpr double kWholeTurn = 0.95;  // of the range, that a turn is at least
constexpr double kOverlap = 0.05;    // of a turn, that outputs of two turns may have in common
constexpr int kFewestBits = 8;
constexpr int kMostBits = 32;
constexpr double kNearPower = 0.01;
constexpr double kCloser = 9.0;        // in the sum of squares
constexpr double kUnexplained = 0.01;  // of the outputs' variance, at most, once they are put right
constexpr double kOwnPart = 1e-6;  // of the turns' square: less lies within bias, scale factor and cross axes
constexpr double kLargeCross = 0.5;  // of the scale factor
constexpr double kSmallCross = 0.1;

// Whole numbers, or what is said to be counts: their means are none.
bool are_counts(const Dataset& record) {
  return record.output_unit.quantity == Quantity::count ||
         std::all_of(record.output.begin(), record.output.end(),
                     [](double v) { return v == std::nearbyint(v); });
}

// How often the output has run over before each row, counted along Ai from the row with the least.
std::vector<double> turns_of(const Dataset& rows, double range) {
  const std::vector<double>& a = rows.along(Axis::input);
  std::vector<std::size_t> order(rows.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&a](std::size_t x, std::size_t y) { return a[x] < a[y]; });
  std::vector<double> turns(rows.rows(), 0.0);
  double turn = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const double jump = rows.output[order[k]] - rows.output[order[k - 1]];
    if (std::abs(jump) > kJump * range) turn -= std::copysign(1.0, jump);
    turns[order[k]] = turn;
  }
  return turns;
}

// Rows with another number of turns than most have.
std::size_t rows_moved(const std::vector<double>& turns) {
  std::map<double, std::size_t> counts;
  for (const double turn : turns) ++counts[turn];
  std::size_t most = 0;
  for (const auto& [turn, count] : counts) most = std::max(most, count);
  return turns.size() - most;
}

double power_of_two_above(double size) {
  int bits = kFewestBits;
  while (bits < kMostBits && std::ldexp(1.0, bits) < size) ++bits;
  return std::ldexp(1.0, bits);
}

// The jump that lets the outputs follow the inputs most closely; zero where bias, scale factor and cross axes
// can take its place.
double best_jump(const LinearFit& outputs, const std::vector<double>& turns, const LinearFit& of_turns) {
  const double own = of_turns.rss;
  const double all = std::inner_product(turns.begin(), turns.end(), turns.begin(), 0.0);
  if (!(own > kOwnPart * all)) return 0.0;
  return -std::inner_product(outputs.residuals.begin(), outputs.residuals.end(), of_turns.residuals.begin(),
                             0.0) /
         own;
}

Dataset with_output(Dataset rows, const std::vector<double>& output) {
  rows.output = output;
  return rows;
}

double sum_about_mean(const std::vector<double>& values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [mean](double sum, double v) { return sum + (v - mean) * (v - mean); });
}

// Whether the outputs of each turn, put right, lie beyond those of the turn before, as when a range has run
// over: rows that are wrong among others, with another sign say, do not.
bool turns_follow(const std::vector<double>& right, const std::vector<double>& turns, double overlap) {
  struct Span {
    double least = 0.0;
    double greatest = 0.0;
  };
  std::map<double, Span> spans;
  for (std::size_t row = 0; row < right.size(); ++row) {
    const auto [at, is_new] = spans.try_emplace(turns[row], Span{right[row], right[row]});
    at->second.least = std::min(at->second.least, right[row]);
    at->second.greatest = std::max(at->second.greatest, right[row]);
  }
  for (auto one = spans.begin(), next = one; one != spans.end() && ++next != spans.end(); ++one) {
    if (next->second.least < one->second.greatest - overlap) return false;
  }
  return true;
}

// Whether the outputs follow the inputs more closely than before, or, where few set-ups let bias and cross
// axes take up the jump, as closely and by a scale factor that is then larger than they are.
bool is_plainer(const LinearFit& unwrapped, const LinearFit& before) {
  if (before.rss > kCloser * unwrapped.rss) return true;
  const auto crosses = [](const LinearFit& fit) { return fit.cross_axes / std::abs(fit.scale_factor); };
  return kCloser * before.rss > unwrapped.rss && crosses(before) > kLargeCross &&
         crosses(unwrapped) < kSmallCross;
}

struct Jump {
  double size = 0.0;
  bool power = false;  // of two
};

// What the outputs jump by: 2^n of counts.
Jump jump_of(const Dataset& record, double range, double best) {
  if (!are_counts(record)) return {.size = best, .power = false};
  if (best == 0.0) return {.size = power_of_two_above(range), .power = true};
  const double power = std::exp2(std::round(std::log2(std::abs(best))));
  const bool is_power = std::abs(best / power - 1.0) < kNearPower && power >= std::ldexp(1.0, kFewestBits) &&
                        power <= std::ldexp(1.0, kMostBits);
  return is_power ? Jump{.size = power, .power = true} : Jump{.size = best, .power = false};
}

}  // namespace

std::optional<Finding> find_wrapped_output(const Dataset& record) {
  if (record.rows() < kLeastRows || !record.has(Axis::input)) return std::nullopt;
  const Dataset rows = record.select(thinned_rows(record.rows()));
  const auto [least, greatest] = std::minmax_element(rows.output.begin(), rows.output.end());
  const double range = *greatest - *least;
  const std::vector<double> turns = turns_of(rows, range);
  const std::size_t moved = rows_moved(turns);
  if (moved < kLeastMoved) return std::nullopt;

  const LinearFit before = fit_linear(rows);
  const Jump jump = jump_of(record, range, best_jump(before, turns, fit_linear(with_output(rows, turns))));
  if (!(jump.size > kWholeTurn * range)) return std::nullopt;
  std::vector<double> right(rows.output);
  for (std::size_t row = 0; row < right.size(); ++row) right[row] += jump.size * turns[row];
  const LinearFit after = fit_linear(with_output(rows, right));
  if (!turns_follow(right, turns, kOverlap * jump.size)) return std::nullopt;
  if (!is_plainer(after, before) || !(after.rss < kUnexplained * sum_about_mean(right))) return std::nullopt;
  const Unit& unit = record.output_unit;
  return Finding{
      .code = Code::output_wrapped,
      .severity = Severity::warning,
      .figures = {{"size", std::string(jump.power ? "power" : "other")},
                  {"bits", std::round(std::log2(jump.size))},
                  {"turn", jump.size / std::abs(unit.to_canonical)},
                  {"unit", unit.symbol},
                  {"percent", 100.0 * static_cast<double>(moved) / static_cast<double>(rows.rows())}}};
}

}  // namespace proofmass
