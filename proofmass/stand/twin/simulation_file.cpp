// SPDX-License-Identifier: Apache-2.0
#include "proofmass/stand/twin/simulation_file.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "proofmass/stand/toml_table.hpp"
#include "proofmass/stand/twin/paper_twin_internal.hpp"

namespace proofmass {
namespace {

constexpr std::int64_t kMostRows = 100'000'000;
constexpr double kMicroPerUnit = 1e6;  // dividing by it rounds once: 10 ug is 1e-5 g exactly as written

double non_negative(const TomlTable& table, std::string_view key, double otherwise) {
  const double value = table.number(key).value_or(otherwise);
  if (value < 0.0) throw table.error(key, "a number that is not negative");
  return value;
}

double micro(const TomlTable& table, std::string_view key) {
  return non_negative(table, key, 0.0) / kMicroPerUnit;
}

StaticModel read_model(const TomlTable& root) {
  const auto table = root.table("model");
  if (!table) throw root.error("model", "a table of coefficients, such as Ki = 1.0");
  StaticModel model;
  for (const auto& entry : all_terms()) {
    const auto value = table->number(entry.name);
    if (!value) continue;
    model.terms.push_back(entry.term);
    model.coefficients.push_back(*value);
  }
  for (const auto& key : table->keys()) {
    if (!find_term(key)) {
      throw table->error(key, message("a coefficient's name among {}", join_names(parse_terms("full"))));
    }
  }
  if (model.terms.empty()) throw root.error("model", "at least one coefficient");
  return model;
}

void read_unmodelled(const TomlTable& root, SimulationPlan& plan) {
  const auto table = root.table("unmodelled");
  if (!table) return;
  const auto positive = [&table](std::string_view key, double otherwise) {
    const double value = table->number(key).value_or(otherwise);
    if (!(value > 0.0)) throw table->error(key, "a number above zero");
    return value;
  };
  const UnmodelledStructure standard;
  plan.unmodelled = {.saturating = table->number("saturating_ug").value_or(0.0) / kMicroPerUnit,
                     .saturation_range = positive("saturation_range_g", standard.saturation_range),
                     .fourth_order = table->number("fourth_order_ug").value_or(0.0) / kMicroPerUnit,
                     .fourth_order_range = positive("fourth_order_range_g", standard.fourth_order_range)};
  table->finish();
}

SphereInputs read_sphere(const TomlTable& input) {
  const auto maximum = input.number("maximum_g");
  if (!maximum) throw input.error("maximum_g", "the largest specific force, in g");
  const SphereInputs sphere{.minimum = non_negative(input, "minimum_g", 0.0), .maximum = *maximum};
  if (!(sphere.maximum > 0.0) || sphere.maximum < sphere.minimum) {
    throw input.error("maximum_g", "a number above zero and not below minimum_g");
  }
  return sphere;
}

// A direction of any length above zero, normalised to a unit vector.
std::optional<std::array<double, 3>> read_direction(const TomlTable& mount, std::string_view key) {
  const auto values = mount.numbers(key);
  if (!values) return std::nullopt;
  const Message expected = message("three numbers, along IA, OA and PA, not all zero");
  if (values->size() != 3) throw mount.error(key, expected);
  const auto& v = *values;
  const double length = std::hypot(v[0], v[1], v[2]);
  if (!(length > 0.0) || !std::isfinite(length)) throw mount.error(key, expected);
  return std::array<double, 3>{v[0] / length, v[1] / length, v[2] / length};
}

Mount read_mount(const TomlTable& table) {
  const auto name = table.text("name");
  if (!name || name->empty()) throw table.error("name", "the mount's name");
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (name->find_first_of(",;\"#") != std::string::npos || std::any_of(name->begin(), name->end(), control)) {
    throw table.error("name", "a name without separators, quotes, # and control characters");
  }
  const auto radial = read_direction(table, "radial");
  if (!radial) throw table.error("radial", "the direction of the centripetal specific force in (IA, OA, PA)");
  Mount mount{.name = *name, .radial = *radial, .up = read_direction(table, "up")};
  table.finish();
  return mount;
}

std::vector<double> read_levels(const TomlTable& input) {
  auto levels = input.numbers("levels_g");
  if (!levels || levels->empty()) throw input.error("levels_g", "a list of at least one level, in g");
  for (const double level : *levels) {
    if (level < 0.0) throw input.error("levels_g", "levels that are not negative");
  }
  return std::move(*levels);
}

MountedInputs read_mounted(const TomlTable& input, const std::vector<TomlTable>& tables) {
  MountedInputs mounted{
      .mounts = {}, .levels = read_levels(input), .gravity = non_negative(input, "gravity_g", 1.0)};
  std::set<std::string> names;
  for (const auto& table : tables) {
    mounted.mounts.push_back(read_mount(table));
    if (!names.insert(mounted.mounts.back().name).second) {
      throw table.error("name", "a name that no other mount has");
    }
  }
  return mounted;
}

void read_inputs(const TomlTable& root, SimulationPlan& plan) {
  const auto input = root.table("input");
  if (!input) throw root.error("input", "a table with minimum_g and maximum_g, or with levels_g and mounts");
  const auto mounts = input->tables("mounts");
  if (!mounts) {
    if (input->numbers("levels_g")) throw input->error("mounts", "a list of mounts, for there are levels_g");
    plan.sphere = read_sphere(*input);
  } else {
    if (mounts->empty()) throw input->error("mounts", "at least one mount");
    plan.mounted = read_mounted(*input, *mounts);
  }
  input->finish();
}

// By its present name, or by that of 0.1.0.
double outlier_fraction(const TomlTable& noise) {
  const char* const key = noise.number("outlier_share") ? "outlier_share" : "outlier_fraction";
  const double fraction = non_negative(noise, key, 0.0);
  if (fraction > 1.0) throw noise.error(key, "a fraction from 0 to 1");
  return fraction;
}

void read_noise(const TomlTable& root, SimulationPlan& plan) {
  const auto noise = root.table("noise");
  if (!noise) return;
  plan.noise = {.sigma = micro(*noise, "sigma_ug"),
                .sigma_per_g = micro(*noise, "sigma_ug_per_g"),
                .student_dof = noise->number("student_dof"),
                .outlier_fraction = outlier_fraction(*noise),
                .outlier_magnitude = micro(*noise, "outlier_magnitude_ug")};
  if (plan.noise.student_dof && !(*plan.noise.student_dof > 0.0)) {
    throw noise->error("student_dof", "degrees of freedom above zero");
  }
  if (const auto sigma = noise->numbers("input_sigma_ug")) {
    if (sigma->size() != 3) throw noise->error("input_sigma_ug", "three numbers, along IA, OA and PA");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((*sigma)[axis] < 0.0) throw noise->error("input_sigma_ug", "numbers that are not negative");
      plan.input_sigma[axis] = (*sigma)[axis] / kMicroPerUnit;
    }
  }
  noise->finish();
}

Unit read_unit(const TomlTable& table, std::string_view key) {
  const auto text = table.text(key);
  if (!text) return {};
  const auto unit = find_unit(*text);
  if (!unit) throw table.error(key, "a known unit, such as g, m/s^2, mA or V");
  return *unit;
}

void read_record_format(const TomlTable& root, SimulationPlan& plan) {
  const auto record = root.table("record");
  if (!record) return;
  plan.acceleration_unit = read_unit(*record, "acceleration_unit");
  if (!plan.acceleration_unit.is_acceleration()) {
    throw record->error("acceleration_unit",
                        message("a unit of acceleration: {}", known_units(Quantity::acceleration)));
  }
  plan.output_unit = read_unit(*record, "output_unit");
  if (const auto kind = plan.output_unit.quantity; kind == Quantity::time || kind == Quantity::temperature) {
    throw record->error("output_unit", "a unit of an accelerometer's output, such as g, mA or V");
  }
  const auto scale = record->number("output_per_g");
  if (plan.output_unit.is_acceleration() == scale.has_value()) {
    throw record->error("output_per_g",
                        scale ? Message("no scale factor with an output in units of acceleration")
                              : Message("the scale factor, output_unit per g"));
  }
  plan.output_per_g = scale.value_or(1.0);
  if (!(plan.output_per_g > 0.0)) throw record->error("output_per_g", "a number above zero");
  plan.record_sigma = record->boolean("sigma").value_or(false);
  if (plan.record_sigma && plan.noise.student_dof && *plan.noise.student_dof <= 2.0) {
    throw record->error("sigma",
                        "false, for Student noise with 2 or fewer degrees of freedom has no deviation");
  }
  record->finish();
}

void read_size(const TomlTable& root, SimulationPlan& plan) {
  const auto rows = root.integer("rows");
  if (!rows && !plan.mounted) throw root.error("rows", "the number of rows");
  if (rows && (*rows < 1 || *rows > kMostRows))
    throw root.error("rows", "a number of rows from 1 to 100000000");
  plan.rows = rows ? static_cast<std::size_t>(*rows) : plan.mounted->points();
  const auto seed = root.integer("seed").value_or(1);
  if (seed < 0) throw root.error("seed", "an integer that is not negative");
  plan.seed = static_cast<std::uint64_t>(seed);
}

SimulationPlan plan_of(const TomlTable& root, std::string source) {
  SimulationPlan plan;
  plan.source = std::move(source);
  plan.model = read_model(root);
  read_unmodelled(root, plan);
  read_inputs(root, plan);
  read_noise(root, plan);
  read_record_format(root, plan);
  read_size(root, plan);
  root.finish();
  return plan;
}

}  // namespace

SimulationPlan read_simulation(const std::filesystem::path& path) {
  return plan_of(TomlTable::read(path), path.filename().string());
}

SimulationPlan paper_twin() {
  return plan_of(TomlTable::parse(kPaperTwin, "twin-300ug.toml"), "twin-300ug.toml");
}

}  // namespace proofmass
