// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/optimise/termination.hpp"
#include "proofmass/numeric/regression/residual_scale.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {

struct RobustOptions {
  LossKind loss = LossKind::bisquare;
  // Huber's k, Tukey's c or Student's degrees of freedom. Empty: default_tuning, and for Student an estimate.
  std::optional<double> tuning{};
  std::size_t iterations = 500;  // iterations of reweighting in one round, at most
  double tolerance = 1e-12;      // ends a round when no fitted value moves by more than this many scales
};

struct RobustFit {
  std::vector<double> coefficients;  // one per column
  std::vector<double> residuals;     // one per row
  std::vector<double> weights;       // one per row, from the last step, at most about 1
  std::vector<double> vif;           // of the columns without weights, as in LeastSquaresFit
  Matrix covariance;                 // asymptotic, see below
  double rss = 0.0;                  // over all rows, unweighted
  double scale = 0.0;  // median_scale of the residuals: the standard deviation if they are normal
  // The least value of scale: what the output's resolution (a grid's step over sqrt(12), when all outputs lie
  // on one) and rounding of y and of sum |x b| leave of an exact fit.
  double scale_floor = 0.0;
  bool scale_floored = false;  // whether it would be less: then it is that of grouped data
  double resolution = 0.0;     // step of the grid that the outputs lie on; zero when on none
  ScaleCheck scale_check;      // whether other estimates of scale agree
  double loss_scale = 0.0;     // the scale that divides residuals: the same, except for Student t's own scale
  RobustLoss loss;             // with the tuning used
  double psi_slope = 0.0;      // mean of psi'; must be well above zero for the covariance to be meaningful
  bool rank_deficient = false;  // rows with weight left do not determine the coefficients; then only the
                                // weights are of use
  std::size_t iterations = 0;   // over all rounds
  Termination termination;
};

// M-estimation of linear coefficients by iteratively reweighted least squares (Huber, Robust Statistics,
// 1981, 7.8; Holland & Welsch 1977). It starts from least absolute deviations, smoothed near zero. Rows of
// high leverage have less weight there (Mallows), so that outlying rows do not determine the start of a loss
// with several minima. Two rounds follow: the scale from the residuals, then reweighting to convergence with
// this scale, under which the loss falls at every step. Covariance by Huber 1981, eq. (6.5) of chapter 7: K²
// [sum psi² / (n - p)] scale² / (mean psi')² (XᵀX)⁻¹, K = 1 + p/n var(psi') / (mean psi')². The scale is kept
// above rounding and the output's resolution: exact data are fitted exactly, and rows of quantised data that
// are one step away keep their weight. Throws std::invalid_argument unless the design
// has full column rank and more rows than columns.
// The observer is called before every reweighting. When it returns false, the iteration ends with cause
// stopped, and the rest of the result is not usable.
[[nodiscard]] RobustFit fit_robustly(const Matrix& design, std::span<const double> y,
                                     const RobustOptions& options = {},
                                     const std::function<bool()>& keep_going = {});

}  // namespace proofmass
