// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/search/gmdh.hpp"

#include <fmt/format.h>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/search/gmdh_forms.hpp"

namespace proofmass {
namespace {

void require_sense(const GmdhOptions& options) {
  if (!(options.checking_share > 0.0 && options.checking_share < 1.0)) {
    throw usage_error(
        fmt::format("the checking share must be between 0 and 1, got {}", options.checking_share));
  }
  if (!(options.tolerance >= 0.0)) {
    throw usage_error(fmt::format("the tolerance must be at least 0, got {}", options.tolerance));
  }
  if (!(options.improvement >= 0.0 && options.improvement < 1.0)) {
    throw usage_error(
        fmt::format("the improvement must be at least 0 and below 1, got {}", options.improvement));
  }
  if (options.layers == 0 || options.survivors < 2 || options.beam == 0) {
    throw usage_error(fmt::format("needs 1 layer, 2 survivors and a beam of 1 at least, got {}, {} and {}",
                                  options.layers, options.survivors, options.beam));
  }
}

}  // namespace

Identification identify_gmdh(const Dataset& training, const Dataset& /*validation*/,
                             const IdentifyOptions& options, Progress& progress) {
  require_sense(options.gmdh);
  Identification result = options.gmdh.form == GmdhForm::combi
                              ? identify_gmdh_combi(training, options, progress)
                              : identify_gmdh_mia(training, options, progress);
  if (!training.output_sigma.empty()) {
    result.diagnostics.notes.emplace_back("sigma_E is not used: gmdh weighs all rows alike");
  }
  return result;
}

}  // namespace proofmass
