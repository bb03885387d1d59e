// SPDX-License-Identifier: Apache-2.0
// NIST's nonlinear reference sets, all 27 from both starts. Every set must reach the required digits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <ostream>
#include <string>

#include "support/nist_models.hpp"
#include "support/reference_data.hpp"

namespace proofmass {
namespace test {

void PrintTo(const NistModel& model, std::ostream* out) { *out << model.name; }

}  // namespace test

namespace {

// Out of the eleven digits of the certified values.
constexpr double kDigitsCertified = 11.0;
constexpr double kDigitsRequired = 6.0;
constexpr double kMeanRequired = 9.3;

LevenbergMarquardtOptions careful(double mu = 1e-3) {
  return {.iterations = 2000,
          .scale_memory = 0.5,
          .geodesic_acceleration = true,
          .mu = mu,
          .mu_max = 1e30,
          .polishing_steps = 100};
}

// Correct digits of the worst parameter.
double digits(const test::NistModel& model, std::size_t start, const LevenbergMarquardtOptions& options) {
  const auto path = test::reference_data(fmt::format("nist/nonlinear/{}.dat", model.name));
  const test::NistProblem data = test::read_nist(path.value());
  test::NistResiduals problem(model, data);
  const LevenbergMarquardtResult result = minimise(problem, data.starts.at(start), options);
  double worst = kDigitsCertified;
  for (std::size_t k = 0; k < data.certified.size(); ++k) {
    worst = std::min(worst, test::correct_digits(result.point[k], data.certified[k]));
  }
  return worst;
}

class NistNonlinear : public testing::TestWithParam<test::NistModel> {};

TEST_P(NistNonlinear, ReachesTheCertifiedParametersFromBothStarts) {
  if (!test::reference_data("nist/nonlinear")) GTEST_SKIP() << test::kNoReferenceData;
  const double far = digits(GetParam(), 0, careful());
  const double near = digits(GetParam(), 1, careful());
  RecordProperty("digits_start_1", fmt::format("{:.1f}", far));
  RecordProperty("digits_start_2", fmt::format("{:.1f}", near));
  fmt::print("{:9} worst parameter {:4.1f} digits from start 1, {:4.1f} from start 2\n", GetParam().name, far,
             near);
  EXPECT_GE(far, kDigitsRequired);
  EXPECT_GE(near, kDigitsRequired);
}

INSTANTIATE_TEST_SUITE_P(AllSets, NistNonlinear, testing::ValuesIn(test::kNistModels),
                         [](const auto& model) { return std::string(model.param.name); });

// The initial damping is a guess; the result must not depend on its order of magnitude.
TEST(NistNonlinearMean, HoldsForAnySmallInitialDamping) {
  if (!test::reference_data("nist/nonlinear")) GTEST_SKIP() << test::kNoReferenceData;
  for (const double mu : {1e-6, 1e-5, 1e-4, 1e-3}) {
    double sum = 0.0;
    double worst = kDigitsCertified;
    for (const test::NistModel& model : test::kNistModels) {
      for (const std::size_t start : {0U, 1U}) {
        const double reached = digits(model, start, careful(mu));
        sum += reached;
        worst = std::min(worst, reached);
      }
    }
    const double mean = sum / (2.0 * static_cast<double>(std::size(test::kNistModels)));
    fmt::print("initial damping {:g}: mean {:.2f} digits, worst {:.2f}\n", mu, mean, worst);
    EXPECT_GE(mean, kMeanRequired) << mu;
    EXPECT_GE(worst, kDigitsRequired) << mu;
  }
}

// A straight line, and a third parameter without influence.
class Line final : public ResidualProblem {
 public:
  explicit Line(std::size_t rows) : rows_(rows) {}
  [[nodiscard]] std::size_t rows() const override { return rows_; }
  void residuals(std::span<const double> x, std::span<double> result) override {
    for (std::size_t row = 0; row < rows_; ++row) {
      result[row] = x[0] + 1e8 * static_cast<double>(row) * x[1] - static_cast<double>(row * row);
    }
  }
  void jacobian(std::span<const double> x, Matrix& result) override {
    for (std::size_t row = 0; row < rows_; ++row) {
      result(row, 0) = 1.0;
      result(row, 1) = 1e8 * static_cast<double>(row);
      if (x.size() > 2) result(row, 2) = 0.0;
    }
  }

 private:
  std::size_t rows_;
};

TEST(ResidualMinimisation, LeavesAParameterWithoutInfluenceAlone) {
  Line line(4);
  const std::vector<double> start{5.0, 5.0, 0.25};
  const LevenbergMarquardtResult result = minimise(line, start, careful());
  EXPECT_NEAR(result.point[0], -1.0, 1e-14);  // rows 0, 1, 4, 9: intercept -1, slope 3
  EXPECT_NEAR(result.point[1], 3e-8, 1e-22);
  EXPECT_EQ(result.point[2], 0.25);
}

TEST(ResidualMinimisation, EndsAtOrthogonalResiduals) {
  Line line(4);
  LevenbergMarquardtOptions options = careful();
  options.orthogonality = 1e-9;
  options.polishing_steps = 0;
  const LevenbergMarquardtResult result = minimise(line, std::vector<double>{5.0, 5.0}, options);
  EXPECT_EQ(result.termination.cause, Cause::converged);
  EXPECT_EQ(result.termination.remarks.front().event, Event::residuals_orthogonal);
  EXPECT_NEAR(result.sum_of_squares, 4.0, 1e-12);
}

TEST(ResidualMinimisation, RefusesWhatItCannotSolve) {
  Line line(1);
  EXPECT_THROW((void)minimise(line, std::vector<double>{1.0, 1.0}, careful()), std::invalid_argument);
  Line defined(4);
  const std::vector<double> nowhere{std::numeric_limits<double>::quiet_NaN(), 1.0};
  EXPECT_EQ(minimise(defined, nowhere, careful()).termination.cause, Cause::stalled);
}

}  // namespace
}  // namespace proofmass
