// SPDX-License-Identifier: Apache-2.0
// Reads a test record and identifies its static model twice: by least squares, then by a swarm-started
// network.
#include <cstdio>
#include <exception>
#include <string_view>

#include "proofmass/core/error.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/record/csv/csv.hpp"

namespace {

void print(const proofmass::Identification& fit) {
  std::printf("%s: %s\n", fit.method.c_str(), fit.ending.reason.c_str());
  for (const auto& coefficient : fit.coefficients) {
    std::printf("  %-5s %14.6e +- %.1e\n", proofmass::name(coefficient.term).data(), coefficient.value,
                coefficient.standard_error.value_or(0.0));
  }
  std::printf("  test RMSE %.3e %s over %zu rows\n", fit.test->rmse, fit.output_unit.symbol.c_str(),
              fit.test->n);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fputs("usage: identify_record RUN.csv\n", stderr);
    return 2;
  }
  const proofmass::Dataset record = proofmass::read_record(argv[1]);
  const proofmass::IdentifyOptions options{.terms = proofmass::parse_terms("paper"), .seed = 1};
  proofmass::SilentProgress progress;
  for (const std::string_view method : {"ols", "pso-bp"}) {
    print(proofmass::run(record, proofmass::find_method(method), options, {.training_share = 0.7}, progress));
  }
  return 0;
} catch (const proofmass::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return proofmass::exit_code(error.kind());
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
