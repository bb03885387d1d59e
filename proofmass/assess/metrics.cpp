// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace proofmass {
namespace {

// Fills mape_percent and mape_rows.
void add_percentage_error(Metrics& metrics, std::span<const double> measured,
                          std::span<const double> predicted) {
  const auto [least, largest] = std::minmax_element(measured.begin(), measured.end());
  const double floor = kMapeFloor * (*largest - *least);
  double sum = 0.0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (measured[k] == 0.0 || std::abs(measured[k]) < floor) continue;
    sum += std::abs((measured[k] - predicted[k]) / measured[k]);
    ++metrics.mape_rows;
  }
  if (metrics.mape_rows > 0) metrics.mape_percent = 100.0 * sum / static_cast<double>(metrics.mape_rows);
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
  Metrics metrics;
  metrics.n = measured.size();
  metrics.mae = std::abs(scale) * absolute / n;
  metrics.mse = scale * scale * mse;
  metrics.rmse = std::abs(scale) * std::sqrt(mse);
  add_percentage_error(metrics, measured, predicted);
  metrics.r2 = determination(measured, squared);
  return metrics;
}

}  // namespace proofmass
