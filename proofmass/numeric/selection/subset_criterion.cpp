// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/selection/subset_criterion.hpp"

#include <Eigen/Dense>
#include <limits>
#include <stdexcept>

namespace proofmass {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Map = Eigen::Map<const MatrixXd>;

// 1 - leverage below which a row alone determines some combination of the coefficients, but for rounding.
constexpr double kAlone = 1e-12;

// |y - X c|² = |rotated - triangle c|² + rest for every c.
struct Reduced {
  MatrixXd triangle;
  VectorXd rotated;
  double rest = 0.0;
  double rows = 0.0;
};

struct Factored {
  Reduced reduced;
  MatrixXd basis;      // orthonormal, of the design's column space; rows x columns
  VectorXd remainder;  // the part of y outside it
};

Factored factor(const Regression& rows, bool with_basis) {
  const auto n = static_cast<Index>(rows.design.rows());
  const auto p = static_cast<Index>(rows.design.columns());
  if (p == 0 || p > 32 || n < p || rows.y.size() != rows.design.rows()) {
    throw std::invalid_argument("a criterion needs 1 to 32 columns, as many rows, and one y a row");
  }
  const Eigen::HouseholderQR<MatrixXd> qr(Map(rows.design.data(), n, p));
  VectorXd rotated = qr.householderQ().adjoint() * Eigen::Map<const VectorXd>(rows.y.data(), n);
  Factored result;
  result.reduced = {.triangle = qr.matrixQR().topRows(p).triangularView<Eigen::Upper>(),
                    .rotated = rotated.head(p),
                    .rest = rotated.tail(n - p).squaredNorm(),
                    .rows = static_cast<double>(n)};
  if (with_basis) {
    result.basis = qr.householderQ() * MatrixXd::Identity(n, p);
    rotated.head(p).setZero();
    result.remainder = qr.householderQ() * rotated;
  }
  return result;
}

MatrixXd chosen_columns(const MatrixXd& matrix, Subset subset) {
  MatrixXd chosen(matrix.rows(), static_cast<Index>(__builtin_popcount(subset)));
  Index next = 0;
  for (Index c = 0; c < matrix.cols(); ++c) {
    if ((subset >> c & 1U) != 0U) chosen.col(next++) = matrix.col(c);
  }
  return chosen;
}

double residual_sum(const Reduced& reduced, Subset subset) {
  const MatrixXd chosen = chosen_columns(reduced.triangle, subset);
  const Eigen::HouseholderQR<MatrixXd> qr(chosen);
  const VectorXd rotated = qr.householderQ().adjoint() * reduced.rotated;
  return rotated.tail(rotated.size() - chosen.cols()).squaredNorm() + reduced.rest;
}

VectorXd coefficients(const Reduced& reduced, Subset subset) {
  return chosen_columns(reduced.triangle, subset).householderQr().solve(reduced.rotated);
}

class Press final : public SubsetCriterion {
 public:
  explicit Press(const Regression& rows) : factored_(factor(rows, true)) {}
  [[nodiscard]] std::size_t columns() const override {
    return static_cast<std::size_t>(factored_.basis.cols());
  }
  [[nodiscard]] double value(Subset subset) const override {
    const MatrixXd chosen = chosen_columns(factored_.reduced.triangle, subset);
    const Eigen::HouseholderQR<MatrixXd> qr(chosen);
    const MatrixXd inner = qr.householderQ() * MatrixXd::Identity(chosen.rows(), chosen.cols());
    const MatrixXd basis = factored_.basis * inner;
    VectorXd rotated = qr.householderQ().adjoint() * factored_.reduced.rotated;
    rotated.head(chosen.cols()).setZero();
    const VectorXd left = qr.householderQ() * rotated;
    const VectorXd residuals = factored_.remainder + factored_.basis * left;
    const VectorXd independence = 1.0 - basis.rowwise().squaredNorm().array();
    if (independence.minCoeff() < kAlone) return std::numeric_limits<double>::infinity();
    return (residuals.array() / independence.array()).square().mean();
  }
  [[nodiscard]] double bound(Subset subset) const override {
    return residual_sum(factored_.reduced, subset) / factored_.reduced.rows;
  }

 private:
  Factored factored_;
};

class Regularity final : public SubsetCriterion {
 public:
  Regularity(const Regression& fitting, const Regression& checking)
      : fitting_(factor(fitting, false).reduced), checking_(factor(checking, false).reduced) {}
  [[nodiscard]] std::size_t columns() const override {
    return static_cast<std::size_t>(fitting_.triangle.cols());
  }
  [[nodiscard]] double value(Subset subset) const override {
    const VectorXd error =
        checking_.rotated - chosen_columns(checking_.triangle, subset) * coefficients(fitting_, subset);
    return (error.squaredNorm() + checking_.rest) / checking_.rows;
  }
  [[nodiscard]] double bound(Subset subset) const override {
    return residual_sum(checking_, subset) / checking_.rows;
  }

 private:
  Reduced fitting_;
  Reduced checking_;
};

class Unbiasedness final : public SubsetCriterion {
 public:
  Unbiasedness(const Regression& first, const Regression& second)
      : first_(factor(first, false).reduced), second_(factor(second, false).reduced) {}
  [[nodiscard]] std::size_t columns() const override {
    return static_cast<std::size_t>(first_.triangle.cols());
  }
  [[nodiscard]] double value(Subset subset) const override {
    const VectorXd difference = coefficients(first_, subset) - coefficients(second_, subset);
    return ((chosen_columns(first_.triangle, subset) * difference).squaredNorm() +
            (chosen_columns(second_.triangle, subset) * difference).squaredNorm()) /
           (first_.rows + second_.rows);
  }
  [[nodiscard]] double bound(Subset /*subset*/) const override { return 0.0; }

 private:
  Reduced first_;
  Reduced second_;
};

}  // namespace

std::unique_ptr<SubsetCriterion> press_criterion(const Regression& rows) {
  return std::make_unique<Press>(rows);
}

std::unique_ptr<SubsetCriterion> regularity_criterion(const Regression& fitting, const Regression& checking) {
  return std::make_unique<Regularity>(fitting, checking);
}

std::unique_ptr<SubsetCriterion> unbiasedness_criterion(const Regression& first, const Regression& second) {
  return std::make_unique<Unbiasedness>(first, second);
}

}  // namespace proofmass
