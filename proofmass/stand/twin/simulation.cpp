// SPDX-License-Identifier: Apache-2.0
#include "proofmass/stand/twin/simulation.hpp"

#include <cmath>
#include <span>
#include <string>

#include "proofmass/core/error.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// Uniform over the sphere (Marsaglia, Annals of Mathematical Statistics 43, 1972).
Acceleration random_direction(RandomStream& random) noexcept {
  double u = 0.0;
  double v = 0.0;
  double square = 0.0;
  do {
    u = random.uniform(-1.0, 1.0);
    v = random.uniform(-1.0, 1.0);
    square = u * u + v * v;
  } while (square >= 1.0);
  const double factor = 2.0 * std::sqrt(1.0 - square);
  return {.i = u * factor, .o = v * factor, .p = 1.0 - 2.0 * square};
}

Acceleration draw_on_sphere(const SphereInputs& inputs, std::size_t row, std::uint64_t seed) noexcept {
  RandomStream directions(seed, stream_id("simulate direction", row));
  RandomStream magnitudes(seed, stream_id("simulate magnitude", row));
  const Acceleration direction = random_direction(directions);
  const double size = inputs.minimum + (inputs.maximum - inputs.minimum) * magnitudes.uniform();
  return {.i = size * direction.i, .o = size * direction.o, .p = size * direction.p};
}

const Mount& mount_of(const MountedInputs& inputs, std::size_t row) {
  return inputs.mounts[row / inputs.levels.size() % inputs.mounts.size()];
}

Acceleration mounted_acceleration(const MountedInputs& inputs, std::size_t row) {
  const Mount& mount = mount_of(inputs, row);
  const double level = inputs.levels[row % inputs.levels.size()];
  const std::array<double, 3> up = mount.up.value_or(std::array<double, 3>{});
  const auto along = [&](std::size_t axis) { return level * mount.radial[axis] + inputs.gravity * up[axis]; };
  return {.i = along(0), .o = along(1), .p = along(2)};
}

double draw_noise(const OutputNoise& noise, double size, std::size_t row, std::uint64_t seed) noexcept {
  RandomStream draws(seed, stream_id("simulate noise", row));
  RandomStream outliers(seed, stream_id("simulate outlier", row));
  double value =
      noise.scale(size) * (noise.student_dof ? draws.student_t(*noise.student_dof) : draws.normal());
  if (outliers.uniform() < noise.outlier_fraction) {
    value += outliers.uniform() < 0.5 ? -noise.outlier_magnitude : noise.outlier_magnitude;
  }
  return value;
}

// Standard deviation of the noise draws over their scale.
double deviation_factor(const OutputNoise& noise) {
  if (!noise.student_dof) return 1.0;
  const double dof = *noise.student_dof;
  if (!(dof > 2.0)) {
    throw usage_error("Student noise with 2 or fewer degrees of freedom has no standard deviation to record");
  }
  return std::sqrt(dof / (dof - 2.0));
}

void append_inputs(const SimulationPlan& plan, const Acceleration& truth, std::size_t row, std::uint64_t seed,
                   Dataset& record) {
  RandomStream draws(seed, stream_id("simulate input noise", row));
  const std::array<double, 3> components{truth.i, truth.o, truth.p};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    record.acceleration[axis].push_back(components[axis] + plan.input_sigma[axis] * draws.normal());
    if (plan.record_sigma && plan.input_sigma[axis] > 0.0) {
      record.acceleration_sigma[axis].push_back(plan.input_sigma[axis]);
    }
  }
}

void require_finite(const Dataset& record, std::size_t row) {
  const Acceleration a = record.at(row);
  if (std::isfinite(record.output.back()) && std::isfinite(a.i + a.o + a.p)) return;
  throw bad_data({.file = record.source, .row = 0, .column = {}},
                 message("numbers beyond double precision in simulated row {}", row + 1),
                 "coefficients, inputs and noise of plausible size");
}

void check(const SimulationPlan& plan, std::size_t rows) {
  if (rows == 0) throw usage_error("a simulation needs at least one row");
  if (plan.sphere.has_value() == plan.mounted.has_value()) {
    throw usage_error("a simulation needs either a range of specific force or mounts and levels");
  }
  if (plan.mounted && plan.mounted->points() == 0) {
    throw usage_error("a simulation by mounts needs at least one mount and one level");
  }
}

Dataset empty_record(const SimulationPlan& plan) {
  Dataset record;
  record.output_unit = plan.output_unit;
  record.acceleration_unit = plan.acceleration_unit;
  record.source = plan.source;
  return record;
}

}  // namespace

double OutputNoise::scale(double size) const noexcept {
  if (sigma_per_g == 0.0) return sigma;
  const double growing = sigma_per_g * size;
  return std::sqrt(sigma * sigma + growing * growing);
}

double UnmodelledStructure::output(const Acceleration& a) const noexcept {
  if (saturating == 0.0 && fourth_order == 0.0) return 0.0;
  const double ratio = a.i / fourth_order_range;
  return saturating * std::tanh(a.i / saturation_range) + fourth_order * ratio * ratio * ratio * ratio;
}

StaticModel SimulationPlan::truth() const {
  StaticModel scaled = model;
  for (double& coefficient : scaled.coefficients) coefficient *= output_per_g;
  return scaled;
}

Dataset simulate(const SimulationPlan& plan, std::size_t rows, std::uint64_t seed) {
  check(plan, rows);
  Dataset record = empty_record(plan);
  const bool noisy = plan.noise.sigma > 0.0 || plan.noise.sigma_per_g > 0.0;
  const double factor = plan.record_sigma && noisy ? deviation_factor(plan.noise) : 0.0;
  for (std::size_t row = 0; row < rows; ++row) {
    const Acceleration a =
        plan.sphere ? draw_on_sphere(*plan.sphere, row, seed) : mounted_acceleration(*plan.mounted, row);
    const double size = magnitude(a);
    append_inputs(plan, a, row, seed, record);
    const double indicated =
        plan.model.output(a) + plan.unmodelled.output(a) + draw_noise(plan.noise, size, row, seed);
    record.output.push_back(plan.output_per_g * indicated);
    require_finite(record, row);
    if (factor > 0.0) record.output_sigma.push_back(plan.output_per_g * factor * plan.noise.scale(size));
    if (plan.mounted) record.mount.push_back(mount_of(*plan.mounted, row).name);
  }
  return record;
}

Dataset simulate(const SimulationPlan& plan) { return simulate(plan, plan.rows, plan.seed); }

}  // namespace proofmass
