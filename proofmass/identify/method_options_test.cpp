// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/method_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/options/field_text.hpp"

namespace proofmass {
namespace {

using testing::StartsWith;

// --- Texts to try ------------------------------------------------------------------------------------------

// One option, and what may and may not be written for it. The texts come from the domain of its field.
struct Trial {
  std::string name;
  std::vector<std::string> good;
  std::vector<std::string> bad;
};

template <typename Number>
Trial trial_of(std::string_view name, const Range<Number>& range) {
  constexpr bool whole = std::is_integral_v<Number>;
  const auto text = [](Number value) {
    if constexpr (whole) {
      return std::to_string(value);
    } else {
      return number_as_text(value);
    }
  };
  Trial trial{.name = std::string(name),
              .good = {},
              .bad = {"", " ", "nan", "inf", "-1", "1x", " 1", "one", "1e999", "99999999999999999999999x"}};
  const Number step = whole ? Number{1} : static_cast<Number>(0.5);
  (range.above_low ? trial.bad : trial.good).push_back(text(range.low));
  if (range.low > Number{}) trial.bad.push_back(text(range.low - step * std::min(range.low, Number{1})));
  if (range.high < std::numeric_limits<Number>::max()) {
    (range.below_high ? trial.bad : trial.good).push_back(text(range.high));
    trial.bad.push_back(text(range.high + step));
  } else {
    trial.good.push_back(text(range.low + 4 * step));
  }
  if constexpr (whole) {
    trial.good.push_back(text(range.low + 1));
    trial.bad.insert(trial.bad.end(), {"1.5", "1e3", "99999999999999999999999"});
  } else {
    trial.good.push_back(text(range.low + step * std::min(range.high - range.low, 1.0)));
  }
  return trial;
}

template <typename Value>
Trial trial_of(std::string_view name, std::span<const Word<Value>> words) {
  Trial trial{.name = std::string(name), .good = {}, .bad = {"", "1", "no-such-word"}};
  for (const Word<Value>& word : words) {
    trial.good.emplace_back(word.text);
    trial.bad.push_back(std::string(word.text) + "x");
  }
  return trial;
}

template <typename Options>
std::vector<Trial> trials_of(const Options& options) {
  std::vector<Trial> trials;
  for_each_field(options, Options::fields, [&trials](const auto& field, const auto& /*value*/) {
    trials.push_back(trial_of(field.name, field.domain));
    if (!field.notes.absent.empty()) trials.back().good.emplace_back(field.notes.absent);
  });
  return trials;
}
std::vector<Trial> trials_of(const Method& method) {
  return std::visit([](const auto& own) { return trials_of(own); }, method);
}

// name -> value.
template <typename Options>
std::map<std::string, std::string> values_of(const Options& options) {
  std::map<std::string, std::string> values;
  for (const OptionInfo& row : options_of(options)) values.emplace(row.name, row.value);
  return values;
}

// Calls check(options, name of what they are of) for every method, and for what all methods take.
template <typename Check>
void for_all(const Check& check) {
  for (const Method& method : methods()) check(method, std::string(info(method).name));
  check(IdentifyOptions{}, std::string("every method"));
}

// --- Reading and writing -----------------------------------------------------------------------------------

TEST(MethodOptions, DefaultsReadBackToThemselves) {
  for_all([](auto options, const std::string& where) {
    const auto before = values_of(options);
    for (const auto& [name, value] : before) {
      EXPECT_FALSE(value.empty()) << where << " " << name;
      EXPECT_TRUE(set_option(options, name, value)) << where << " " << name;
      EXPECT_EQ(values_of(options), before) << where << " " << name;
    }
  });
}

// One option changes and no other, and the default's text brings it back.
TEST(MethodOptions, TakeWhatTheirRangeAllows) {
  for_all([](auto options, const std::string& where) {
    const auto before = values_of(options);
    for (const Trial& trial : trials_of(options)) {
      for (const std::string& text : trial.good) {
        SCOPED_TRACE(where + " " + trial.name + " " + text);
        auto expected = before;
        expected.at(trial.name) = text;
        EXPECT_TRUE(set_option(options, trial.name, text));
        EXPECT_EQ(values_of(options), expected);
        EXPECT_TRUE(set_option(options, trial.name, before.at(trial.name)));
        EXPECT_EQ(values_of(options), before);
      }
    }
  });
}

TEST(MethodOptions, RefuseWhatIsOutsideNamingTheOption) {
  for_all([](auto options, const std::string& where) {
    const auto before = values_of(options);
    for (const Trial& trial : trials_of(options)) {
      for (const std::string& text : trial.bad) {
        SCOPED_TRACE(where + " " + trial.name + " " + text);
        try {
          (void)set_option(options, trial.name, text);
          ADD_FAILURE() << "no error";
        } catch (const Error& error) {
          EXPECT_EQ(error.kind(), ErrorKind::usage);
          EXPECT_THAT(error.what(), StartsWith(trial.name + ": found '" + text + "', expected "));
        }
        EXPECT_EQ(values_of(options), before);
      }
    }
  });
}

TEST(MethodOptions, AnUnknownNameSetsNothing) {
  for_all([](auto options, const std::string& where) {
    const auto before = values_of(options);
    for (const char* const name : {"", "magic", "seed "})
      EXPECT_FALSE(set_option(options, name, "1")) << where << " '" << name << "'";
    EXPECT_EQ(values_of(options), before);
  });
}

// A result is made again from the text that its provenance has, and users find there what they wrote: any
// number of up to twelve digits, in the unit that the option is written in.
RC_GTEST_PROP(MethodOptions, NumbersReadBackToTheirText, ()) {
  const auto digits = *rc::gen::inRange<long long>(1, 1'000'000'000'000);
  const int exponent = *rc::gen::inRange(-14, 4);
  const std::string text = number_as_text(std::stod(std::to_string(digits) + "e" + std::to_string(exponent)));
  for_all([&text](auto options, const std::string& /*where*/) {
    for (const OptionInfo& row : options_of(options)) {
      if (row.type != "X") continue;
      try {
        RC_ASSERT(set_option(options, row.name, text));
      } catch (const Error&) {
        continue;  // out of this option's range
      }
      RC_ASSERT(values_of(options).at(std::string(row.name)) == text);
    }
  });
}

TEST(MethodOptions, MicroGsAreKeptInGs) {
  Method eiv = Eiv{};
  ASSERT_TRUE(set_option(eiv, "sigma-input-ug", "200"));
  EXPECT_DOUBLE_EQ(std::get<Eiv>(eiv).uncertainty.input.value(), 2e-4);
}

// Whoever fills in a struct is told as well, before anything is computed.
TEST(MethodOptions, EveryFitRefusesANumberOutsideItsRange) {
  SilentProgress progress;
  for (const Method& method : methods()) {
    Method changed = method;
    bool has_number = false;
    std::visit(
        [&has_number](auto& own) {
          for_each_field(own, std::remove_reference_t<decltype(own)>::fields,
                         [&](const auto& field, auto& value) {
                           if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, std::size_t>) {
                             if (field.domain.low == 0 || has_number) return;
                             value = 0;
                             has_number = true;
                           }
                         });
        },
        changed);
    if (!has_number) continue;
    SCOPED_TRACE(info(method).name);
    try {
      (void)fit(changed, {}, {}, {}, progress);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_THAT(error.what(), testing::HasSubstr(": found '0', expected a whole number"));
    }
  }
}

// --- Names -------------------------------------------------------------------------------------------------

TEST(MethodOptions, FormerNamesStillWork) {
  std::set<std::string> found;
  for (const Method& method : methods()) {
    const auto before = values_of(method);
    const std::vector<Trial> trials = trials_of(method);
    for (const OptionInfo& row : options_of(method)) {
      if (row.former.empty()) continue;
      found.emplace(std::string(info(method).name) + " " + std::string(row.former));
      EXPECT_TRUE(has_option(method, row.former)) << row.former;
      for (const Trial& trial : trials) {
        if (trial.name != row.name) continue;
        Method changed = method;
        auto expected = before;
        expected.at(trial.name) = trial.good.back();
        ASSERT_NE(expected, before) << "not a change that can be seen";
        EXPECT_TRUE(set_option(changed, row.former, trial.good.back()));
        EXPECT_EQ(values_of(changed), expected) << row.former;
      }
    }
  }
  EXPECT_EQ(found,
            (std::set<std::string>{"bp kicks", "bp validation-share", "pso-bp kicks",
                                   "pso-bp validation-share", "hybrid kicks", "gmdh gmdh-checking-share"}));
}

TEST(MethodOptions, NoTwoOptionsOfAMethodHaveOneName) {
  for (const Method& method : methods()) {
    std::set<std::string_view> names{"method", "model", "terms"};  // taken beside the tables
    for (const auto& rows : {options_of(IdentifyOptions{}), options_of(method)}) {
      for (const OptionInfo& row : rows) {
        EXPECT_FALSE(row.name.empty());
        EXPECT_TRUE(names.insert(row.name).second) << info(method).name << " " << row.name;
        if (!row.former.empty()) {
          EXPECT_TRUE(names.insert(row.former).second) << info(method).name << " " << row.former;
        }
      }
    }
  }
}

// One flag of the command line stands for the option in all of them.
TEST(MethodOptions, SharedOptionsAreOfOneType) {
  std::map<std::string_view, OptionInfo> first;
  std::size_t shared = 0;
  for (const Method& method : methods()) {
    for (const OptionInfo& row : options_of(method)) {
      const auto [at, is_new] = first.emplace(row.name, row);
      if (is_new) continue;
      ++shared;
      EXPECT_EQ(row.type, at->second.type) << info(method).name << " " << row.name;
      EXPECT_EQ(row.range, at->second.range) << info(method).name << " " << row.name;
      EXPECT_EQ(row.former, at->second.former) << info(method).name << " " << row.name;
    }
  }
  EXPECT_GT(shared, 10U);
  EXPECT_THAT(methods_with("refine"), testing::ElementsAre("bp", "pso-bp", "hybrid"));
}

// --- Documentation -----------------------------------------------------------------------------------------

// As GitHub makes it: lower case, punctuation dropped, a hyphen for each space.
std::string anchor_of(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') {
      anchor += '-';
    } else if (std::isalnum(byte) != 0 || c == '-' || c == '_' || byte >= 0x80) {
      anchor += static_cast<char>(std::tolower(byte));
    }
  }
  return anchor;
}

// "page.md", and "page.md#anchor" for every heading outside of code.
std::set<std::string> places_in(const std::filesystem::path& folder) {
  std::set<std::string> places;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".md") continue;
    const std::string page = entry.path().filename().string();
    places.insert(page);
    std::ifstream file(entry.path());
    bool in_code = false;
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("```")) in_code = !in_code;
      const std::size_t level = line.find_first_not_of('#');
      if (in_code || level == 0 || level == std::string::npos || line[level] != ' ') continue;
      places.insert(page + "#" + anchor_of(std::string_view(line).substr(level + 1)));
    }
  }
  return places;
}

TEST(MethodOptions, HaveAPlaceInTheDocumentation) {
  const std::set<std::string> places = places_in(std::filesystem::path(PROOFMASS_SOURCE_DIR) / "docs");
  ASSERT_TRUE(places.contains("commands.md#identify"));
  for (const Method& method : methods()) {
    EXPECT_TRUE(places.contains(std::string(info(method).page))) << info(method).page;
  }
  for_all([&places](const auto& options, const std::string& where) {
    for (const OptionInfo& row : options_of(options)) {
      EXPECT_FALSE(row.help.empty()) << where << " " << row.name;
      EXPECT_TRUE(places.contains(std::string(row.place))) << where << " " << row.name << ": " << row.place;
    }
  });
}

TEST(MethodOptions, HaveTheFiguresAndMethodsOfTheCodeInTheirHelp) {
  std::map<std::string_view, std::string> helps;
  for_all([&helps](const auto& options, const std::string& where) {
    for (const OptionInfo& row : options_of(options)) {
      EXPECT_EQ(row.help.find_first_of("{}"), std::string::npos) << where << " " << row.name;
      helps.emplace(row.name, row.help);
    }
  });
  EXPECT_NE(helps["split"].find("the default of ols, wls, robust, tls and eiv; 0.7 that of the others"),
            std::string::npos)
      << helps["split"];
  EXPECT_NE(helps["split-by"].find("a split of 0.7"), std::string::npos) << helps["split-by"];
  EXPECT_NE(helps["tuning"].find("Huber's k (default 1.345), Tukey's c (4.685)"), std::string::npos)
      << helps["tuning"];
  EXPECT_EQ(help_text("{} or {}, {}", std::array{0.5, 1e-3}), "0.5 or 0.001, {}");
}

// --- Provenance --------------------------------------------------------------------------------------------

TEST(ResolvedOptions, AreAllOptionsOnceInAFixedOrder) {
  for (const Method& method : methods()) {
    const IdentifyOptions options{.terms = parse_terms("K0,Ki"), .seed = 17};
    const auto resolved = resolved_options(method, options);
    std::map<std::string, std::string> expected = values_of(options);
    expected.merge(values_of(method));
    // Under their former names too, for those who read results of 0.1.0.
    for (const OptionInfo& row : options_of(method)) {
      if (!row.former.empty()) expected.emplace(row.former, row.value);
    }
    ASSERT_EQ(resolved.size(), 2 + expected.size());
    EXPECT_EQ(resolved[0], std::pair(std::string("method"), std::string(info(method).name)));
    EXPECT_EQ(resolved[1], std::pair(std::string("model"), std::string("K0, Ki")));
    for (std::size_t k = 2; k < resolved.size(); ++k)
      EXPECT_EQ(resolved[k].second, expected.at(resolved[k].first)) << resolved[k].first;
    EXPECT_EQ(resolved, resolved_options(method, options));
  }
}

}  // namespace
}  // namespace proofmass
