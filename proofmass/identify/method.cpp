// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/method.hpp"

#include <array>
#include <string>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/term_rows.hpp"
#include "proofmass/identify/network/bp.hpp"
#include "proofmass/identify/network/hybrid.hpp"
#include "proofmass/identify/network/pso_bp.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/identify/regression/eiv.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "proofmass/identify/regression/robust.hpp"
#include "proofmass/identify/regression/tls.hpp"
#include "proofmass/identify/regression/wls.hpp"
#include "proofmass/identify/search/afsa.hpp"
#include "proofmass/identify/search/gmdh.hpp"

namespace proofmass {
namespace {

SigmaColumns weights_column(const IdentifyOptions& options) {
  return {.output = options.wls.weights != WeightSource::model, .inputs = false};
}

SigmaColumns columns_without_constants(const IdentifyOptions& options) {
  return {.output = !options.uncertainty.output, .inputs = !options.uncertainty.input};
}

constexpr std::array kMethods{
    Method{"ols", "ordinary least squares on the terms of the static model", false, false, true,
           identify_ols},
    Method{"wls", "least squares weighted by sigma_E, or by noise found to grow with |A|", false, false, true,
           identify_wls, weights_column},
    Method{"robust", "M-estimation that holds outliers down (--loss) and lists them", false, false, true,
           identify_robust},
    Method{"bp", "a tanh network trained by back-propagation (Levenberg-Marquardt)", true, true, false,
           identify_bp},
    Method{"pso-bp", "a tanh network whose initial weights come from a particle swarm", true, true, false,
           identify_pso_bp},
    Method{"tls", "mixed least squares and total least squares; a reference, biased for powers", false, false,
           true, identify_tls, columns_without_constants},
    Method{"eiv", "errors in variables: true accelerations found along with the coefficients", false, false,
           true, identify_eiv, columns_without_constants},
    Method{"hybrid", "static model and network together, hidden units chosen by evidence", false, false, true,
           identify_hybrid},
    Method{"gmdh", "terms or polynomial network chosen by an external criterion", false, false, true,
           identify_gmdh},
    Method{"afsa", "an artificial fish swarm over the coefficients; a reference for ols", false, false, false,
           identify_afsa},
};

}  // namespace

std::span<const Method> methods() noexcept { return kMethods; }

const Method& find_method(std::string_view name) {
  std::string known;
  for (const Method& method : kMethods) {
    if (method.name == name) return method;
    known += (known.empty() ? "" : ", ") + std::string(method.name);
  }
  throw usage_error("unknown method '" + std::string(name) + "'; expected one of " + known);
}

std::vector<double> predict(const Identification& fit, const Dataset& inputs) {
  if (fit.network) return network_outputs(*fit.network, inputs);
  for (const Method& method : kMethods) {
    if (method.name == fit.method && method.predicts_by_network) {
      throw bad_data({.file = {}, .row = 0, .column = {}},
                     "a result of " + fit.method + " without its network",
                     "the network, which alone predicts as the fit did");
    }
  }
  const StaticModel model = fit.static_model();
  for (const Term term : model.terms) {
    for (const Axis axis : kAxes) {
      if (info(term).uses(axis) && !inputs.has(axis)) {
        throw bad_data(
            {.file = inputs.source, .column = std::string(axis_name(axis))}, "",
            "a column with the specific force that the term " + std::string(name(term)) + " needs");
      }
    }
  }
  return static_outputs(model, inputs);
}

}  // namespace proofmass
