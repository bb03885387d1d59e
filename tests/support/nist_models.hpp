// SPDX-License-Identifier: Apache-2.0
// The 27 models of NIST's nonlinear reference sets, as the files state them, with their derivatives.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"
#include "support/dual.hpp"
#include "support/nist.hpp"

namespace proofmass::test {

using NistDual = Dual<9>;  // the largest model has nine parameters
using NistParameters = std::span<const NistDual>;
using NistInputs = std::span<const double>;

struct NistModel {
  std::string_view name;
  NistDual (*value)(NistParameters b, NistInputs x);
  bool log_response = false;
};

namespace nist {

using D = NistDual;
using B = NistParameters;
using X = NistInputs;

inline D square(const D& a) { return a * a; }
inline D bennett5(B b, X x) { return b[0] * pow(b[1] + D(x[0]), D(-1.0) / b[2]); }
inline D saturation(B b, X x) { return b[0] * (D(1.0) - exp(-b[1] * D(x[0]))); }
inline D chwirut(B b, X x) { return exp(-b[0] * D(x[0])) / (b[1] + b[2] * D(x[0])); }
inline D danwood(B b, X x) { return b[0] * pow(D(x[0]), b[1]); }
inline D waves(const D& period, const D& c, const D& s, double x) {
  const D angle = D(2.0 * std::numbers::pi * x) / period;
  return c * cos(angle) + s * sin(angle);
}
inline D enso(B b, X x) {
  return b[0] + waves(D(12.0), b[1], b[2], x[0]) + waves(b[3], b[4], b[5], x[0]) +
         waves(b[6], b[7], b[8], x[0]);
}
inline D eckerle4(B b, X x) { return b[0] / b[1] * exp(D(-0.5) * square((D(x[0]) - b[2]) / b[1])); }
inline D peak(const D& height, const D& centre, const D& width, double x) {
  return height * exp(-square(D(x) - centre) / square(width));
}
inline D gauss(B b, X x) {
  return b[0] * exp(-b[1] * D(x[0])) + peak(b[2], b[3], b[4], x[0]) + peak(b[5], b[6], b[7], x[0]);
}
inline D cubic_over_cubic(B b, X x) {
  const D t(x[0]);
  return (b[0] + t * (b[1] + t * (b[2] + t * b[3]))) / (D(1.0) + t * (b[4] + t * (b[5] + t * b[6])));
}
inline D kirby2(B b, X x) {
  const D t(x[0]);
  return (b[0] + t * (b[1] + t * b[2])) / (D(1.0) + t * (b[3] + t * b[4]));
}
inline D lanczos(B b, X x) {
  const D t(x[0]);
  return b[0] * exp(-b[1] * t) + b[2] * exp(-b[3] * t) + b[4] * exp(-b[5] * t);
}
inline D mgh09(B b, X x) {
  const D t(x[0]);
  return b[0] * (t * t + t * b[1]) / (t * t + t * b[2] + b[3]);
}
inline D mgh10(B b, X x) { return b[0] * exp(b[1] / (D(x[0]) + b[2])); }
inline D mgh17(B b, X x) { return b[0] + b[1] * exp(-b[3] * D(x[0])) + b[2] * exp(-b[4] * D(x[0])); }
inline D misra1b(B b, X x) { return b[0] * (D(1.0) - D(1.0) / square(D(1.0) + b[1] * D(x[0] / 2.0))); }
inline D misra1c(B b, X x) { return b[0] * (D(1.0) - pow(D(1.0) + b[1] * D(2.0 * x[0]), D(-0.5))); }
inline D misra1d(B b, X x) { return b[0] * b[1] * D(x[0]) / (D(1.0) + b[1] * D(x[0])); }
inline D nelson(B b, X x) { return b[0] - b[1] * D(x[0]) * exp(-b[2] * D(x[1])); }
inline D rat42(B b, X x) { return b[0] / (D(1.0) + exp(b[1] - b[2] * D(x[0]))); }
inline D rat43(B b, X x) { return b[0] / pow(D(1.0) + exp(b[1] - b[2] * D(x[0])), D(1.0) / b[3]); }
inline D roszman1(B b, X x) {
  return b[0] - b[1] * D(x[0]) - atan(b[2] / (D(x[0]) - b[3])) / D(std::numbers::pi);
}

}  // namespace nist

inline constexpr NistModel kNistModels[] = {
    {"Bennett5", nist::bennett5},
    {"BoxBOD", nist::saturation},
    {"Chwirut1", nist::chwirut},
    {"Chwirut2", nist::chwirut},
    {"DanWood", nist::danwood},
    {"ENSO", nist::enso},
    {"Eckerle4", nist::eckerle4},
    {"Gauss1", nist::gauss},
    {"Gauss2", nist::gauss},
    {"Gauss3", nist::gauss},
    {"Hahn1", nist::cubic_over_cubic},
    {"Kirby2", nist::kirby2},
    {"Lanczos1", nist::lanczos},
    {"Lanczos2", nist::lanczos},
    {"Lanczos3", nist::lanczos},
    {"MGH09", nist::mgh09},
    {"MGH10", nist::mgh10},
    {"MGH17", nist::mgh17},
    {"Misra1a", nist::saturation},
    {"Misra1b", nist::misra1b},
    {"Misra1c", nist::misra1c},
    {"Misra1d", nist::misra1d},
    {"Nelson", nist::nelson, true},
    {"Rat42", nist::rat42},
    {"Rat43", nist::rat43},
    {"Roszman1", nist::roszman1},
    {"Thurber", nist::cubic_over_cubic},
};

// A set's data as residuals: model minus response.
class NistResiduals final : public ResidualProblem {
 public:
  NistResiduals(const NistModel& model, const NistProblem& data) : model_(model), data_(data) {}

  [[nodiscard]] std::size_t rows() const override { return data_.y.size(); }
  void residuals(std::span<const double> b, std::span<double> result) override {
    for (std::size_t row = 0; row < rows(); ++row) result[row] = at(b, row).value - response(row);
  }
  void jacobian(std::span<const double> b, Matrix& result) override {
    for (std::size_t row = 0; row < rows(); ++row) {
      const NistDual value = at(b, row);
      for (std::size_t k = 0; k < b.size(); ++k) result(row, k) = value.gradient[k];
    }
  }

 private:
  [[nodiscard]] double response(std::size_t row) const {
    return model_.log_response ? std::log(data_.y[row]) : data_.y[row];
  }
  [[nodiscard]] NistDual at(std::span<const double> b, std::size_t row) const {
    std::vector<NistDual> parameters;
    for (std::size_t k = 0; k < b.size(); ++k) parameters.push_back(NistDual::variable(b[k], k));
    std::vector<double> x;
    for (const auto& predictor : data_.x) x.push_back(predictor[row]);
    return model_.value(parameters, x);
  }

  const NistModel& model_;
  const NistProblem& data_;
};

}  // namespace proofmass::test
