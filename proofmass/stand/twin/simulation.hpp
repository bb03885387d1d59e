// SPDX-License-Identifier: Apache-2.0
// Simulated test records: an accelerometer with known coefficients on a stand with known noise.
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

// Mounting of the instrument on a centrifuge arm or dividing head. Unit vectors in instrument axes (IA, OA,
// PA).
struct Mount {
  std::string name;
  std::array<double, 3> radial{};  // direction of the centripetal specific force: towards the spindle
  std::optional<std::array<double, 3>> up{};  // direction of gravity's reaction; empty: no gravity
};

// Every mount at every level: A = level * radial + gravity * up. The level changes fastest.
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
  double outlier_fraction = 0.0;        // probability that a row is an outlier
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

// A plan of what to simulate. Every field may be changed after reading it from a file.
struct SimulationPlan {
  StaticModel model;                     // true coefficients, in g per g^order, of indicated acceleration
  std::optional<SphereInputs> sphere;    // exactly one of sphere
  std::optional<MountedInputs> mounted;  // and mounted is set
  UnmodelledStructure unmodelled;        // added to the model
  OutputNoise noise;
  std::array<double, 3> input_sigma{};  // g; recorded inputs are the true ones plus normal noise of this size
  Unit output_unit;                     // of the record
  double output_per_g = 1.0;  // scale factor, output_unit.canonical_symbol() per g of indicated acceleration
  Unit acceleration_unit;     // of the record
  bool record_sigma = false;  // true: the record has sigma columns for the quantities with noise
  std::size_t rows = 0;
  std::uint64_t seed = 1;
  std::string source;  // file name of the plan
  // True coefficients in the record's canonical output unit per g^order: what identification should find.
  [[nodiscard]] StaticModel truth() const;
};

// E = output_per_g * (model(A) + unmodelled(A) + noise), with one noise draw per row. The points of mounted
// inputs are repeated until there are enough rows. Each purpose and row has its own random stream. The same
// plan, rows and seed therefore give the same bits; a change of noise does not change the inputs, and a
// change of the number of rows does not change the common rows. The accelerations returned are the measured
// ones, with input noise. Throws a usage Error when there are no rows, when the inputs of the plan are
// missing or empty, or when sigma is to be recorded for Student noise that has no variance.
[[nodiscard]] Dataset simulate(const SimulationPlan& plan, std::size_t rows, std::uint64_t seed);
[[nodiscard]] Dataset simulate(const SimulationPlan& plan);

// Describes a simulated record, one line per fact, for the comments of its file.
[[nodiscard]] std::vector<std::string> describe(const SimulationPlan& plan, std::size_t rows,
                                                std::uint64_t seed);

// Name of the plan that the comments at the head of a record's file (written by describe()) state. Empty when
// they state none.
[[nodiscard]] std::string plan_named_in(std::istream& record);

}  // namespace proofmass
