// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/optimise/termination.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {

struct RobustOptions {
  LossKind loss = LossKind::bisquare;
  // Huber's k, Tukey's c, Student's degrees of freedom; none: default_tuning, and for Student estimated.
  std::optional<double> tuning{};
  std::size_t iterations = 500;  // of reweighting in one round, at most
  double tolerance = 1e-12;      // ends a round when no fitted value moves by more than this many scales
};

struct RobustFit {
  std::vector<double> coefficients;  // one a column
  std::vector<double> residuals;     // one a row
  std::vector<double> weights;       // one a row; those of the last step, at most about 1
  std::vector<double> vif;           // of the columns without weights, as LeastSquaresFit's
  Matrix covariance;                 // asymptotic, see below
  double rss = 0.0;                  // of all rows, unweighted
  double scale = 0.0;                // median_scale of the residuals: sigma, were they normal
  double loss_scale = 0.0;           // what residuals were divided by: the same, but for Student t's its own
  RobustLoss loss;                   // with the tuning used
  double psi_slope = 0.0;      // mean of psi'; must be well above zero for the covariance to mean anything
  bool rank_lost = false;      // rows with weight left do not determine the coefficients; then only the
                               // weights are of use
  std::size_t iterations = 0;  // of all rounds
  Termination termination;
};

// M-estimation of linear coefficients by iteratively reweighted least squares (Huber, Robust Statistics,
// 1981, 7.8; Holland & Welsch 1977). It starts from least absolute deviations, smoothed near zero, with
// rows of high leverage weighted down (Mallows), so that the start of a loss with several minima is not
// where far rows pull it. Then two rounds: the scale from the residuals, and reweighting to convergence with
// the scale held, under which the loss falls at every step. Covariance by Huber 1981, eq. (6.5) of chapter 7:
// K² [sum psi² / (n - p)] scale² / (mean psi')² (XᵀX)⁻¹, K = 1 + p/n var(psi') / (mean psi')². The scale is
// kept above rounding of y, so exact data are fitted exactly. The design must have full column rank and
// more rows than columns, else std::invalid_argument.
// It is asked before every reweighting whether to go on; once not, it ends with cause stopped, and the rest
// of the result is of no use.
[[nodiscard]] RobustFit fit_robustly(const Matrix& design, std::span<const double> y,
                                     const RobustOptions& options = {},
                                     const std::function<bool()>& keep_going = {});

}  // namespace proofmass
