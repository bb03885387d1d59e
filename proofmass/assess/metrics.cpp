// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/metrics.hpp"

#include <cmath>
#include <stdexcept>

namespace proofmass {
namespace {

// Over rows whose measured output is not zero; absent when all are.
std::optional<double> mean_percentage_error(std::span<const double> measured,
                                            std::span<const double> predicted) {
  double sum = 0.0;
  std::size_t counted = 0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (measured[k] == 0.0) continue;
    sum += std::abs((measured[k] - predicted[k]) / measured[k]);
    ++counted;
  }
  if (counted == 0) return std::nullopt;
  return 100.0 * sum / static_cast<double>(counted);
}

// 1 - RSS / TSS; absent when the measured output does not vary.
std::optional<double> determination(std::span<const double> measured, double rss) {
  bool varies = false;
  double mean = 0.0;
  for (const double value : measured) {
    varies = varies || value != measured.front();
    mean += value / static_cast<double>(measured.size());
  }
  if (!varies) return std::nullopt;
  double total = 0.0;
  for (const double value : measured) total += (value - mean) * (value - mean);
  if (!(total > 0.0)) return std::nullopt;  // squares that underflow
  return 1.0 - rss / total;
}

}  // namespace

Metrics score(std::span<const double> measured, std::span<const double> predicted, double scale) {
  if (measured.empty() || measured.size() != predicted.size()) {
    throw std::invalid_argument("scores need one prediction for each of one or more measured outputs");
  }
  double absolute = 0.0;
  double squared = 0.0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    const double error = measured[k] - predicted[k];
    absolute += std::abs(error);
    squared += error * error;
  }
  const auto n = static_cast<double>(measured.size());
  const double mse = squared / n;
  return {.n = measured.size(),
          .mae = std::abs(scale) * absolute / n,
          .mse = scale * scale * mse,
          .rmse = std::abs(scale) * std::sqrt(mse),
          .mape_percent = mean_percentage_error(measured, predicted),
          .r2 = determination(measured, squared)};
}

}  // namespace proofmass
