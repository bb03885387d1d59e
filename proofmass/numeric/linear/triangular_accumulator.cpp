// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/triangular_accumulator.hpp"

#include <Eigen/Core>
#include <Eigen/QR>

namespace proofmass {

void TriangularAccumulator::add(const Matrix& block, std::size_t rows) {
  const auto n = static_cast<Eigen::Index>(r_.columns());
  const auto m = static_cast<Eigen::Index>(rows);
  Eigen::Map<Eigen::MatrixXd> r(r_.data(), n, n);
  Eigen::MatrixXd stacked(n + m, n);
  stacked.topRows(n) = r;
  stacked.bottomRows(m) =
      Eigen::Map<const Eigen::MatrixXd>(block.data(), static_cast<Eigen::Index>(block.rows()), n).topRows(m);
  const Eigen::HouseholderQR<Eigen::Ref<Eigen::MatrixXd>> qr(stacked);
  r = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
}

}  // namespace proofmass
