// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/search/gmdh.hpp"

#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/identify/search/gmdh_forms.hpp"

namespace proofmass {
Identification fit(const Gmdh& method, const Dataset& training, const IdentifyOptions& options,
                   Progress& progress) {
  require_in_range(method);
  Identification result = method.form == GmdhForm::combi
                              ? identify_gmdh_combi(method, training, options, progress)
                              : identify_gmdh_mia(method, training, options, progress);
  note_unused_sigma(result, training);
  return result;
}

}  // namespace proofmass
