// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "proofmass/core/text.hpp"
#include "proofmass/stand/twin/simulation.hpp"

namespace proofmass {
namespace {

constexpr std::string_view kOrigin = "simulated from ";

double micro(double value) { return value * 1e6; }

std::string describe_inputs(const SimulationPlan& plan) {
  if (plan.sphere) {
    return fmt::format("specific force: {} to {} g, directions uniform over the sphere", plan.sphere->minimum,
                       plan.sphere->maximum);
  }
  if (!plan.mounted) return "specific force: none";
  return fmt::format("specific force: {} at {}", amount_text(plan.mounted->mounts.size(), "mount"),
                     amount_text(plan.mounted->levels.size(), "level"));
}

std::string describe_unmodelled(const UnmodelledStructure& structure) {
  return fmt::format("beyond the model: {:.6g} ug * tanh(Ai / {:.6g} g) + {:.6g} ug * (Ai / {:.6g} g)^4",
                     micro(structure.saturating), structure.saturation_range, micro(structure.fourth_order),
                     structure.fourth_order_range);
}

std::string describe_noise(const OutputNoise& noise) {
  std::string text = fmt::format("output noise: sigma {:.6g} ug", micro(noise.sigma));
  if (noise.sigma_per_g > 0.0) text += fmt::format(" and {:.6g} ug per g", micro(noise.sigma_per_g));
  if (noise.student_dof)
    text += fmt::format(", Student t with {:.6g} degrees of freedom", *noise.student_dof);
  if (noise.outlier_fraction > 0.0) {
    text += fmt::format(", a fraction of {:.6g} outliers of {:.6g} ug", noise.outlier_fraction,
                        micro(noise.outlier_magnitude));
  }
  return text;
}

std::string describe_recorded(const SimulationPlan& plan) {
  const auto& sigma = plan.input_sigma;
  if (std::all_of(sigma.begin(), sigma.end(), [](double s) { return s == 0.0; })) {
    return "inputs: the true specific force";
  }
  return fmt::format(
      "inputs: as measured, the true specific force plus noise of sigma {:.6g}, {:.6g}, {:.6g} ug",
      micro(sigma[0]), micro(sigma[1]), micro(sigma[2]));
}

}  // namespace

std::vector<std::string> describe(const SimulationPlan& plan, std::size_t rows, std::uint64_t seed) {
  const std::string name = plan.source.empty() ? "a plan" : plan.source;
  std::vector<std::string> lines{
      fmt::format("{}{}: {}, seed {}", kOrigin, name, amount_text(rows, "row"), seed), describe_inputs(plan),
      describe_noise(plan.noise), describe_recorded(plan)};
  const UnmodelledStructure& structure = plan.unmodelled;
  if (structure.saturating != 0.0 || structure.fourth_order != 0.0)
    lines.push_back(describe_unmodelled(structure));
  return lines;
}

std::string plan_named_in(std::istream& record) {
  for (std::string line; std::getline(record, line) && line.starts_with('#');) {
    const std::size_t start = line.find_first_not_of("# ");
    const std::size_t end = line.rfind(": ");
    if (start == std::string::npos || end == std::string::npos) continue;
    if (line.compare(start, kOrigin.size(), kOrigin) != 0 || end < start + kOrigin.size()) continue;
    return line.substr(start + kOrigin.size(), end - start - kOrigin.size());
  }
  return {};
}

}  // namespace proofmass
