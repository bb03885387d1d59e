// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/distribution.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace proofmass {
namespace {

std::vector<double> sorted_finite(std::span<const double> values) {
  std::vector<double> sorted;
  sorted.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(sorted),
               [](double v) { return std::isfinite(v); });
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

std::size_t bins_of(const std::vector<double>& sorted, std::size_t most) {
  const auto n = static_cast<double>(sorted.size());
  const double quartiles = sorted[3 * sorted.size() / 4] - sorted[sorted.size() / 4];
  const double range = sorted.back() - sorted.front();
  const double width = 2.0 * quartiles / std::cbrt(n);
  if (!(width > 0.0) || !(range / width <= static_cast<double>(most))) return most;
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(range / width)));
}

void take_moments(Histogram& made, const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  for (const double v : values) made.mean += v / n;
  double squares = 0.0;
  for (const double v : values) squares += (v - made.mean) * (v - made.mean);
  made.sd = std::sqrt(squares / (n - 1.0));
}

}  // namespace

Histogram histogram(std::span<const double> values, std::size_t most) {
  const std::vector<double> sorted = sorted_finite(values);
  Histogram made;
  const double range = sorted.empty() ? 0.0 : sorted.back() - sorted.front();
  if (sorted.size() < 2 || !std::isnormal(range)) return made;
  const std::size_t bins = bins_of(sorted, most);
  made.low = sorted.front();
  made.width = (sorted.back() - sorted.front()) / static_cast<double>(bins);
  made.counts.assign(bins, 0);
  for (const double v : sorted)
    ++made.counts[std::min(static_cast<std::size_t>((v - made.low) / made.width), bins - 1)];
  take_moments(made, sorted);
  if (!std::isnormal(made.sd)) return {};
  const boost::math::normal normal(made.mean, made.sd);
  for (std::size_t k = 0; k < bins; ++k) {
    const double from = made.low + made.width * static_cast<double>(k);
    made.normal_heights.push_back(static_cast<double>(sorted.size()) *
                                  (cdf(normal, from + made.width) - cdf(normal, from)));
  }
  return made;
}

NormalQuantiles normal_quantiles(std::span<const double> values, std::size_t most) {
  constexpr std::size_t kEnds = 100;
  const std::vector<double> sorted = sorted_finite(values);
  const boost::math::normal standard;
  const std::size_t n = sorted.size();
  const std::size_t step = std::max<std::size_t>(1, (n + most - 1) / most);
  NormalQuantiles made;
  for (std::size_t k = 0; k < n; ++k) {
    if (k >= kEnds && k + kEnds < n && k % step != 0) continue;
    made.expected.push_back(
        quantile(standard, (static_cast<double>(k) + 0.625) / (static_cast<double>(n) + 0.25)));
    made.observed.push_back(sorted[k]);
  }
  return made;
}

}  // namespace proofmass
