// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/method_options.hpp"

#include <algorithm>

#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/options/field_text.hpp"

namespace proofmass {
namespace {

template <typename Field>
OptionInfo row_of(const Field& field, const auto& value) {
  OptionInfo row{.name = field.name,
                 .former = field.notes.former,
                 .help = help_text(field.help, field.notes.figures),
                 .place = field.notes.place,
                 .type = {},
                 .range = {},
                 .unit = field.notes.unit,
                 .value = value_text(field, value)};
  if constexpr (requires { field.domain.low; }) {
    row.type = std::is_same_v<decltype(field.domain.low), double> ? "X" : "N";
    row.range = range_text(field.domain);
    // "none" and "default" say that nothing was given; "search" is something to ask for.
    if (field.notes.absent == "search") row.type += "|search";
  } else {
    row.type = list_of(field.domain, "|");
  }
  return row;
}

template <typename Options>
std::vector<OptionInfo> rows_of(const Options& options) {
  std::vector<OptionInfo> rows;
  for_each_field(options, Options::fields,
                 [&rows](const auto& field, const auto& value) { rows.push_back(row_of(field, value)); });
  return rows;
}

// "ols, wls and tls": the methods that fit all rows when no split is asked for.
std::string methods_of_all_rows() {
  std::vector<std::string_view> names;
  for (const Method& method : methods()) {
    if (info(method).training_fraction == 1.0) names.push_back(info(method).name);
  }
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string_view separator = k == 0 ? "" : k + 1 == names.size() ? " and " : ", ";
    text.append(separator).append(names[k]);
  }
  return text;
}

template <typename Options>
bool set(Options& options, std::string_view name, std::string_view text) {
  bool found = false;
  for_each_field(options, Options::fields, [&](const auto& field, auto& value) {
    if (field.name != name && (field.notes.former.empty() || field.notes.former != name)) return;
    read_value(field, value, text);
    found = true;
  });
  return found;
}

}  // namespace

std::vector<OptionInfo> options_of(const Method& method) {
  return std::visit([](const auto& own) { return rows_of(own); }, method);
}

std::vector<OptionInfo> options_of(const IdentifyOptions& options) {
  constexpr std::string_view kMethods = "{methods}";
  std::vector<OptionInfo> rows = rows_of(options);
  for (OptionInfo& row : rows) {
    const std::size_t at = row.help.find(kMethods);
    if (at != std::string::npos) row.help.replace(at, kMethods.size(), methods_of_all_rows());
  }
  return rows;
}

bool has_option(const Method& method, std::string_view name) {
  const std::vector<OptionInfo> rows = options_of(method);
  return std::any_of(rows.begin(), rows.end(), [name](const OptionInfo& row) {
    return row.name == name || (!row.former.empty() && row.former == name);
  });
}

bool set_option(Method& method, std::string_view name, std::string_view text) {
  return std::visit([&](auto& own) { return set(own, name, text); }, method);
}

bool set_option(IdentifyOptions& options, std::string_view name, std::string_view text) {
  return set(options, name, text);
}

std::vector<std::string_view> methods_with(std::string_view option) {
  std::vector<std::string_view> names;
  for (const Method& method : methods()) {
    if (has_option(method, option)) names.push_back(info(method).name);
  }
  return names;
}

std::vector<SharedOption> shared_options() {
  std::vector<SharedOption> all;
  for (const Method& method : methods()) {
    const std::string_view name = info(method).name;
    for (const OptionInfo& option : options_of(method)) {
      const auto same = [&option](const SharedOption& other) { return other.info.name == option.name; };
      const auto known = std::find_if(all.begin(), all.end(), same);
      if (known == all.end()) {
        all.push_back({.info = option, .methods = {name}, .defaults = option.value});
        continue;
      }
      known->methods.push_back(name);
      if (option.value == known->info.value) continue;
      known->defaults.append("; ").append(name).append(": ").append(option.value);
    }
  }
  return all;
}

std::vector<std::pair<std::string, std::string>> resolved_options(const Method& method,
                                                                  const IdentifyOptions& options) {
  std::vector<std::pair<std::string, std::string>> resolved{{"method", std::string(info(method).name)},
                                                            {"model", model_name(options.terms)}};
  for (const auto& rows : {options_of(options), options_of(method)}) {
    for (const OptionInfo& row : rows) {
      resolved.emplace_back(row.name, row.value);
      if (!row.former.empty()) resolved.emplace_back(row.former, row.value);  // as 0.1.0 called it
    }
  }
  return resolved;
}

}  // namespace proofmass
