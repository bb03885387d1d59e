// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/sentence.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace proofmass {
namespace {

// A figure ready to be shown.
struct ShownFigure {
  std::variant<double, std::string> value;
};

}  // namespace
}  // namespace proofmass

template <>
struct fmt::formatter<proofmass::ShownFigure> {
  std::string number_format = "{:";

  // Of "{:?row|rows}" the first words for one, the others for any other number.
  std::string_view words_for(bool one) const {
    const std::string_view words = std::string_view(number_format).substr(3, number_format.size() - 4);
    const std::size_t bar = std::min(words.find('|'), words.size());
    return one ? words.substr(0, bar) : words.substr(std::min(bar + 1, words.size()));
  }
  constexpr auto parse(format_parse_context& context) {
    const auto* end = std::find(context.begin(), context.end(), '}');
    number_format.append(context.begin(), end).append("}");
    return end;
  }
  auto format(const proofmass::ShownFigure& figure, format_context& context) const {
    const auto* const number = std::get_if<double>(&figure.value);
    if (number_format.starts_with("{:?"))
      return format_to(context.out(), "{}", words_for(number != nullptr && *number == 1.0));
    if (number == nullptr) return format_to(context.out(), "{}", std::get<std::string>(figure.value));
    if (std::isnan(*number)) return format_to(context.out(), "not a number");
    if (std::isinf(*number)) return format_to(context.out(), "infinite");
    return vformat_to(context.out(), number_format, make_format_args(*number));
  }
};

namespace proofmass {
namespace {

using Arguments = fmt::dynamic_format_arg_store<fmt::format_context>;

std::string plain(const Finding& finding) {
  std::string text(to_string(finding.code));
  if (!finding.terms.empty()) text += fmt::format(" ({})", join_names(finding.terms));
  for (const Figure& figure : finding.figures) {
    std::visit([&](const auto& value) { text += fmt::format("; {}: {}", figure.name, value); }, figure.value);
  }
  return text;
}

// "14, 15, ..." where there are more lines than a sentence can list, or than the finding does.
std::string listed(const std::vector<std::size_t>& all, const Finding& finding) {
  constexpr std::size_t kMost = 10;
  const std::span<const std::size_t> lines = std::span(all).first(std::min(kMost, all.size()));
  std::string text;
  for (const std::size_t line : lines) text += fmt::format("{}{}", text.empty() ? "" : ", ", line);
  if (lines.size() < all.size()) return text + ", ...";
  for (const Figure& figure : finding.figures) {
    const auto* const count = std::get_if<double>(&figure.value);
    if (figure.name == "count" && count != nullptr && *count > static_cast<double>(lines.size()))
      text += ", ...";
  }
  return text;
}

void add(Arguments& arguments, const std::string& name, std::variant<double, std::string> value) {
  arguments.push_back(fmt::arg(name.c_str(), ShownFigure{std::move(value)}));
}

}  // namespace

std::string filled(std::string_view sentence, const Finding& finding, Phrase phrase) {
  Arguments arguments;
  add(arguments, "terms", join_names(finding.terms));
  add(arguments, "lines", listed(finding.lines, finding));
  const auto words_of = [&](const Figure& figure) {
    const auto* const word = std::get_if<std::string>(&figure.value);
    return word == nullptr || phrase == nullptr ? std::string_view() : phrase(figure.name, *word);
  };
  try {
    for (const Figure& figure : finding.figures) {
      if (words_of(figure).empty()) add(arguments, figure.name, figure.value);
    }
    // These name figures themselves.
    for (const Figure& figure : finding.figures) {
      const std::string_view words = words_of(figure);
      if (!words.empty()) add(arguments, figure.name, fmt::vformat(words, arguments));
    }
    return fmt::vformat(sentence, arguments);
  } catch (const fmt::format_error&) {
    return plain(finding);
  }
}

bool has_figure(const Finding& finding, std::string_view name) noexcept {
  return std::any_of(finding.figures.begin(), finding.figures.end(),
                     [name](const Figure& figure) { return figure.name == name; });
}

}  // namespace proofmass
