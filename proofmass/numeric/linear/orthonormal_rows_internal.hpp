// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <utility>

#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// The rows of orthonormal regressors, one after the other: those of `rows` times an upper triangle.
class OrthonormalRows {
 public:
  OrthonormalRows(const RegressionRows& rows, Matrix orthogonaliser)
      : rows_(rows), orthogonaliser_(std::move(orthogonaliser)) {}

  [[nodiscard]] std::size_t regressors() const noexcept { return rows_.regressors(); }
  [[nodiscard]] const Matrix& orthogonaliser() const noexcept { return orthogonaliser_; }
  // Calls visit(row, q) for each row in turn.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    const std::size_t p = rows_.regressors();
    RowBlock block(p + 1);
    Eigen::VectorXd q(static_cast<Eigen::Index>(p));
    for (std::size_t first = 0; first < rows_.rows(); first += RowBlock::kRows) {
      const std::size_t count = std::min(RowBlock::kRows, rows_.rows() - first);
      rows_.fill(first, count, block);
      for (std::size_t r = 0; r < count; ++r) {
        for (std::size_t c = 0; c < p; ++c) {
          double sum = 0.0;
          for (std::size_t k = 0; k <= c; ++k) sum += block.column(k)[r] * orthogonaliser_(k, c);
          q[static_cast<Eigen::Index>(c)] = sum;
        }
        visit(first + r, q);
      }
    }
  }

 private:
  const RegressionRows& rows_;
  Matrix orthogonaliser_;
};

}  // namespace proofmass
