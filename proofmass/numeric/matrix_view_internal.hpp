// SPDX-License-Identifier: Apache-2.0
// A Matrix as Eigen sees it, without a copy.
#pragma once

#include <Eigen/Core>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

using MatrixMap = Eigen::Map<Eigen::MatrixXd>;
using ConstMatrixMap = Eigen::Map<const Eigen::MatrixXd>;

inline MatrixMap view(Matrix& m) {
  return {m.data(), static_cast<Eigen::Index>(m.rows()), static_cast<Eigen::Index>(m.columns())};
}

inline ConstMatrixMap view(const Matrix& m) {
  return {m.data(), static_cast<Eigen::Index>(m.rows()), static_cast<Eigen::Index>(m.columns())};
}

inline ConstMatrixMap cview(const Matrix& m) { return view(m); }

}  // namespace proofmass
