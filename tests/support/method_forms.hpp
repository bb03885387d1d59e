// SPDX-License-Identifier: Apache-2.0
// Every identification method in all of its forms, for tests that every method must pass.
#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofmass/identify/method.hpp"

namespace proofmass::test {

// A method, and the options that select a form other than the default.
struct Form : Method {
  std::string label;
  void (*change)(IdentifyOptions& options) = nullptr;
  bool with_sigma = false;  // the records have sigma_E
  double rounding = 1e-10;  // relative error of a coefficient that is allowed to an exact method
  bool takes_one_axis = true;
  bool settles = true;  // false: a rounding error may change the course of the search
};

inline void PrintTo(const Form& form, std::ostream* out) { *out << form.label; }

inline Form form_of(std::string_view method, std::string label = {},
                    void (*change)(IdentifyOptions&) = nullptr) {
  Form form{find_method(method), std::move(label), change};
  if (form.label.empty()) form.label = method;
  std::replace(form.label.begin(), form.label.end(), '-', '_');
  return form;
}

// Every method in its default form, followed by the other forms.
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
  list.back().exact_without_noise = false;  // quadratics of quadratics are truncated to the terms
  list.back().rounding = 1e-6;              // errors accumulate over the layers
  list.back().takes_one_axis = false;
  list.push_back(form_of("afsa", "afsa_columns",
                         [](IdentifyOptions& o) { o.fish.coordinates = FishCoordinates::columns; }));
  list.back().settles = false;
  return list;
}

}  // namespace proofmass::test
