// SPDX-License-Identifier: Apache-2.0
// The passes of a linear regression over its rows, vectorised; the instruction set (SSE4, AVX2, AVX-512) is
// chosen at run time. Each pass uses one thread. Results of different instruction sets differ only by
// rounding.
//
// Sums of products are formed in about twice the working precision. Within a block of rows each sum starts at
// a constant so large that it stays in one binade. A product added to it is cut there, and the part cut off
// is known exactly (Rump, Ogita & Oishi, "Accurate floating-point summation part I", SIAM J. Sci. Comput. 31,
// 2008, algorithm ExtractVector; here with the product fused):
//   s = fl(h + a b);  q = s - h, exact;  l += fl(a b - q);  h = s
// This takes four operations a product, against ten of algorithm Dot2 (Ogita, Rump & Oishi 2005). The sums of
// blocks are then added as in Dot2. The error of sum(a b) is at most 2^-87 max|a| max|b| a row, and about
// 2^-98 |a| |b| on data.
#pragma once

#include <cstddef>
#include <span>

#include "proofmass/numeric/linear/gram_matrix.hpp"
#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Adds rows first … last - 1 to the sums.
void add_products(const RegressionRows& rows, std::size_t first, std::size_t last, GramMatrix& sums);
// The same, and adds the rows times the square roots of weights (one for each of all rows) to `weighted`.
void add_products(const RegressionRows& rows, std::span<const double> weights, std::size_t first,
                  std::size_t last, GramMatrix& sums, GramMatrix& weighted);

// Writes response - row * coefficients for last - first rows, in twice the working precision, rounded once.
// The coefficients are those of the scaled regressors.
void compute_residuals(const RegressionRows& rows, std::span<const double> coefficients, std::size_t first,
                       std::size_t last, std::span<double> residuals);

// Writes |row * transform|² for last - first rows. The transform is upper triangular, with one row and one
// column for each scaled regressor.
void compute_squared_lengths(const RegressionRows& rows, const Matrix& transform, std::size_t first,
                             std::size_t last, std::span<double> lengths);

}  // namespace proofmass
