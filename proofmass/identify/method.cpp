// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/method.hpp"

#include <array>
#include <string>
#include <type_traits>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/core/nearest.hpp"
#include "proofmass/identify/model/term_rows.hpp"
#include "proofmass/identify/network/presets.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/identify/options/field_text.hpp"

namespace proofmass {
namespace {

// One of each alternative, in the order of the list.
template <std::size_t... index>
std::array<Method, sizeof...(index)> one_of_each(std::index_sequence<index...>) {
  return {Method(std::in_place_index<index>)...};
}

template <typename MethodOrConst>
auto* network_options_of(MethodOrConst& method) {
  using Options = std::conditional_t<std::is_const_v<MethodOrConst>, const NetworkOptions, NetworkOptions>;
  return std::visit(
      [](auto& own) -> Options* {
        if constexpr (requires { own.network; }) {
          return &own.network;
        } else {
          return nullptr;
        }
      },
      method);
}

}  // namespace

std::span<const Method> methods() {
  static const auto all = one_of_each(std::make_index_sequence<std::variant_size_v<Method>>());
  return all;
}

Method find_method(std::string_view name) {
  std::vector<std::string_view> names;
  std::string known;
  for (const Method& method : methods()) {
    if (info(method).name == name) return method;
    names.push_back(info(method).name);
    known += (known.empty() ? "" : ", ") + std::string(info(method).name);
  }
  throw usage_error(
      message("unknown method '{}'; expected one of {}{}", excerpt(name), known, did_you_mean(name, names)));
}

const MethodInfo& info(const Method& method) {
  return std::visit([](const auto& own) -> const MethodInfo& { return own.info; }, method);
}

void require_valid_options(const Method& method) {
  std::visit([](const auto& own) { require_in_range(own); }, method);
}

Identification fit(const Method& method, const Dataset& training, const Dataset& validation,
                   const IdentifyOptions& options, Progress& progress) {
  return std::visit(
      [&](const auto& own) -> Identification {
        if constexpr (std::remove_cvref_t<decltype(own)>::info.predicts_by_network) {
          return fit(own, training, validation, options, progress);
        } else {
          return fit(own, training, options, progress);
        }
      },
      method);
}

double training_fraction(const Method& method, const IdentifyOptions& options) {
  if (options.split) return *options.split;
  return options.split_by == SplitBy::mount ? kTrainingFraction : info(method).training_fraction;
}

SigmaColumns sigma_columns(const Method& method) {
  return std::visit(
      [](const auto& own) {
        if constexpr (requires { own.sigma_columns(); }) {
          return own.sigma_columns();
        } else {
          return SigmaColumns{};
        }
      },
      method);
}

bool takes_inputs_for_uncertain(const Method& method) {
  return std::visit(
      [](const auto& own) {
        return requires { own.uncertainty; };
      },
      method);
}

std::optional<double> constant_input_sigma(const Method& method) {
  return std::visit(
      [](const auto& own) {
        if constexpr (requires { own.uncertainty; }) {
          return own.uncertainty.input;
        } else {
          return std::optional<double>();
        }
      },
      method);
}

NetworkOptions* network_options(Method& method) { return network_options_of(method); }
const NetworkOptions* network_options(const Method& method) { return network_options_of(method); }

void set_hidden(Method& method, std::size_t hidden) {
  if (NetworkOptions* const network = network_options(method)) network->hidden = hidden;
  if (auto* const swarm = std::get_if<PsoBp>(&method)) swarm->grow_to = 0;
}

bool apply_paper_preset(Method& method) {
  if (auto* const bp = std::get_if<Bp>(&method)) return apply_paper_preset(*bp), true;
  if (auto* const pso_bp = std::get_if<PsoBp>(&method)) return apply_paper_preset(*pso_bp), true;
  return false;
}

std::vector<double> predict(const Identification& fit, const Dataset& inputs) {
  if (fit.network) return network_outputs(*fit.network, inputs);
  for (const Method& method : methods()) {
    if (info(method).name == fit.method && info(method).predicts_by_network) {
      throw Error(ErrorKind::bad_data,
                  message("the result of {} comes without its network, which alone predicts", fit.method));
    }
  }
  const StaticModel model = fit.static_model();
  for (const Term term : model.terms) {
    for (const Axis axis : kAxes) {
      if (info(term).uses(axis) && !inputs.has(axis)) {
        throw bad_data({.file = inputs.source, .column = std::string(axis_name(axis))}, "",
                       message("a column with the specific force that the term {} needs", name(term)));
      }
    }
  }
  return static_outputs(model, inputs);
}

}  // namespace proofmass
