// SPDX-License-Identifier: Apache-2.0
#include "identify_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <variant>

#include "initial_swarm.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/identify/method_options.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/options/field_text.hpp"

namespace proofmass::cli {
namespace {

constexpr std::string_view kDefaultMethod = "ols";
constexpr std::array kPresetWords{Word<bool>{"default", false}, Word<bool>{"paper", true}};
constexpr std::array kModelWords{
    Word<std::string_view>{"linear", "linear"}, Word<std::string_view>{"quadratic", "quadratic"},
    Word<std::string_view>{"paper", "paper"}, Word<std::string_view>{"full", "full"}};
constexpr std::string_view kPreset = "preset";
constexpr std::string_view kInitialSwarm = "initial-swarm";
constexpr std::string_view kHidden = "hidden";
constexpr std::string_view kGrowTo = "grow-to";

std::string joined(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

std::string method_help() {
  std::string text = fmt::format("How to identify (default {}):", kDefaultMethod);
  for (const Method& method : methods())
    text += fmt::format("\n  {}: {}", info(method).name, info(method).summary);
  return text;
}

// Names keep their case: "sigma_E", "combi: …".
std::string capitalised(std::string_view text) {
  std::string result(text);
  const std::size_t end = std::min(text.find(' '), text.size());
  const bool is_name = text.substr(0, end).find_first_of("_:") != std::string_view::npos;
  if (!result.empty() && !is_name) {
    result.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(result.front())));
  }
  return result;
}

// " (default 5)"; nothing where the help says what is taken when none is given.
std::string default_text(std::string_view value) {
  return value == "default" || value == "none" ? "" : fmt::format(" (default {})", value);
}

bool was_given(const std::vector<std::pair<std::string, std::string>>& given, std::string_view option) {
  return std::any_of(given.begin(), given.end(), [option](const auto& one) { return one.first == option; });
}

// A number of hidden units that was asked for is the number to use.
void stop_growth(Method& method) {
  if (auto* const swarm = std::get_if<PsoBp>(&method)) swarm->grow_to = 0;
}

bool takes_preset(Method method) { return apply_paper_preset(method); }
bool takes_initial_swarm(const Method& method) { return std::holds_alternative<PsoBp>(method); }

bool takes(const Method& method, std::string_view name) {
  if (name == kPreset) return takes_preset(method);
  if (name == kInitialSwarm) return takes_initial_swarm(method);
  return has_option(method, name);
}

std::vector<std::string_view> takers(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Method& method : methods()) {
    if (takes(method, name)) names.push_back(info(method).name);
  }
  return names;
}

// An option's complaint begins with its name; the flag's with the dashes before it.
template <typename Options>
void set(Options& options, const std::string& name, const std::string& text) {
  try {
    set_option(options, name, text);
  } catch (const Error& error) {
    // By its present name; the user may have typed a former one.
    if (error.message().words() != "{}: {}") throw;
    throw usage_error(message("--{}: {}", name, error.message().values().back()));
  }
}

}  // namespace

void IdentifyFlags::add_given(CLI::App& verb, const std::string& name, const std::string& help,
                              const std::string& type, const std::string& group) {
  const auto take = [this, name](const std::string& text) { given_.emplace_back(name, text); };
  verb.add_option_function<std::string>("--" + name, take, help)->type_name(type)->group(group)->take_last();
}

void IdentifyFlags::take_terms_from(const std::string& flag, const std::string& text) {
  if (!model_.empty() && model_flag_ != flag)
    throw usage_error("--model and --terms both choose the terms: give one of them");
  model_flag_ = flag;
  model_ = text;
}

void IdentifyFlags::add_terms(CLI::App& verb) {
  const auto take_model = [this](const std::string& text) {
    if (text.empty() || word_of(kModelWords, std::string_view(text)) != text) {
      throw not_one_of("--model", text, list_of(kModelWords));
    }
    take_terms_from("model", text);
  };
  const auto take_terms = [this](const std::string& text) {
    if (text.empty()) throw usage_error("--terms: found nothing, expected names of terms, as K0,Ki");
    take_terms_from("terms", text);
  };
  verb.add_option_function<std::string>(
          "--model", take_model,
          "Terms of the model: a preset" + default_text(model_name(IdentifyOptions{}.terms)))
      ->type_name(list_of(kModelWords, "|"));
  verb.add_option_function<std::string>("--terms", take_terms, "Terms of the model, in place of --model")
      ->type_name("K0,Ki,...");
}

void IdentifyFlags::add_common_options(CLI::App& verb) {
  for (const OptionInfo& option : options_of(IdentifyOptions{})) {
    const std::string name(option.name);
    const auto take = [this, name](const std::string& text) { common_.emplace_back(name, text); };
    verb.add_option_function<std::string>("--" + name, take,
                                          capitalised(option.help) + default_text(option.value))
        ->type_name(option.type)
        ->take_last();
  }
}

void IdentifyFlags::add_method_options(CLI::App& verb) {
  for (const SharedOption& option : shared_options()) {
    const std::string unit = option.info.unit.empty() ? "" : fmt::format(", in {}", option.info.unit);
    const std::string help = capitalised(option.info.help) + unit + default_text(option.defaults);
    add_given(verb, std::string(option.info.name), help, option.info.type,
              "Options of " + joined(option.methods));
    // Earlier names are understood and not shown.
    if (!option.info.former.empty()) add_given(verb, std::string(option.info.former), "", "", "");
  }
}

// Presets and files: they set more than one option.
void IdentifyFlags::add_whole_settings(CLI::App& verb) {
  add_given(verb, std::string(kPreset), "Settings to begin with: the program's default, or the paper's",
            list_of(kPresetWords, "|"), "Options of " + joined(takers(kPreset)));
  add_given(verb, std::string(kInitialSwarm),
            "Positions to start from: a line a particle, numbers between commas", "FILE",
            "Options of " + joined(takers(kInitialSwarm)));
}

void IdentifyFlags::add_to(CLI::App& verb, Naming naming) {
  if (naming == Naming::option) {
    const auto take = [this](const std::string& text) { method_ = info(find_method(text)).name; };
    verb.add_option_function<std::string>("--method", take, method_help())->type_name("METHOD");
  }
  add_terms(verb);
  add_common_options(verb);
  add_whole_settings(verb);
  add_method_options(verb);
}

IdentifyOptions IdentifyFlags::options() const {
  IdentifyOptions options;
  if (!model_.empty()) options.terms = parse_terms(model_);
  for (const auto& [name, text] : common_) set(options, name, text);
  return options;
}

void IdentifyFlags::require_one_name() const {
  const auto is_given = [this](std::string_view name) {
    return std::any_of(given_.begin(), given_.end(),
                       [name](const auto& given) { return given.first == name; });
  };
  for (const SharedOption& option : shared_options()) {
    if (option.info.former.empty() || !is_given(option.info.former) || !is_given(option.info.name)) continue;
    throw usage_error(
        message("--{} is the former name of --{}: give one of them", option.info.former, option.info.name));
  }
}

void IdentifyFlags::require_taken(std::span<const Method> chosen) const {
  std::vector<std::string_view> names;
  for (const Method& method : chosen) names.push_back(info(method).name);
  for (const auto& [name, text] : given_) {
    const auto takes_it = [&name = name](const Method& method) { return takes(method, name); };
    if (std::any_of(chosen.begin(), chosen.end(), takes_it)) continue;
    throw usage_error(message("--{} is an option of {}; {} {} not take it", name, joined(takers(name)),
                              joined(names), names.size() == 1 ? Message("does") : Message("do")));
  }
}

std::vector<Method> IdentifyFlags::methods(std::span<const std::string> names) const {
  std::vector<Method> chosen;
  for (const std::string& name : names) chosen.push_back(find_method(name));
  require_one_name();
  require_taken(chosen);
  const auto apply = [this](Method& method) {
    // Settings of the preset first: what is given besides, before or after it, changes them.
    for (const auto& [name, text] : given_) {
      if (name != kPreset) continue;
      if (word_of(kPresetWords, text == "paper") != text) {
        throw not_one_of("--preset", text, list_of(kPresetWords));
      }
      if (text == "paper") apply_paper_preset(method);
    }
    for (const auto& [name, text] : given_) set(method, name, text);
    if (was_given(given_, kHidden) && !was_given(given_, kGrowTo)) stop_growth(method);
    if (auto* const swarm = std::get_if<PsoBp>(&method)) {
      for (const auto& [name, text] : given_) {
        if (name == kInitialSwarm) swarm->initial = read_positions(text);
      }
      if (!swarm->network.hidden && !swarm->initial.empty()) {
        throw usage_error("--initial-swarm is for one size of network; give --hidden a number with it");
      }
    }
  };
  for (Method& method : chosen) apply(method);
  return chosen;
}

Method IdentifyFlags::method() const {
  const std::string name = method_.empty() ? std::string(kDefaultMethod) : method_;
  return methods(std::span(&name, 1)).front();
}

std::vector<std::pair<std::string, std::string>> IdentifyFlags::more(const Method& method) const {
  std::vector<std::pair<std::string, std::string>> more;
  const auto add = [&](std::string_view setting, std::string value) {
    if (!takes(method, setting)) return;
    for (const auto& [name, text] : given_) {
      if (name == setting) value = text;
    }
    more.emplace_back(setting, std::move(value));
  };
  add(kPreset, "default");
  add(kInitialSwarm, "none");
  return more;
}

void add_given(Provenance& provenance, const Method& method, const IdentifyFlags& flags) {
  for (auto& option : flags.more(method)) provenance.options.push_back(std::move(option));
}

}  // namespace proofmass::cli
