// SPDX-License-Identifier: Apache-2.0
#include "proofmass/stand/twin/simulation_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "proofmass/core/error.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"

namespace proofmass {
namespace {

const std::filesystem::path kData = std::filesystem::path(PROOFMASS_SOURCE_DIR) / "data";

// Writes a plan's text to a file.
class PlanFile {
 public:
  explicit PlanFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() /
              ("proofmass-plan-" + std::to_string(::getpid()) + ".toml")) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~PlanFile() { std::filesystem::remove(path_); }
  PlanFile(const PlanFile&) = delete;
  PlanFile& operator=(const PlanFile&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

SimulationPlan read_text(const std::string& text) { return read_simulation(PlanFile(text).path()); }

constexpr const char* kModel = "rows = 10\n[model]\nKi = 1\n";
constexpr const char* kSphere = "[input]\nmaximum_g = 5\n";

TEST(SimulationFile, TwinIsThePapers) {
  const SimulationPlan plan = read_simulation(kData / "twin.toml");
  EXPECT_EQ(plan.model.terms, parse_terms("paper"));
  EXPECT_EQ(plan.model.coefficient(Term::Ki), 0.999979);
  EXPECT_EQ(plan.model.coefficient(Term::Kpoo), 6.58132e-7);
  EXPECT_EQ(plan.model.coefficient(Term::Koq), 0.0);
  ASSERT_TRUE(plan.sphere);
  EXPECT_EQ(plan.sphere->minimum, 1.0);
  EXPECT_EQ(plan.sphere->maximum, 20.0);
  EXPECT_EQ(plan.rows, 2000U);
  EXPECT_EQ(plan.noise.sigma, 1e-6);
  EXPECT_EQ(read_simulation(kData / "twin-10ug.toml").noise.sigma, 1e-5);
  EXPECT_EQ(read_simulation(kData / "twin-300ug.toml").noise.sigma, 3e-4);
  const Dataset record = simulate(plan);
  EXPECT_EQ(record.rows(), 2000U);
  EXPECT_EQ(record.source, "twin.toml");
}

TEST(SimulationFile, TwentyFourMountsAreRightAngledAndDistinct) {
  const SimulationPlan plan = read_simulation(kData / "mounts-24.toml");
  ASSERT_TRUE(plan.mounted);
  EXPECT_EQ(plan.mounted->mounts.size(), 24U);
  EXPECT_EQ(plan.mounted->levels.size(), 16U);
  EXPECT_EQ(plan.rows, 24U * 16U);
  for (const auto& mount : plan.mounted->mounts) {
    ASSERT_TRUE(mount.up);
    double product = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) product += mount.radial[axis] * (*mount.up)[axis];
    EXPECT_EQ(product, 0.0) << mount.name;
  }
}

// One axis always has no load, so Ai*Ao*Ap is zero in every row. All other terms can be identified.
TEST(SimulationFile, TwentyFourMountsReachTwentyTerms) {
  const Dataset record = simulate(read_simulation(kData / "mounts-24.toml"));
  Matrix design(record.rows(), kTermCount);
  for (const auto& entry : all_terms()) {
    const auto column = static_cast<std::size_t>(entry.term);
    for (std::size_t row = 0; row < record.rows(); ++row) {
      design(row, column) = regressor(entry.term, record.at(row));
    }
  }
  const RankAnalysis analysis = analyse_rank(design);
  EXPECT_EQ(analysis.rank, 20U);
  ASSERT_EQ(analysis.independent.size(), 20U);
  EXPECT_EQ(analysis.independent.back(), static_cast<std::size_t>(Term::Kpii));  // all except Kiop
}

TEST(SimulationFile, ReadsEveryKey) {
  const SimulationPlan plan = read_text(
      "rows = 7\nseed = 9\n[model]\nKi = 1\nK0 = 1e-3\n"
      "[input]\nlevels_g = [1, 2.5]\ngravity_g = 0.998\n"
      "[[input.mounts]]\nname = \"x\"\nradial = [0, 3, 4]\nup = [2, 0, 0]\n"
      "[noise]\nsigma_ug = 2\nsigma_ug_per_g = 3\nstudent_dof = 4\noutlier_fraction = 0.25\n"
      "outlier_magnitude_ug = 500\ninput_sigma_ug = [1, 2, 3]\n"
      "[record]\noutput_unit = \"mA\"\noutput_per_g = 1.3\nacceleration_unit = \"m/s^2\"\nsigma = true\n");
  EXPECT_EQ(plan.rows, 7U);
  EXPECT_EQ(plan.seed, 9U);
  EXPECT_EQ(plan.model.terms, (TermList{Term::K0, Term::Ki}));
  EXPECT_EQ(plan.model.coefficients, (std::vector<double>{1e-3, 1.0}));
  ASSERT_TRUE(plan.mounted);
  EXPECT_EQ(plan.mounted->levels, (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(plan.mounted->gravity, 0.998);
  EXPECT_EQ(plan.mounted->mounts[0].radial, (std::array<double, 3>{0.0, 0.6, 0.8}));
  EXPECT_EQ(plan.mounted->mounts[0].up, (std::array<double, 3>{1.0, 0.0, 0.0}));
  EXPECT_EQ(plan.noise.sigma, 2e-6);
  EXPECT_EQ(plan.noise.sigma_per_g, 3e-6);
  EXPECT_EQ(plan.noise.student_dof, 4.0);
  EXPECT_EQ(plan.noise.outlier_fraction, 0.25);
  EXPECT_EQ(plan.noise.outlier_magnitude, 5e-4);
  EXPECT_EQ(plan.input_sigma, (std::array<double, 3>{1e-6, 2e-6, 3e-6}));
  EXPECT_EQ(plan.output_unit.symbol, "mA");
  EXPECT_EQ(plan.output_per_g, 1.3);
  EXPECT_TRUE(plan.acceleration_unit.is_acceleration());
  EXPECT_TRUE(plan.record_sigma);
}

struct BadPlan {
  std::string text;
  std::string named;  // what the message must contain: line, key
};

class SimulationFileErrors : public ::testing::TestWithParam<BadPlan> {};

TEST_P(SimulationFileErrors, NameLineAndKey) {
  try {
    static_cast<void>(read_text(GetParam().text));
    FAIL() << "was accepted:\n" << GetParam().text;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_NE(std::string(error.what()).find(GetParam().named), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("proofmass-plan-"), std::string::npos) << error.what();
  }
}

std::string mounted(const std::string& mounts) {
  return std::string(kModel) + "[input]\nlevels_g = [1]\n" + mounts;
}
std::string sphere(const std::string& more) { return std::string(kModel) + kSphere + more; }

INSTANTIATE_TEST_SUITE_P(
    Plans, SimulationFileErrors,
    ::testing::Values(
        BadPlan{"", "'model'"}, BadPlan{"rows = \n", ":1:"},
        BadPlan{sphere("colour = 1\n"), ":6: key 'input.colour'"},
        BadPlan{sphere("[noise]\nsigma = 1\n"), ":7: key 'noise.sigma'"},
        BadPlan{sphere("[nois]\nsigma_ug = 1\n"), "'nois'"},
        BadPlan{sphere("[noise]\nsigma_ug = -1\n"), ":7: key 'noise.sigma_ug': found '-1'"},
        BadPlan{sphere("[noise]\nsigma_ug = \"1\"\n"), "'noise.sigma_ug'"},
        BadPlan{sphere("[noise]\nsigma_ug = nan\n"), "'noise.sigma_ug'"},
        BadPlan{sphere("[noise]\nsigma_ug_per_g = -1\n"), "'noise.sigma_ug_per_g'"},
        BadPlan{sphere("[noise]\nstudent_dof = 0\n"), "'noise.student_dof'"},
        BadPlan{sphere("[noise]\noutlier_fraction = 1.5\n"), "'noise.outlier_fraction'"},
        BadPlan{sphere("[noise]\ninput_sigma_ug = [1, 2]\n"), "'noise.input_sigma_ug'"},
        BadPlan{sphere("[noise]\ninput_sigma_ug = [1, 2, -3]\n"), "'noise.input_sigma_ug'"},
        BadPlan{sphere("[noise]\ninput_sigma_ug = [1, 2, true]\n"), "'noise.input_sigma_ug'"},
        BadPlan{"rows = 1\n[model]\nKi = 1\nKx = 2\n[input]\nmaximum_g = 1\n", ":4: key 'model.Kx'"},
        BadPlan{"rows = 1\n[model]\nKi = inf\n[input]\nmaximum_g = 1\n", ":3: key 'model.Ki'"},
        BadPlan{"rows = 1\n[model]\n[input]\nmaximum_g = 1\n", "'model'"},
        BadPlan{"rows = 1\nmodel = 3\n[input]\nmaximum_g = 1\n", ":2: key 'model'"},
        BadPlan{kModel, "'input'"},
        BadPlan{std::string(kModel) + "[input]\nminimum_g = 2\n", "'input.maximum_g'"},
        BadPlan{std::string(kModel) + "[input]\nminimum_g = 2\nmaximum_g = 1\n", ":6: key 'input.maximum_g'"},
        BadPlan{std::string(kModel) + "[input]\nlevels_g = [1]\n", "'input.mounts'"},
        BadPlan{mounted("mounts = []\n"), "'input.mounts'"},
        BadPlan{mounted("mounts = 4\n"), "'input.mounts'"},
        BadPlan{mounted("mounts = [4]\n"), "'input.mounts'"},
        BadPlan{mounted("[[input.mounts]]\nradial = [1, 0, 0]\n"), "'input.mounts[1].name'"},
        BadPlan{mounted("[[input.mounts]]\nname = \"a,b\"\nradial = [1, 0, 0]\n"), "'input.mounts[1].name'"},
        BadPlan{mounted("[[input.mounts]]\nname = \"a\"\n"), "'input.mounts[1].radial'"},
        BadPlan{mounted("[[input.mounts]]\nname = \"a\"\nradial = [0, 0, 0]\n"), "'input.mounts[1].radial'"},
        BadPlan{mounted("[[input.mounts]]\nname = \"a\"\nradial = [1, 0]\n"), "'input.mounts[1].radial'"},
        BadPlan{mounted("[[input.mounts]]\nname = \"a\"\nradial = [1, 0, 0]\ndown = [0, 0, 1]\n"),
                "'input.mounts[1].down'"},
        BadPlan{mounted("[[input.mounts]]\nname = \"a\"\nradial = [1, 0, 0]\n"
                        "[[input.mounts]]\nname = \"a\"\nradial = [0, 1, 0]\n"),
                ":10: key 'input.mounts[2].name'"},
        BadPlan{mounted("maximum_g = 3\n[[input.mounts]]\nname = \"a\"\nradial = [1, 0, 0]\n"),
                "'input.maximum_g'"},
        BadPlan{std::string(kModel) +
                    "[input]\nlevels_g = [-1]\n[[input.mounts]]\nname = \"a\"\nradial = [1, 0, 0]\n",
                "'input.levels_g'"},
        BadPlan{std::string(kModel) +
                    "[input]\nlevels_g = []\n[[input.mounts]]\nname = \"a\"\nradial = [1, 0, 0]\n",
                "'input.levels_g'"},
        BadPlan{std::string("[model]\nKi = 1\n") + kSphere, "'rows'"},
        BadPlan{std::string("rows = 0\n[model]\nKi = 1\n") + kSphere, ":1: key 'rows'"},
        BadPlan{std::string("rows = 2.5\n[model]\nKi = 1\n") + kSphere, ":1: key 'rows'"},
        BadPlan{std::string("rows = 1\nseed = -1\n[model]\nKi = 1\n") + kSphere, ":2: key 'seed'"},
        BadPlan{sphere("[record]\noutput_unit = \"furlong\"\n"), "'record.output_unit'"},
        BadPlan{sphere("[record]\noutput_unit = \"K\"\noutput_per_g = 1\n"), "'record.output_unit'"},
        BadPlan{sphere("[record]\noutput_unit = \"mA\"\n"), "'record.output_per_g'"},
        BadPlan{sphere("[record]\noutput_per_g = 2\n"), "'record.output_per_g'"},
        BadPlan{sphere("[record]\noutput_unit = \"mA\"\noutput_per_g = 0\n"), "'record.output_per_g'"},
        BadPlan{sphere("[record]\nacceleration_unit = \"mA\"\n"), "'record.acceleration_unit'"},
        BadPlan{sphere("[noise]\nsigma_ug = 1\nstudent_dof = 2\n[record]\nsigma = true\n"), "'record.sigma'"},
        BadPlan{sphere("[record]\nsigma = 1\n"), "'record.sigma'"}));

TEST(SimulationFile, MissingFileAndDirectoryAreBadData) {
  for (const auto& path : {kData / "no-such.toml", kData}) {
    try {
      static_cast<void>(read_simulation(path));
      FAIL() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_data);
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace proofmass
