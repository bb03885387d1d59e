// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/linear_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "proofmass/core/term.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {

LinearFit fit_linear(const Dataset& rows) {
  if (rows.rows() == 0) return {};
  const TermSums sums(rows, linear_terms());
  const TermList terms = analyse_identifiability(sums, linear_terms()).identified;
  LinearFit fit{.model = {}, .residuals = rows.output};
  std::size_t fitted = 0;
  if (!terms.empty() && rows.rows() > terms.size()) {
    const TermRows regression = sums.rows(terms);
    const std::vector<double> coefficients =
        solve_normal_equations(sums.gram(terms), regression).coefficients;
    fitted = terms.size();
    fit.model = {.terms = terms, .coefficients = coefficients};
    fit.residuals = regression_residuals(regression, coefficients);
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (terms[k] == Term::Ki) fit.scale_factor = coefficients[k];
      if (terms[k] == Term::Ko || terms[k] == Term::Kp)
        fit.cross_axes = std::max(fit.cross_axes, std::abs(coefficients[k]));
    }
  }
  fit.scale = median_scale(fit.residuals, fitted);
  fit.rss = std::inner_product(fit.residuals.begin(), fit.residuals.end(), fit.residuals.begin(), 0.0);
  return fit;
}

}  // namespace proofmass
