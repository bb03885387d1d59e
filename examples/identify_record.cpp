// SPDX-License-Identifier: Apache-2.0
// Reads a test record, identifies its static model by PSO-BP and prints a summary: five lines.
#include <exception>
#include <iostream>

#include "proofmass/proofmass.hpp"

using namespace proofmass;

int main(int argc, char** argv) try {
  const Dataset record = read_record(argc > 1 ? argv[1] : "run.csv");
  const Run run = identify(record, PsoBp{.particles = 50}, {.terms = paper_terms(), .seed = 3});
  std::cout << summary(run);
  const Coefficient& ki = run.identification.find(Term::Ki);
  return ki.identified ? 0 : 1;
} catch (const Error& error) {
  std::cerr << error.what() << '\n';
  return exit_code(error.kind());
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
