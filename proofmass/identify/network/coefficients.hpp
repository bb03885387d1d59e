// SPDX-License-Identifier: Apache-2.0
// The static model's coefficients out of a trained network.
#pragma once

#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/identify/model/static_fit.hpp"

namespace proofmass {

// Least-squares projection of the network's function onto the terms over the rows of the record. The
// covariance is that of least squares with the same terms on the same rows, s² (XᵀX)⁻¹, plus d dᵀ with d the
// difference of the two coefficients. The delta method in the network's tangent space knows nothing of what
// the network cannot represent, and is too small there; d shows it without the truth. It assumes white noise
// and exact inputs. Empty without more rows than terms.
struct ProjectedCoefficients {
  StaticFit fit;
  double rss = 0.0;  // of the network itself over the rows, output's canonical unit squared
  double induced_deviation =
      0.0;  // rms over the rows of the terms' projection of the network's residual: by the
            // identity K = OLS(output) - OLS(residual) all that sets K apart from least squares
  std::vector<double> deviation;  // OLS(residual), one a term
};
[[nodiscard]] ProjectedCoefficients project_onto_terms(const TrainedNetwork& network, const Dataset& data,
                                                       const TermList& terms);

// Taylor expansion of the network at zero specific force, one coefficient a term: the coefficient of A^alpha
// is sum_j v_j tanh^(k)(b_j) w_j^alpha / alpha!, k = |alpha|, with the scaling folded into the weights.
// |Ai|*Ai (Koq) is not analytic at zero; its coefficient is reported as 0.
[[nodiscard]] std::vector<double> expand_at_zero(const TrainedNetwork& network, const TermList& terms);

}  // namespace proofmass
