// SPDX-License-Identifier: Apache-2.0
// A small simulated record with known coefficients: the paper's accelerometer in random directions.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/static_model.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass::test {

// The coefficients that Shi et al. report in their Table 2, in g per g^order.
inline StaticModel paper_truth() {
  const TermList terms{Term::K0,   Term::Ki,   Term::Ko,   Term::Kp,   Term::Kio,
                       Term::Kip,  Term::Kop,  Term::Kii,  Term::Koo,  Term::Kpp,
                       Term::Kiii, Term::Kooo, Term::Koii, Term::Kpoo, Term::Kipp};
  return {.terms = terms,
          .coefficients = {1.30617e-5, 0.999979, 6.86924e-5, 5.32093e-6, 2.58444e-5, 6.0903e-5, 7.14591e-5,
                           4.81709e-5, 3.41139e-6, 4.5615e-6, 5.40849e-6, 4.02296e-8, 1.73053e-7, 6.58132e-7,
                           7.88169e-7}};
}

struct TwinOptions {
  std::size_t rows = 300;
  double least = 1.0;  // |A| is uniform from least to greatest, in g
  double greatest = 20.0;
  double noise = 3e-4;  // standard deviation of white output noise, in g
  std::uint64_t seed = 1;
};

inline Dataset make_twin(const TwinOptions& options = {}, const StaticModel& truth = paper_truth()) {
  RandomStream inputs(options.seed, stream_id("twin inputs"));
  RandomStream noise(options.seed, stream_id("twin noise"));
  Dataset record;
  record.source = "twin";
  for (std::size_t row = 0; row < options.rows; ++row) {
    const double magnitude = inputs.uniform(options.least, options.greatest);
    const double x = inputs.normal();
    const double y = inputs.normal();
    const double z = inputs.normal();
    const double factor = magnitude / std::hypot(x, y, z);
    record.acceleration[0].push_back(factor * x);
    record.acceleration[1].push_back(factor * y);
    record.acceleration[2].push_back(factor * z);
    record.output.push_back(truth.output(record.at(row)) + options.noise * noise.normal());
  }
  return record;
}

}  // namespace proofmass::test
