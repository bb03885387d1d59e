// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "proofmass/numeric/random.hpp"
#include "support/nist.hpp"
#include "support/reference_data.hpp"

namespace proofmass {
namespace {

using Vector = std::vector<double>;

// Residuals with an exact Jacobian (residuals x parameters) as a sum of squares that counts its calls.
class Residuals final : public SumOfSquares {
 public:
  using Model = std::function<void(std::span<const double> x, Vector& r, Matrix& jacobian)>;
  Residuals(std::size_t parameters, std::size_t residuals, Model model)
      : model_(std::move(model)), r_(residuals), jacobian_(residuals, parameters) {}

  [[nodiscard]] std::size_t parameters() const override { return jacobian_.columns(); }
  double evaluate(std::span<const double> x) override {
    ++evaluations;
    trial_.assign(x.begin(), x.end());
    const Vector r = residuals_at(trial_);
    double sum = 0.0;
    for (const double value : r) sum += value * value;
    return sum;
  }
  void accept() override {
    ++acceptances;
    current_ = trial_;
  }
  void linearise(Matrix& normal, std::span<double> gradient) override {
    model_(current_, r_, jacobian_);
    for (std::size_t c = 0; c < parameters(); ++c) {
      for (std::size_t k = 0; k < parameters(); ++k)
        normal(k, c) = dot(jacobian_.column(k), jacobian_.column(c));
      gradient[c] = dot(jacobian_.column(c), r_);
    }
  }
  bool curvature(std::span<const double> direction, std::span<double> result) override {
    ++curvatures;
    constexpr double step = 1e-3;
    Vector ahead = current_;
    Vector behind = current_;
    for (std::size_t k = 0; k < ahead.size(); ++k) {
      ahead[k] += step * direction[k];
      behind[k] -= step * direction[k];
    }
    Vector second = residuals_at(ahead);
    const Vector before = residuals_at(behind);
    for (std::size_t i = 0; i < second.size(); ++i) {
      second[i] = (second[i] - 2.0 * r_[i] + before[i]) / (step * step);
    }
    for (std::size_t c = 0; c < parameters(); ++c) result[c] = dot(jacobian_.column(c), second);
    return true;
  }

  std::size_t evaluations = 0, acceptances = 0, curvatures = 0;

 private:
  static double dot(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }
  Vector residuals_at(const Vector& x) const {
    Vector r(r_.size());
    Matrix jacobian(jacobian_.rows(), jacobian_.columns());
    model_(x, r, jacobian);
    return r;
  }

  Model model_;
  Vector r_, current_, trial_;
  Matrix jacobian_;
};

Residuals rosenbrock() {
  return {2, 2, [](std::span<const double> x, Vector& r, Matrix& j) {
            r = {10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]};
            j(0, 0) = -20.0 * x[0];
            j(0, 1) = 10.0;
            j(1, 0) = -1.0;
          }};
}

// Powell's singular function: its Jacobian loses rank at the solution, the origin.
Residuals powell_singular() {
  return {4, 4, [](std::span<const double> x, Vector& r, Matrix& j) {
            const double a = x[1] - 2.0 * x[2];
            const double b = x[0] - x[3];
            r = {x[0] + 10.0 * x[1], std::sqrt(5.0) * (x[2] - x[3]), a * a, std::sqrt(10.0) * b * b};
            j(0, 0) = 1.0;
            j(0, 1) = 10.0;
            j(1, 2) = std::sqrt(5.0);
            j(1, 3) = -std::sqrt(5.0);
            j(2, 1) = 2.0 * a;
            j(2, 2) = -4.0 * a;
            j(3, 0) = 2.0 * std::sqrt(10.0) * b;
            j(3, 3) = -2.0 * std::sqrt(10.0) * b;
          }};
}

// One row per residual, three random columns. The last residual, 1, cannot be reduced.
Residuals linear() {
  return {3, 11, [](std::span<const double> x, Vector& r, Matrix& j) {
            RandomStream random(9);
            for (std::size_t i = 0; i < 10; ++i) {
              r[i] = 0.0;
              for (std::size_t k = 0; k < 3; ++k) {
                j(i, k) = random.normal();
                r[i] += j(i, k) * (x[k] - static_cast<double>(k + 1));
              }
            }
            r[10] = 1.0;
          }};
}

struct Variant {
  std::string name;
  LevenbergMarquardtOptions options;
};
void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.name; }

std::vector<Variant> variants(bool scaled_only = false) {
  std::vector<Variant> list;
  for (const Damping damping : {Damping::multiplicative, Damping::gain_ratio}) {
    for (const bool scaled : {false, true}) {
      if (scaled_only && !scaled) continue;
      for (const bool geodesic : {false, true}) {
        list.push_back({std::string(damping == Damping::gain_ratio ? "gain_ratio" : "multiplicative") +
                            (scaled ? "_scaled" : "_identity") + (geodesic ? "_geodesic" : ""),
                        {.damping = damping, .scaled = scaled, .geodesic_acceleration = geodesic}});
      }
    }
  }
  return list;
}

void expect_consistent(const LevenbergMarquardtResult& result, const Residuals& problem) {
  EXPECT_EQ(result.history.size(), result.iterations + 1);
  EXPECT_EQ(result.history.back(), result.sum_of_squares);
  EXPECT_TRUE(std::is_sorted(result.history.rbegin(), result.history.rend()));
  EXPECT_EQ(problem.acceptances, result.iterations + 1);
  EXPECT_EQ(result.evaluations, problem.evaluations + problem.curvatures);
  EXPECT_FALSE(result.termination.remarks.empty());
}

class LevenbergMarquardt : public testing::TestWithParam<Variant> {
 protected:
  LevenbergMarquardtResult run(Residuals problem, const Vector& start) {
    auto result = minimise(problem, start, GetParam().options);
    expect_consistent(result, problem);
    EXPECT_EQ(problem.evaluate(result.point), result.sum_of_squares);
    return result;
  }
};
INSTANTIATE_TEST_SUITE_P(Variants, LevenbergMarquardt, testing::ValuesIn(variants()),
                         [](const auto& variant) { return variant.param.name; });

TEST_P(LevenbergMarquardt, FindsTheBottomOfRosenbrocksValley) {
  const auto result = run(rosenbrock(), {-1.2, 1.0});
  EXPECT_NEAR(result.point[0], 1.0, 1e-10);
  EXPECT_NEAR(result.point[1], 1.0, 1e-10);
  EXPECT_LT(result.iterations, 60U);
}

TEST_P(LevenbergMarquardt, ConvergesWhereTheJacobianLosesRank) {
  const auto result = run(powell_singular(), {3.0, -1.0, 0.0, 1.0});
  EXPECT_LT(result.sum_of_squares, 1e-20);
  for (const double x : result.point) EXPECT_LT(std::abs(x), 1e-4);
}

TEST_P(LevenbergMarquardt, SolvesALinearProblemInAFewSteps) {
  const auto result = run(linear(), {100.0, -50.0, 7.0});
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(result.point[k], static_cast<double>(k + 1), 1e-7);
  EXPECT_NEAR(result.sum_of_squares, 1.0, 1e-14);
  EXPECT_LE(result.iterations, 12U);
  // Only rounding is left to gain, which is no proof of optimality.
  EXPECT_EQ(result.termination.cause, Cause::stalled);
}

// Each residual y - f(x; b), with the model's value and derivatives by `f`.
Residuals regression(const test::NistProblem& data,
                     std::function<double(double x, std::span<const double> b, Vector& derivatives)> f) {
  const std::size_t parameters = data.certified.size();
  return {parameters, data.y.size(), [data, f, parameters](std::span<const double> b, Vector& r, Matrix& j) {
            Vector derivatives(parameters);
            for (std::size_t i = 0; i < r.size(); ++i) {
              r[i] = data.y[i] - f(data.x[0][i], b, derivatives);
              for (std::size_t k = 0; k < parameters; ++k) j(i, k) = -derivatives[k];
            }
          }};
}

double misra1a(double x, std::span<const double> b, Vector& derivatives) {
  const double decay = std::exp(-b[1] * x);
  derivatives = {1.0 - decay, b[0] * x * decay};
  return b[0] * (1.0 - decay);
}

double thurber(double x, std::span<const double> b, Vector& derivatives) {
  const double powers[] = {1.0, x, x * x, x * x * x};
  const double above = b[0] + b[1] * powers[1] + b[2] * powers[2] + b[3] * powers[3];
  const double below = 1.0 + b[4] * powers[1] + b[5] * powers[2] + b[6] * powers[3];
  for (std::size_t k = 0; k < 4; ++k) derivatives[k] = powers[k] / below;
  for (std::size_t k = 4; k < 7; ++k) derivatives[k] = -above * powers[k - 3] / (below * below);
  return above / below;
}

// Damping by the identity ignores that the parameters are 5e-4 and 240 in size, and converges slowly.
class ScaledLevenbergMarquardt : public LevenbergMarquardt {};
INSTANTIATE_TEST_SUITE_P(Variants, ScaledLevenbergMarquardt, testing::ValuesIn(variants(true)),
                         [](const auto& variant) { return variant.param.name; });

TEST_P(ScaledLevenbergMarquardt, ReachesCertifiedNonlinearRegressions) {
  const auto folder = test::reference_data("nist/nonlinear");
  if (!folder) GTEST_SKIP() << test::kNoReferenceData;
  for (const auto& [name, f] : {std::pair{"Misra1a.dat", &misra1a}, std::pair{"Thurber.dat", &thurber}}) {
    const test::NistProblem data = test::read_nist(*folder / name);
    ASSERT_EQ(data.starts.size(), 2U);
    for (const Vector& start : data.starts) {
      const auto result = run(regression(data, f), start);
      for (std::size_t k = 0; k < start.size(); ++k) {
        EXPECT_GE(test::correct_digits(result.point[k], data.certified[k]), 6.0) << name << " b" << k + 1;
      }
      EXPECT_GE(test::correct_digits(result.sum_of_squares, data.residual_sum_of_squares), 9.0) << name;
    }
  }
}

// Residuals that become NaN half a unit below the start and beyond.
Residuals with_cliff(double edge) {
  return {1, 1, [edge](std::span<const double> x, Vector& r, Matrix& j) {
            r = {x[0] < edge ? std::numeric_limits<double>::quiet_NaN() : std::exp(x[0])};
            j(0, 0) = std::exp(x[0]);
          }};
}

TEST_P(LevenbergMarquardt, NeverStepsWhereTheSumIsNotANumber) {
  const auto result = run(with_cliff(0.5), {1.0});
  EXPECT_GE(result.point[0], 0.5);
  EXPECT_LT(result.sum_of_squares, result.history.front());
  EXPECT_TRUE(std::isfinite(result.sum_of_squares));
}

TEST_P(LevenbergMarquardt, StartThatIsNotFiniteEndsAtOnce) {
  Residuals problem = with_cliff(0.5);
  const auto result = minimise(problem, Vector{0.0}, GetParam().options);
  EXPECT_EQ(result.termination.cause, Cause::stalled);
  EXPECT_EQ(result.iterations, 0U);
  EXPECT_EQ(result.evaluations, 1U);
  EXPECT_EQ(result.point, Vector{0.0});
  Residuals overflowing = rosenbrock();
  EXPECT_EQ(minimise(overflowing, Vector{1e200, 0.0}, GetParam().options).termination.cause, Cause::stalled);
}

TEST_P(LevenbergMarquardt, ObserverSeesEachStepAndStops) {
  Residuals problem = rosenbrock();
  std::vector<std::size_t> seen;
  const auto result = minimise(problem, Vector{-1.2, 1.0}, GetParam().options,
                               [&](std::size_t iteration, std::span<const double> point, double sum) {
                                 seen.push_back(iteration);
                                 EXPECT_EQ(problem.evaluate(point), sum);
                                 return iteration < 3;
                               });
  EXPECT_EQ(seen, (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(result.termination.cause, Cause::stopped);
  EXPECT_EQ(result.iterations, 3U);
}

TEST(LevenbergMarquardtEnding, TargetGradientAndLimit) {
  const Vector start{-1.2, 1.0};
  Residuals problem = rosenbrock();
  const auto full = minimise(problem, start, {});
  ASSERT_GT(full.iterations, 5U);

  const auto at_target = minimise(problem, start, {.target = 1e-3});
  EXPECT_EQ(at_target.termination.cause, Cause::target_reached);
  EXPECT_LE(at_target.sum_of_squares, 1e-3);
  EXPECT_GT(at_target.history[at_target.iterations - 1], 1e-3);
  // The target is also reached when it takes the last step allowed.
  const auto just = minimise(problem, start, {.iterations = at_target.iterations, .target = 1e-3});
  EXPECT_EQ(just.termination.cause, Cause::target_reached);

  const auto limited = minimise(problem, start, {.iterations = 4});
  EXPECT_EQ(limited.termination.cause, Cause::iteration_limit);
  EXPECT_EQ(limited.iterations, 4U);
  EXPECT_TRUE(std::equal(limited.history.begin(), limited.history.end(), full.history.begin()));

  const auto none = minimise(problem, start, {.iterations = 0});
  EXPECT_EQ(none.point, start);
  EXPECT_EQ(none.termination.cause, Cause::iteration_limit);

  Residuals flat = linear();
  const auto steep = minimise(flat, Vector{100.0, -50.0, 7.0}, {.minimum_gradient = 1e-3});
  EXPECT_EQ(steep.termination.cause, Cause::converged);
  Matrix normal(3, 3);
  Vector gradient(3);
  flat.evaluate(steep.point);
  flat.accept();
  flat.linearise(normal, gradient);
  EXPECT_LE(std::hypot(gradient[0], gradient[1], gradient[2]), 1e-3);
}

TEST(LevenbergMarquardtEnding, StallIsLittleReductionOverTheWindow) {
  Residuals problem = powell_singular();
  const Vector start{3.0, -1.0, 0.0, 1.0};
  // Every step on this problem divides the sum by 16 at most: over two steps that is never below 1 - 1/300.
  const auto result = minimise(problem, start, {.stall_window = 2, .stall_reduction = 1.0 - 1.0 / 300.0});
  EXPECT_EQ(result.termination.cause, Cause::stalled);
  ASSERT_GE(result.iterations, 2U);
  EXPECT_GT(300.0 * result.sum_of_squares, result.history[result.iterations - 2]);
  const auto patient = minimise(problem, start, {.stall_window = 2, .stall_reduction = 1e-6});
  EXPECT_LT(patient.sum_of_squares, 1e-20);
}

TEST(LevenbergMarquardtEnding, ContinuingWithTheFinalDampingIsOneLongRun) {
  const Vector start{-1.2, 1.0};
  Residuals problem = rosenbrock();
  const LevenbergMarquardtOptions options{.damping = Damping::multiplicative, .scaled = false};
  auto first_half = options;
  first_half.iterations = 5;
  const auto before = minimise(problem, start, first_half);
  auto second_half = first_half;
  second_half.mu = before.mu;
  const auto after = minimise(problem, before.point, second_half);
  auto whole = options;
  whole.iterations = 10;
  EXPECT_EQ(minimise(problem, start, whole).point, after.point);
}

// Sums of sines have many stationary points; from most starts the first steps lead away from the minimum.
RC_GTEST_PROP(LevenbergMarquardtProperty, NeverEndsWorseThanItStarted, (std::uint64_t seed)) {
  RandomStream random(seed);
  Vector factors(9);
  for (double& factor : factors) factor = 3.0 * random.normal();
  Residuals problem(3, 3, [&](std::span<const double> x, Vector& r, Matrix& j) {
    for (std::size_t i = 0; i < 3; ++i) {
      r[i] = 0.2;
      for (std::size_t k = 0; k < 3; ++k) {
        r[i] += std::sin(factors[3 * i + k] * x[k]);
        j(i, k) = factors[3 * i + k] * std::cos(factors[3 * i + k] * x[k]);
      }
    }
  });
  const Vector start{random.normal(), random.normal(), random.normal()};
  const double at_start = problem.evaluate(start);
  for (const Variant& variant : variants()) {
    const auto result = minimise(problem, start, variant.options);
    RC_ASSERT(result.sum_of_squares <= at_start);
    RC_ASSERT(result.history.front() == at_start);
    RC_ASSERT(problem.evaluate(result.point) == result.sum_of_squares);
  }
}

}  // namespace
}  // namespace proofmass
