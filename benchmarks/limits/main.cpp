// SPDX-License-Identifier: Apache-2.0
// Measures the peak rates of one core of this machine with an instruction set, for bench/bounds.py to compare
// with the kernels. Prints one line of JSON.
//   bench_limits [TARGET]
#include <fmt/format.h>
#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "contract/target.hpp"
#include "limits/kernels.hpp"
#include "limits/tanh.hpp"

namespace {

using namespace bench;

// Seconds of the fastest of many short runs: the limit is the speed of the undisturbed machine.
double fastest(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  constexpr int kRuns = 32;
  double best = std::numeric_limits<double>::infinity();
  const Clock::time_point begin = Clock::now();
  while (Seconds(Clock::now() - begin).count() < 0.2) {
    const Clock::time_point start = Clock::now();
    for (int k = 0; k < kRuns; ++k) work();
    best = std::min(best, Seconds(Clock::now() - start).count() / kRuns);
  }
  return best;
}

// Results are stored here, so that the compiler cannot remove the work.
volatile double sink = 0.0;

double per_second(const Kernels& machine, double (*kernel)()) {
  return static_cast<double>(machine.operations * machine.lanes) / fastest([&] { sink = kernel(); });
}

std::string tanh_costs(const Kernels& machine) {
  std::vector<double> z(2048), result(z.size());
  for (std::size_t k = 0; k < z.size(); ++k) z[k] = 6.0 * std::sin(static_cast<double>(k));
  const auto ns = [&](const std::function<void()>& work) {
    return 1e9 * fastest(work) / static_cast<double>(z.size());
  };
  const double standard =
      ns([&] { std::transform(z.begin(), z.end(), result.begin(), [](double x) { return std::tanh(x); }); });
  const double highway = ns([&] { machine.highway_tanh(z.data(), z.size(), result.data()); });
  std::string text = fmt::format("{{\"standard library\": {:.4g}, \"Highway\": {:.4g}", standard, highway);
  if (product_tanh(z, result))
    text += fmt::format(", \"Proofmass\": {:.4g}", ns([&] { product_tanh(z, result); }));
  return text + "}";
}

std::string measured(const Kernels& machine) {
  const auto buffer = hwy::AllocateAligned<double>(kLoadDoubles);
  std::fill_n(buffer.get(), kLoadDoubles, 1.0);
  const double bytes = static_cast<double>(kLoadDoubles * kLoadRepeats * sizeof(double));
  const double loads = bytes / fastest([&] { sink = machine.load(buffer.get()); });
  return fmt::format(
      "{{\"target\": \"{}\", \"lanes\": {}, \"per_second\": {{\"fma\": {:.4g}, \"add\": {:.4g}, \"min\": "
      "{:.4g}, "
      "\"divide\": {:.4g}, \"permute\": {:.4g}}}, \"load_bytes_per_second\": {:.4g}, \"tanh_ns\": {}}}",
      machine.target, machine.lanes, per_second(machine, machine.fma), per_second(machine, machine.add),
      per_second(machine, machine.min), per_second(machine, machine.divide),
      per_second(machine, machine.permute), loads, tanh_costs(machine));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc > 1) force_target(argv[1]);
    fmt::print("{}\n", measured(kernels()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_limits: {}\n", error.what());
    return 2;
  }
  return 0;
}
