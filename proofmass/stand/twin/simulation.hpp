// SPDX-License-Identifier: Apache-2.0
// Simulated test records: a known truth, measured by a stand with known faults.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/static_model.hpp"
#include "proofmass/core/units.hpp"

namespace proofmass {

// Specific force in uniformly random directions (over the sphere), its magnitude uniform over a range.
struct SphereInputs {
  double minimum = 1.0;   // g
  double maximum = 20.0;  // g
};

// How the instrument is fixed to a centrifuge arm or dividing head. Unit vectors in instrument axes (IA, OA,
// PA).
struct Mount {
  std::string name;
  std::array<double, 3> radial{};  // direction of the centripetal specific force: towards the spindle
  std::optional<std::array<double, 3>> up{};  // direction of gravity's reaction; none: gravity is left out
};

// Every mount at every level: A = level * radial + gravity * up; levels change fastest.
struct MountedInputs {
  std::vector<Mount> mounts;
  std::vector<double> levels;  // g
  double gravity = 1.0;        // local gravity, g
  [[nodiscard]] std::size_t points() const noexcept { return mounts.size() * levels.size(); }
};

// Noise of the output, referred to the input, in g: sigma(A) times a standard normal or Student draw, plus
// outliers.
struct OutputNoise {
  double sigma = 0.0;        // g; of the part that does not depend on A
  double sigma_per_g = 0.0;  // g/g; sigma(A) = sqrt(sigma² + (sigma_per_g * |A|)²), |A| the true magnitude
  std::optional<double> student_dof{};  // Student's t instead of the normal; sigma(A) is then its scale
  double outlier_share = 0.0;           // probability that a row is an outlier
  double outlier_magnitude = 0.0;       // g; added with a random sign
  // Scale of the noise (without outliers) at a true magnitude in g.
  [[nodiscard]] double scale(double magnitude) const noexcept;
};

// Structure that the 21 terms lack, in g of indicated acceleration:
//   saturating * tanh(Ai / saturation_range) + fourth_order * (Ai / fourth_order_range)^4.
struct UnmodelledStructure {
  double saturating = 0.0;           // g
  double saturation_range = 1.0;     // g
  double fourth_order = 0.0;         // g, at the range
  double fourth_order_range = 20.0;  // g
  [[nodiscard]] double output(const Acceleration& a) const noexcept;
};

// What to simulate. Every field may be changed after reading it from a file.
struct SimulationPlan {
  StaticModel model;                     // the truth, in g per g^order: indicated acceleration
  std::optional<SphereInputs> sphere;    // one of sphere
  std::optional<MountedInputs> mounted;  // and mounted is there
  UnmodelledStructure unmodelled;        // added to the model
  OutputNoise noise;
  std::array<double, 3> input_sigma{};  // g; recorded inputs are the true ones plus normal noise of this size
  Unit output_unit;                     // of the record
  double output_per_g = 1.0;  // scale factor, output_unit.canonical_symbol() per g of indicated acceleration
  Unit acceleration_unit;     // of the record
  bool record_sigma = false;  // whether the record gets sigma columns, for what has noise
  std::size_t rows = 0;
  std::uint64_t seed = 1;
  std::string source;  // file name of the plan
  // The truth in the record's canonical output unit per g^order: what identification should find.
  [[nodiscard]] StaticModel truth() const;
};

// E = output_per_g * (model(A) + unmodelled(A) + noise), one draw a row. Points of mounted inputs are
// repeated in order to fill the rows. Each purpose and row has a random stream of its own: the same plan,
// rows and seed give the same bits; a change of noise leaves the inputs, and a change of rows the rows in
// common, as they were. Acceleration comes out as measured, with input noise. Throws a usage Error on no
// rows, or on a plan whose inputs are missing or empty, or with sigma recorded for Student noise that has no
// variance.
[[nodiscard]] Dataset simulate(const SimulationPlan& plan, std::size_t rows, std::uint64_t seed);
[[nodiscard]] Dataset simulate(const SimulationPlan& plan);

// What a simulated record is, a line each, for the comments of its file.
[[nodiscard]] std::vector<std::string> describe(const SimulationPlan& plan, std::size_t rows,
                                                std::uint64_t seed);

// The plan that the comments at the head of a record's file, as describe() makes them, say it was simulated
// from; empty where they do not.
[[nodiscard]] std::string plan_named_in(std::istream& record);

}  // namespace proofmass
