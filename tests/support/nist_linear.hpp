// SPDX-License-Identifier: Apache-2.0
// NIST's linear reference problems, and the digits that a solver must reach on them.
#pragma once

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "support/nist.hpp"

namespace proofmass::test {

struct CertifiedSet {
  std::string name;
  bool intercept;
  int degree;     // powers of the first predictor; 0: every predictor unchanged
  double digits;  // required of the worst coefficient and the worst standard deviation
};

inline void PrintTo(const CertifiedSet& set, std::ostream* out) { *out << set.name; }

inline std::vector<CertifiedSet> certified_sets() {
  return {{"Filip", true, 10, 7.0},   {"Longley", true, 0, 10.0}, {"NoInt1", false, 1, 13.0},
          {"NoInt2", false, 1, 13.0}, {"Norris", true, 1, 12.0},  {"Pontius", true, 2, 12.0},
          {"Wampler1", true, 5, 9.5}, {"Wampler2", true, 5, 9.5}, {"Wampler3", true, 5, 9.5},
          {"Wampler4", true, 5, 7.5}, {"Wampler5", true, 5, 5.5}};
}

inline Matrix make_design(const NistProblem& problem, const CertifiedSet& set) {
  const std::size_t first = set.intercept ? 1 : 0;
  const std::size_t columns = set.degree > 0 ? static_cast<std::size_t>(set.degree) : problem.x.size();
  Matrix design(problem.y.size(), first + columns);
  for (std::size_t r = 0; r < design.rows(); ++r) {
    if (set.intercept) design(r, 0) = 1.0;
    for (std::size_t c = 0; c < columns; ++c) {
      design(r, first + c) =
          set.degree > 0 ? std::pow(problem.x[0][r], static_cast<double>(c + 1)) : problem.x[c][r];
    }
  }
  return design;
}

// Correct digits of the worst coefficient and of the worst standard deviation.
struct CertifiedDigits {
  double coefficients = 15.0;
  double standard_deviations = 15.0;
};

// Wampler 1 and 2 are exact polynomials whose certified deviations are zero. Their digits are those of the
// absolute value; the coefficients are 1 or less.
inline CertifiedDigits certified_digits(const NistProblem& problem, const std::vector<double>& coefficients,
                                        const Matrix& unscaled_covariance, double residual_sd) {
  CertifiedDigits digits;
  digits.standard_deviations = correct_digits(residual_sd, problem.residual_sd);
  for (std::size_t k = 0; k < problem.certified.size(); ++k) {
    const double sd = residual_sd * std::sqrt(unscaled_covariance(k, k));
    digits.coefficients =
        std::min(digits.coefficients, correct_digits(coefficients[k], problem.certified[k]));
    digits.standard_deviations =
        std::min(digits.standard_deviations, correct_digits(sd, problem.certified_sd[k]));
  }
  return digits;
}

}  // namespace proofmass::test
