// SPDX-License-Identifier: Apache-2.0
// How small a robust scale can be, and whether it can be trusted.
#pragma once

#include <cstddef>
#include <span>

namespace proofmass {

// The step of the grid that all values lie on, as a counter's or a rounded column's do; zero when they lie on
// none, or when fewer than five distinct values are there to tell.
[[nodiscard]] double grid_step(std::span<const double> values);

// median_scale of residuals whose y is known to one `step` only: each counts as spread evenly over a step
// about it. At least 0.37 steps.
[[nodiscard]] double grouped_median_scale(std::span<const double> residuals, std::size_t fitted, double step);

// Rows more than parameters with which check_scale finds most records that are nearly half outliers. With
// fewer, most of them pass.
inline constexpr std::size_t kEnoughSpareRows = 30;

// How far other estimates of the residuals' scale lie from a median_scale, above one when it is doubtful.
struct ScaleCheck {
  // The scale over that of the shortest interval with half of the residuals (Rousseeuw & Leroy, Robust
  // Regression and Outlier Detection, 1987, 4.3): large when residuals gather away from zero, because the fit
  // runs between two groups of rows.
  double over_shortest_half = 1.0;
  // That of the 60 % quantile of |residual| over the scale: large when more than 40 % of the rows are
  // outliers.
  double quantile_ratio = 1.0;
  // Whether one of the two is larger than chance makes it for normal residuals, Student's t with three
  // degrees of freedom, or one outlier in ten.
  bool doubtful = false;
};

// `fitted` parameters came from the same rows. Residuals are certain to one `resolution` only, so that much
// counts for no disagreement. Never doubtful with less than 15 rows more than parameters.
[[nodiscard]] ScaleCheck check_scale(std::span<const double> residuals, std::size_t fitted, double scale,
                                     double resolution);

}  // namespace proofmass
