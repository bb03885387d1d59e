// SPDX-License-Identifier: Apache-2.0
// Simulates a record from a description, identifies it by two methods, and compares both with the known
// truth.
#include <cstdio>
#include <exception>

#include "proofmass/proofmass.hpp"

namespace {

// How far a coefficient is from the truth, in its own standard errors.
double deviation(const proofmass::Coefficient& coefficient, double truth) {
  return (coefficient.value - truth) / coefficient.standard_error.value();
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fputs("usage: simulate_and_compare STAND.toml\n", stderr);
    return 2;
  }
  const proofmass::SimulationPlan plan = proofmass::read_simulation(argv[1]);
  const proofmass::Dataset record = proofmass::simulate(plan);
  // Least squares would fit all rows: both set the same ones aside to test on.
  const proofmass::IdentifyOptions options{.split = 0.7};
  const proofmass::Identification ols = proofmass::identify(record, proofmass::Ols{}, options).identification;
  const proofmass::Identification network =
      proofmass::identify(record, proofmass::PsoBp{}, options).identification;

  std::printf("term            truth     ols (off by)          pso-bp (off by)\n");
  for (std::size_t k = 0; k < ols.coefficients.size(); ++k) {
    const auto& a = ols.coefficients[k];
    const auto& b = network.coefficients[k];
    const double truth = plan.truth().coefficient(a.term);
    std::printf("%-5s %15.6e %15.6e (%4.1f) %15.6e (%4.1f)\n", proofmass::name(a.term).data(), truth, a.value,
                deviation(a, truth), b.value, deviation(b, truth));
  }
  std::printf("test RMSE %15s %15.3e        %15.3e %s\n", "", ols.test->rmse, network.test->rmse,
              ols.output_unit.symbol.c_str());
  return 0;
} catch (const proofmass::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return proofmass::exit_code(error.kind());
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
