// SPDX-License-Identifier: Apache-2.0
// What the defaults of PSO-BP promise on the shipped twins; scripts/accuracy.sh measures more of it.
#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/pipeline.hpp"
#include "support/efficiency.hpp"

namespace proofmass {
namespace {

constexpr std::uint64_t kSeeds = 3;

Identification identified(const Dataset& record, const Method& method, std::uint64_t seed) {
  return identify(record, method, {.terms = parse_terms("full"), .seed = seed}).identification;
}

TEST(PsoBpOnTheTwin, ReachesTheFloorFromEverySeed) {
  const SimulationPlan plan = test::shipped_plan("twin");
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Dataset record = simulate(plan, plan.rows, seed);
    EXPECT_LE(identified(record, PsoBp{}, seed).test->rmse, 1.05 * identified(record, Ols{}, seed).test->rmse)
        << "seed " << seed;
  }
}

// All 21 terms are alive, Koq among them: seven smooth units stay above the noise.
TEST(PsoBpOnTheTwin, GrowsToTheFloor) {
  const SimulationPlan plan = test::shipped_plan("twin-full-45g");
  const Dataset record = simulate(plan, plan.rows, 1);
  const double floor = identified(record, Ols{}, 1).test->rmse;
  const Identification grown = identified(record, PsoBp{}, 1);
  EXPECT_TRUE(mentions(grown.ending.parts, EndingCode::units_added));
  EXPECT_GT(grown.network->hidden, 7U);
  EXPECT_LE(grown.network->hidden, 12U);
  EXPECT_LE(grown.test->rmse, 1.06 * floor);
  const Identification fixed = identified(record, PsoBp{.grow_to = 0}, 1);
  EXPECT_EQ(fixed.network->hidden, 7U);
  EXPECT_GT(fixed.test->rmse, 1.06 * floor);
}

// Structure that the static model lacks is no reason to grow: the network is below least squares.
TEST(PsoBpOnTheTwin, DoesNotGrowTowardsAWrongModel) {
  const SimulationPlan plan = test::shipped_plan("twin-unmodelled");
  const Identification result = identified(simulate(plan, plan.rows, 1), PsoBp{}, 1);
  EXPECT_EQ(result.network->hidden, 7U);
  EXPECT_TRUE(mentions(result.ending.parts, EndingCode::units_suffice));
}

// The root mean square of 63 errors over their standard errors; scattering by a tenth is in its nature.
TEST(PsoBpOnTheTwin, StatesStandardErrorsThatHold) {
  const SimulationPlan plan = test::shipped_plan("twin-300ug");
  const StaticModel truth = plan.truth();
  double squares = 0.0;
  double count = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const Coefficient& c : identified(simulate(plan, plan.rows, seed), PsoBp{}, seed).coefficients) {
      squares += std::pow((c.value - truth.coefficient(c.term)) / *c.standard_error, 2);
      count += 1.0;
    }
  }
  EXPECT_EQ(count, 21.0 * kSeeds);
  EXPECT_GT(std::sqrt(squares / count), 0.8);
  EXPECT_LT(std::sqrt(squares / count), 1.25);
}

}  // namespace
}  // namespace proofmass
