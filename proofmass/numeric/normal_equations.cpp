// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>

#include "proofmass/numeric/linearised_sum_internal.hpp"

namespace proofmass {
namespace {

using Vector = Eigen::VectorXd;

class NormalEquations final : public LinearisedSum {
 public:
  explicit NormalEquations(SumOfSquares& problem)
      : problem_(problem),
        n_(static_cast<Eigen::Index>(problem.parameters())),
        normal_(problem.parameters(), problem.parameters()),
        gradient_(n_) {}

  double evaluate(const Vector& x) override { return problem_.evaluate({x.data(), problem_.parameters()}); }
  void accept() override { problem_.accept(); }
  void linearise() override { problem_.linearise(normal_, view(gradient_)); }
  [[nodiscard]] const Vector& gradient() const override { return gradient_; }
  [[nodiscard]] Vector diagonal() const override { return normal().diagonal(); }

  [[nodiscard]] double least_scale() const noexcept override { return 1e-30; }

  bool factor(const Vector& damping) override {
    Eigen::MatrixXd damped = normal();
    damped.diagonal() += damping;
    factor_.compute(damped);
    return factor_.info() == Eigen::Success;
  }
  [[nodiscard]] Vector velocity() const override { return -factor_.solve(gradient_); }

  [[nodiscard]] std::optional<Vector> acceleration(const Vector& velocity) override {
    Vector second(n_);
    const std::span<const double> direction(velocity.data(), problem_.parameters());
    if (!problem_.curvature(direction, view(second))) return std::nullopt;
    return -factor_.solve(second);
  }

  [[nodiscard]] double predicted_reduction(const Vector& velocity) const override {
    return -2.0 * gradient_.dot(velocity) - velocity.dot(normal() * velocity);
  }

 private:
  [[nodiscard]] std::span<double> view(Vector& v) const { return {v.data(), problem_.parameters()}; }
  [[nodiscard]] Eigen::Map<const Eigen::MatrixXd> normal() const { return {normal_.data(), n_, n_}; }

  SumOfSquares& problem_;
  Eigen::Index n_;
  Matrix normal_;
  Vector gradient_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace

std::unique_ptr<LinearisedSum> by_normal_equations(SumOfSquares& problem) {
  return std::make_unique<NormalEquations>(problem);
}

}  // namespace proofmass
