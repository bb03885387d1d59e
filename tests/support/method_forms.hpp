// SPDX-License-Identifier: Apache-2.0
// The methods of identification in every form that they have.
#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofmass/identify/method.hpp"

namespace proofmass::test {

// A method, and what makes it take another form than by default.
struct Form : Method {
  std::string label;
  void (*change)(IdentifyOptions& options) = nullptr;
  bool with_sigma = false;  // the records have sigma_E
  double rounding = 1e-10;  // share of a coefficient by which an exact method may vary
  bool takes_one_axis = true;
  bool settles = true;  // otherwise a rounding may send the search another way
};

inline void PrintTo(const Form& form, std::ostream* out) { *out << form.label; }

inline Form form_of(std::string_view method, std::string label = {},
                    void (*change)(IdentifyOptions&) = nullptr) {
  Form form{find_method(method), std::move(label), change};
  if (form.label.empty()) form.label = method;
  std::replace(form.label.begin(), form.label.end(), '-', '_');
  return form;
}

// Every method in its default form, and the other forms that there are.
inline std::vector<Form> method_forms() {
  std::vector<Form> list;
  for (const Method& method : methods()) list.push_back(form_of(method.name));
  list.push_back(
      form_of("wls", "wls_sigma", [](IdentifyOptions& o) { o.wls.weights = WeightSource::sigma; }));
  list.back().with_sigma = true;
  list.push_back(
      form_of("robust", "robust_huber", [](IdentifyOptions& o) { o.robust.fit.loss = LossKind::huber; }));
  list.push_back(
      form_of("robust", "robust_t", [](IdentifyOptions& o) { o.robust.fit.loss = LossKind::student; }));
  list.push_back(form_of("gmdh", "gmdh_mia", [](IdentifyOptions& o) { o.gmdh.form = GmdhForm::mia; }));
  list.back().exact_without_noise = false;  // quadratics of quadratics are cut off into the terms
  list.back().rounding = 1e-6;              // layer upon layer
  list.back().takes_one_axis = false;
  list.push_back(form_of("afsa", "afsa_columns",
                         [](IdentifyOptions& o) { o.fish.coordinates = FishCoordinates::columns; }));
  list.back().settles = false;
  return list;
}

}  // namespace proofmass::test
