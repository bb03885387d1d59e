// SPDX-License-Identifier: Apache-2.0
#include "proofmass/stand/twin/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kRows = 50'000;

SimulationPlan sphere_plan() {
  SimulationPlan plan;
  plan.model = {.terms = {Term::K0, Term::Ki, Term::Koq, Term::Kiop},
                .coefficients = {1e-3, 0.99, 2e-4, -3e-5}};
  plan.sphere = SphereInputs{.minimum = 1.0, .maximum = 20.0};
  plan.rows = kRows;
  return plan;
}

double size_of(const Acceleration& a) { return std::sqrt(a.i * a.i + a.o * a.o + a.p * a.p); }

std::vector<double> noise_of(const SimulationPlan& plan, const Dataset& record) {
  std::vector<double> noise;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    noise.push_back(record.output[row] / plan.output_per_g - plan.model.output(record.at(row)));
  }
  return noise;
}

double mean_of(const std::vector<double>& values, const std::function<double(double)>& f) {
  double sum = 0.0;
  for (const double v : values) sum += f(v);
  return sum / static_cast<double>(values.size());
}

double square(double x) { return x * x; }

TEST(Simulation, SameSeedSameBitsAndOtherSeedOthers) {
  SimulationPlan plan = sphere_plan();
  plan.noise.sigma = 1e-6;
  plan.input_sigma = {1e-6, 1e-6, 1e-6};
  const Dataset a = simulate(plan, 100, 3);
  const Dataset b = simulate(plan, 100, 3);
  const Dataset other = simulate(plan, 100, 4);
  EXPECT_EQ(a.acceleration, b.acceleration);
  EXPECT_EQ(a.output, b.output);
  for (std::size_t row = 0; row < 100; ++row) {
    EXPECT_NE(a.output[row], other.output[row]);
    EXPECT_NE(a.acceleration[2][row], other.acceleration[2][row]);
  }
}

TEST(Simulation, NoiseLeavesInputsAndRowsLeaveTheFirstRows) {
  SimulationPlan plan = sphere_plan();
  const Dataset quiet = simulate(plan, 50, 3);
  plan.noise = {.sigma = 1e-4,
                .sigma_per_g = 1e-5,
                .student_dof = 3.0,
                .outlier_fraction = 0.5,
                .outlier_magnitude = 1};
  const Dataset noisy = simulate(plan, 100, 3);
  for (std::size_t row = 0; row < 50; ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(quiet.acceleration[axis][row], noisy.acceleration[axis][row]);
    }
    EXPECT_NE(quiet.output[row], noisy.output[row]);
  }
}

TEST(Simulation, WithoutNoiseTheOutputIsTheModel) {
  SimulationPlan plan = sphere_plan();
  plan.output_unit = *find_unit("mA");
  plan.output_per_g = 1.25;
  plan.record_sigma = true;
  const Dataset record = simulate(plan, 1000, 1);
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const Acceleration a = record.at(row);
    const double expected = 1.25 * (1e-3 + 0.99 * a.i + 2e-4 * std::abs(a.i) * a.i - 3e-5 * a.i * a.o * a.p);
    ASSERT_NEAR(record.output[row], expected, 1e-14 * 25.0);
    ASSERT_NEAR(plan.truth().output(a), expected, 1e-14 * 25.0);
  }
  EXPECT_EQ(record.output_unit.symbol, "mA");
  EXPECT_TRUE(record.output_sigma.empty());
  EXPECT_TRUE(record.mount.empty());
}

// Archimedes: each coordinate of a uniformly random direction on the sphere is uniform on [-1, 1].
TEST(Simulation, DirectionsAndMagnitudesAreUniform) {
  const Dataset record = simulate(sphere_plan(), kRows, 5);
  std::array<double, 9> moments{};
  std::vector<double> sizes;
  for (std::size_t row = 0; row < kRows; ++row) {
    const Acceleration a = record.at(row);
    const double size = size_of(a);
    sizes.push_back(size);
    const std::array<double, 3> u{a.i / size, a.o / size, a.p / size};
    for (std::size_t k = 0; k < 3; ++k) {
      moments[k] += u[k] / std::sqrt(1.0 / 3.0);
      moments[3 + k] += (u[k] * u[k] - 1.0 / 3.0) / std::sqrt(1.0 / 5.0 - 1.0 / 9.0);
      moments[6 + k] += u[k] * u[(k + 1) % 3] / std::sqrt(1.0 / 15.0);
    }
  }
  for (const double sum : moments) EXPECT_LT(std::abs(sum) / std::sqrt(static_cast<double>(kRows)), 4.0);
  std::sort(sizes.begin(), sizes.end());
  EXPECT_GE(sizes.front(), 1.0 - 1e-12);
  EXPECT_LE(sizes.back(), 20.0 + 1e-12);
  double distance = 0.0;  // Kolmogorov-Smirnov; 1.95 is the 99.9 % point
  for (std::size_t k = 0; k < kRows; ++k) {
    distance = std::max(distance, std::abs((sizes[k] - 1.0) / 19.0 - static_cast<double>(k) / kRows));
  }
  EXPECT_LT(distance * std::sqrt(static_cast<double>(kRows)), 1.95);
}

TEST(Simulation, WhiteNoiseHasItsDeviation) {
  SimulationPlan plan = sphere_plan();
  plan.noise.sigma = 3e-4;
  plan.record_sigma = true;
  plan.output_unit = *find_unit("V");
  plan.output_per_g = 0.5;
  const Dataset record = simulate(plan);
  const auto noise = noise_of(plan, record);
  EXPECT_LT(std::abs(mean_of(noise, [](double x) { return x / 3e-4; })) * std::sqrt(kRows), 4.0);
  EXPECT_NEAR(mean_of(noise, square) / square(3e-4), 1.0, 4.0 * std::sqrt(2.0 / kRows));
  EXPECT_EQ(record.output_sigma, std::vector<double>(kRows, 1.5e-4));
  EXPECT_TRUE(record.acceleration_sigma[0].empty());
}

// Divided by the stated sigma(A), the noise has unit standard deviation below and above 10 g.
TEST(Simulation, HeteroscedasticNoiseGrowsWithAcceleration) {
  SimulationPlan plan = sphere_plan();
  plan.noise = {.sigma = 1e-5, .sigma_per_g = 1e-5};
  plan.record_sigma = true;
  const Dataset record = simulate(plan);
  const auto noise = noise_of(plan, record);
  std::array<double, 2> sum{};
  std::array<double, 2> count{};
  for (std::size_t row = 0; row < kRows; ++row) {
    const double size = size_of(record.at(row));
    const double sigma = 1e-5 * std::sqrt(1.0 + size * size);
    ASSERT_NEAR(record.output_sigma[row], sigma, 1e-12 * sigma);
    const std::size_t part = size < 10.0 ? 0 : 1;
    sum[part] += square(noise[row] / sigma);
    count[part] += 1.0;
  }
  for (std::size_t part = 0; part < 2; ++part) {
    EXPECT_NEAR(sum[part] / count[part], 1.0, 4.0 * std::sqrt(2.0 / count[part]));
  }
}

// Moments of t with v degrees of freedom: variance v/(v - 2), fourth 3v²/((v - 2)(v - 4)).
TEST(Simulation, StudentNoiseHasItsDeviation) {
  SimulationPlan plan = sphere_plan();
  plan.noise = {.sigma = 1e-4, .student_dof = 10.0};
  plan.record_sigma = true;
  const Dataset record = simulate(plan);
  const auto noise = noise_of(plan, record);
  const double variance = 10.0 / 8.0;
  const double fourth = 3.0 * 100.0 / (8.0 * 6.0);
  EXPECT_NEAR(mean_of(noise, square) / 1e-8, variance,
              4.0 * std::sqrt((fourth - variance * variance) / kRows));
  EXPECT_NEAR(record.output_sigma[0], 1e-4 * std::sqrt(1.25), 1e-18);
  plan.noise.student_dof = 2.0;
  EXPECT_THROW(static_cast<void>(simulate(plan)), Error);
  plan.record_sigma = false;
  EXPECT_NO_THROW(static_cast<void>(simulate(plan, 10, 1)));
}

TEST(Simulation, OutliersHaveTheirShareAndSize) {
  SimulationPlan plan = sphere_plan();
  plan.noise = {.outlier_fraction = 0.05, .outlier_magnitude = 0.01};
  double above = 0.0;
  double below = 0.0;
  for (const double n : noise_of(plan, simulate(plan))) {
    if (std::abs(n) < 1e-12) continue;
    ASSERT_NEAR(std::abs(n), 0.01, 1e-12);
    (n > 0.0 ? above : below) += 1.0;
  }
  EXPECT_NEAR(above + below, 0.05 * kRows, 4.0 * std::sqrt(0.05 * 0.95 * kRows));
  EXPECT_NEAR(above - below, 0.0, 4.0 * std::sqrt(above + below));
}

TEST(Simulation, InputNoiseIsInTheRecordAndNotInTheOutput) {
  SimulationPlan plan = sphere_plan();
  const Dataset truth = simulate(plan);
  plan.input_sigma = {1e-3, 2e-3, 0.0};
  plan.record_sigma = true;
  const Dataset measured = simulate(plan);
  EXPECT_EQ(measured.output, truth.output);
  EXPECT_EQ(measured.acceleration[2], truth.acceleration[2]);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::vector<double> errors;
    for (std::size_t row = 0; row < kRows; ++row) {
      errors.push_back((measured.acceleration[axis][row] - truth.acceleration[axis][row]) /
                       plan.input_sigma[axis]);
    }
    EXPECT_NEAR(mean_of(errors, square), 1.0, 4.0 * std::sqrt(2.0 / kRows));
    EXPECT_EQ(measured.acceleration_sigma[axis], std::vector<double>(kRows, plan.input_sigma[axis]));
  }
  EXPECT_TRUE(measured.acceleration_sigma[2].empty());
  EXPECT_NE(describe(plan, 10, 1).back().find("as measured"), std::string::npos);
  EXPECT_NE(describe(sphere_plan(), 10, 1).back().find("true"), std::string::npos);
}

TEST(Simulation, TheCommentsOfARecordNameItsPlan) {
  SimulationPlan plan = sphere_plan();
  plan.source = "twin: two.toml";
  std::string head;
  for (const std::string& line : describe(plan, 10, 1)) head += "# " + line + "\n";
  const auto named_in = [](const std::string& text) {
    std::istringstream file(text);
    return plan_named_in(file);
  };
  EXPECT_EQ(named_in("# a comment\n" + head + "Ai,E\n1,2\n"), "twin: two.toml");
  EXPECT_EQ(named_in("Ai,E\n" + head), "");
  EXPECT_EQ(named_in("# simulated from \n#\nAi,E\n"), "");
  EXPECT_EQ(named_in(""), "");
}

TEST(Simulation, MountsRunThroughTheirLevelsAndRepeat) {
  SimulationPlan plan = sphere_plan();
  plan.sphere.reset();
  plan.mounted = MountedInputs{.mounts = {{.name = "a", .radial = {1, 0, 0}, .up = {{0, 0, -1}}},
                                          {.name = "b", .radial = {0, -1, 0}, .up = {}}},
                               .levels = {2, 5, 9},
                               .gravity = 0.5};
  const Dataset record = simulate(plan, 8, 1);
  EXPECT_EQ(record.acceleration[0], (std::vector<double>{2, 5, 9, 0, 0, 0, 2, 5}));
  EXPECT_EQ(record.acceleration[1], (std::vector<double>{0, 0, 0, -2, -5, -9, 0, 0}));
  EXPECT_EQ(record.acceleration[2], (std::vector<double>{-0.5, -0.5, -0.5, 0, 0, 0, -0.5, -0.5}));
  EXPECT_EQ(record.mount, (std::vector<std::string>{"a", "a", "a", "b", "b", "b", "a", "a"}));
}

TEST(Simulation, RefusesAnIncompletePlan) {
  SimulationPlan plan = sphere_plan();
  EXPECT_THROW(static_cast<void>(simulate(plan, 0, 1)), Error);
  plan.mounted = MountedInputs{};
  EXPECT_THROW(static_cast<void>(simulate(plan, 1, 1)), Error);
  plan.sphere.reset();
  EXPECT_THROW(static_cast<void>(simulate(plan, 1, 1)), Error);
}

}  // namespace
}  // namespace proofmass
