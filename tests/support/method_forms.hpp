// SPDX-License-Identifier: Apache-2.0
// Every identification method in all of its forms, for tests that every method must pass.
#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "proofmass/identify/method.hpp"

namespace proofmass::test {

// A method, and the options that select a form other than the default.
struct Form {
  Method method;
  std::string label;
  bool with_sigma = false;  // the records have sigma_E
  double rounding = 1e-10;  // relative error of a coefficient that is allowed to an exact method
  bool takes_one_axis = true;
  bool settles = true;              // false: a rounding error may change the course of the search
  bool exact_without_noise = true;  // false: the method does not promise it, or the form cannot
};

inline void PrintTo(const Form& form, std::ostream* out) { *out << form.label; }

inline Form form_of(Method method, std::string label = {}) {
  Form form{.method = std::move(method), .label = std::move(label)};
  const MethodInfo& about = info(form.method);
  if (form.label.empty()) form.label = about.name;
  std::replace(form.label.begin(), form.label.end(), '-', '_');
  form.exact_without_noise = about.exact_without_noise;
  return form;
}

// Every method in its default form, followed by the other forms.
inline std::vector<Form> method_forms() {
  std::vector<Form> list;
  for (const Method& method : methods()) list.push_back(form_of(method));
  list.push_back(form_of(Wls{.weights = WeightSource::sigma}, "wls_sigma"));
  list.back().with_sigma = true;
  list.push_back(form_of(Robust{.loss = LossKind::huber, .tuning = {}}, "robust_huber"));
  list.push_back(form_of(Robust{.loss = LossKind::student, .tuning = {}}, "robust_t"));
  list.push_back(form_of(Gmdh{.form = GmdhForm::mia}, "gmdh_mia"));
  list.back().exact_without_noise = false;  // quadratics of quadratics are truncated to the terms
  list.back().rounding = 1e-6;              // errors accumulate over the layers
  list.back().takes_one_axis = false;
  list.push_back(form_of(Afsa{.target = {}, .coordinates = FishCoordinates::columns}, "afsa_columns"));
  list.back().settles = false;
  return list;
}

// Gives a method a small network and a small swarm where it has them, and the uncertainties of the twin where
// it needs some. A hybrid keeps its defaults.
inline void make_small(Method& method) {
  set_hidden(method, 3);
  if (NetworkOptions* const network = network_options(method)) {
    network->training.epochs = 600;
  }
  if (auto* const swarm = std::get_if<PsoBp>(&method)) {
    swarm->particles = 12;
    swarm->iterations = 8;
  }
  constexpr UncertaintyOptions kTwin{.input = 2e-4, .output = 3e-4};
  if (auto* const tls = std::get_if<Tls>(&method)) tls->uncertainty = kTwin;
  if (auto* const eiv = std::get_if<Eiv>(&method)) eiv->uncertainty = kTwin;
}

}  // namespace proofmass::test
