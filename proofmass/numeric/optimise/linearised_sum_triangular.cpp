// SPDX-License-Identifier: Apache-2.0
#include <Eigen/QR>
#include <cmath>
#include <utility>

#include "proofmass/numeric/optimise/linearised_sum_internal.hpp"

namespace proofmass {
namespace {

using Eigen::Index;
using Vector = Eigen::VectorXd;
using Rows = Eigen::Map<const Eigen::MatrixXd>;

// Step of the difference quotient along the velocity (Transtrum & Sethna 2012, section 2.2).
constexpr double kDifference = 0.1;

class TriangularFactor final : public LinearisedSum {
 public:
  TriangularFactor(ResidualProblem& problem, std::span<const double> start)
      : problem_(problem),
        n_(static_cast<Index>(start.size())),
        m_(static_cast<Index>(problem.rows())),
        jacobian_(problem.rows(), start.size()),
        residuals_(m_),
        trial_residuals_(m_),
        triangle_(n_, n_) {}

  double evaluate(const Vector& x) override {
    trial_ = x;
    problem_.residuals(view(trial_), {trial_residuals_.data(), problem_.rows()});
    return trial_residuals_.squaredNorm();
  }
  void accept() override {
    point_ = trial_;
    residuals_ = trial_residuals_;
  }

  void linearise() override {
    problem_.jacobian(view(point_), jacobian_);
    gradient_ = rows().transpose() * residuals_;
    factors_.compute(rows());
    triangle_ = factors_.matrixQR().topRows(n_).triangularView<Eigen::Upper>();
    rotated_ = rotated(residuals_);
  }
  [[nodiscard]] const Vector& gradient() const override { return gradient_; }
  [[nodiscard]] Vector diagonal() const override { return triangle_.colwise().squaredNorm().transpose(); }

  // Columns may differ in length by any factor; this only prevents a column of zeros from having no pivot.
  [[nodiscard]] double least_scale() const noexcept override { return 1e-200; }

  bool factor(const Vector& damping) override {
    Eigen::MatrixXd stacked(2 * n_, n_);
    stacked.topRows(n_) = triangle_;
    stacked.bottomRows(n_) = damping.cwiseSqrt().asDiagonal();
    if (!stacked.allFinite()) return false;
    damped_.compute(stacked);
    return (damped_.matrixQR().diagonal().array() != 0.0).all();
  }
  [[nodiscard]] Vector velocity() override { return solve(rotated_); }

  [[nodiscard]] std::optional<Vector> acceleration(const Vector& velocity) override {
    const Vector beyond = point_ + kDifference * velocity;
    Vector second(m_);
    problem_.residuals(view(beyond), {second.data(), problem_.rows()});
    second = 2.0 / kDifference * ((second - residuals_) / kDifference - rows() * velocity);
    return solve(rotated(second));
  }

  [[nodiscard]] double predicted_reduction(const Vector& velocity) const override {
    const Vector moved = triangle_ * velocity;
    return -2.0 * rotated_.dot(moved) - moved.squaredNorm();
  }

 private:
  static std::span<const double> view(const Vector& v) {
    return {v.data(), static_cast<std::size_t>(v.size())};
  }
  [[nodiscard]] Rows rows() const { return {jacobian_.data(), m_, n_}; }
  // The part of v in the column space of J, in the coordinates of its triangle.
  [[nodiscard]] Vector rotated(const Vector& v) const {
    return (factors_.householderQ().adjoint() * v).head(n_);
  }
  // The least-squares solution of [triangle; root of damping] x = -[right; 0].
  [[nodiscard]] Vector solve(const Vector& right) const {
    Vector stacked = Vector::Zero(2 * n_);
    stacked.head(n_) = -right;
    const Vector turned = damped_.householderQ().adjoint() * stacked;
    return damped_.matrixQR().topRows(n_).triangularView<Eigen::Upper>().solve(turned.head(n_));
  }

  ResidualProblem& problem_;
  Index n_;
  Index m_;
  Vector point_;
  Vector trial_;
  Matrix jacobian_;
  Vector residuals_;
  Vector trial_residuals_;
  Vector gradient_;
  Vector rotated_;
  Eigen::MatrixXd triangle_;
  Eigen::HouseholderQR<Eigen::MatrixXd> factors_;
  Eigen::HouseholderQR<Eigen::MatrixXd> damped_;
};

}  // namespace

std::unique_ptr<LinearisedSum> by_triangular_factor(ResidualProblem& problem, std::span<const double> start) {
  return std::make_unique<TriangularFactor>(problem, start);
}

}  // namespace proofmass
