// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Core>
#include <algorithm>

#include "proofmass/numeric/linear/cholesky_kernel.hpp"
#include "proofmass/numeric/optimise/linearised_sum_internal.hpp"

namespace proofmass {
namespace {

using Vector = Eigen::VectorXd;

class NormalEquations final : public LinearisedSum {
 public:
  explicit NormalEquations(SumOfSquares& problem)
      : problem_(problem),
        n_(static_cast<Eigen::Index>(problem.parameters())),
        normal_(problem.parameters(), problem.parameters()),
        gradient_(n_),
        damping_(n_),
        factors_(problem.parameters()) {}

  double evaluate(const Vector& x) override { return problem_.evaluate({x.data(), problem_.parameters()}); }
  void accept() override { problem_.accept(); }
  void linearise() override { problem_.linearise(normal_, view(gradient_)); }
  [[nodiscard]] const Vector& gradient() const override { return gradient_; }
  [[nodiscard]] Vector diagonal() const override { return normal().diagonal(); }

  [[nodiscard]] double least_scale() const noexcept override { return 1e-30; }

  bool factor(const Vector& damping) override {
    damping_ = damping;
    PaddedSquare& damped = factors_.matrix();
    for (std::size_t c = 0; c < damped.n; ++c) {
      std::copy_n(&normal_(c, c), damped.n - c, damped.column(c) + c);
      damped.column(c)[c] += damping(static_cast<Eigen::Index>(c));
    }
    return factors_.factor();
  }
  [[nodiscard]] Vector velocity() override { return solve(gradient_); }

  [[nodiscard]] std::optional<Vector> acceleration(const Vector& velocity) override {
    Vector second(n_);
    const std::span<const double> direction(velocity.data(), problem_.parameters());
    if (!problem_.curvature(direction, view(second))) return std::nullopt;
    return solve(second);
  }

  // -2 gᵀv - vᵀNv where (N + damping) v = -g.
  [[nodiscard]] double predicted_reduction(const Vector& velocity) const override {
    return (velocity.array() * (damping_.array() * velocity.array() - gradient_.array())).sum();
  }

 private:
  [[nodiscard]] std::span<double> view(Vector& v) const { return {v.data(), problem_.parameters()}; }
  [[nodiscard]] Eigen::Map<const Eigen::MatrixXd> normal() const { return {normal_.data(), n_, n_}; }
  // The solution for -b.
  [[nodiscard]] Vector solve(const Vector& b) {
    Vector solution(n_);
    factors_.solve({b.data(), problem_.parameters()}, view(solution));
    return solution;
  }

  SumOfSquares& problem_;
  Eigen::Index n_;
  Matrix normal_;  // the lower triangle
  Vector gradient_, damping_;
  CholeskyFactors factors_;
};

}  // namespace

std::unique_ptr<LinearisedSum> by_normal_equations(SumOfSquares& problem) {
  return std::make_unique<NormalEquations>(problem);
}

}  // namespace proofmass
