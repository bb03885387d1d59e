// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/sentence.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace proofmass {
namespace {

// A figure ready to be shown.
struct ShownFigure {
  std::variant<double, std::string> value;
  Language language;
};

constexpr Words kNotANumber{"not a number", "非数"};
constexpr Words kInfinite{"infinite", "无穷大"};

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
    if (std::isnan(*number))
      return format_to(context.out(), "{}", proofmass::kNotANumber.in(figure.language));
    if (std::isinf(*number)) return format_to(context.out(), "{}", proofmass::kInfinite.in(figure.language));
    return vformat_to(context.out(), number_format, make_format_args(*number));
  }
};

namespace proofmass {
namespace {

using Arguments = fmt::dynamic_format_arg_store<fmt::format_context>;

// "; limit: 10".
std::string figures_text(std::span<const Figure> figures) {
  std::string text;
  for (const Figure& figure : figures) {
    std::visit([&](const auto& value) { text += fmt::format("; {}: {}", figure.name, value); }, figure.value);
  }
  return text;
}

std::string plain(const Finding& finding) {
  std::string text(to_string(finding.code));
  if (!finding.terms.empty()) text += fmt::format(" ({})", join_names(finding.terms));
  return text + figures_text(finding.figures);
}

constexpr Words kComma{", ", "、"};
constexpr Words kAndMore{", ...", "……"};

// "14, 15, ..." where there are more lines than a sentence can list, or than the finding does.
std::string listed(const std::vector<std::size_t>& all, const Finding& finding, Language language) {
  constexpr std::size_t kMost = 10;
  const std::span<const std::size_t> lines = std::span(all).first(std::min(kMost, all.size()));
  std::string text;
  for (const std::size_t line : lines)
    text += fmt::format("{}{}", text.empty() ? "" : kComma.in(language), line);
  const std::string more(kAndMore.in(language));
  if (lines.size() < all.size()) return text + more;
  for (const Figure& figure : finding.figures) {
    const auto* const count = std::get_if<double>(&figure.value);
    if (figure.name == "count" && count != nullptr && *count > static_cast<double>(lines.size()))
      text += more;
  }
  return text;
}

// The words of figures that are not finite are those of result files.
std::variant<double, std::string> read_back(const std::variant<double, std::string>& value) {
  const auto* const word = std::get_if<std::string>(&value);
  if (word != nullptr && *word == kInfinite.en) return std::numeric_limits<double>::infinity();
  if (word != nullptr && *word == kNotANumber.en) return std::numeric_limits<double>::quiet_NaN();
  return value;
}

// Figures that are lists of names or numbers, written with commas in between.
constexpr std::array<std::string_view, 4> kListFigures{"axes", "columns", "inflated", "sizes"};

std::variant<double, std::string> shown_value(const std::string& name,
                                              const std::variant<double, std::string>& value,
                                              Language language) {
  const auto* const words = std::get_if<std::string>(&value);
  if (words == nullptr || std::find(kListFigures.begin(), kListFigures.end(), name) == kListFigures.end())
    return read_back(value);
  std::string list = *words;
  const std::string_view comma = kComma.in(language);
  for (std::size_t at = list.find(kComma.en); at != std::string::npos;
       at = list.find(kComma.en, at + comma.size())) {
    list.replace(at, kComma.en.size(), comma);
  }
  return list;
}

void add(Arguments& arguments, const std::string& name, const std::variant<double, std::string>& value,
         Language language) {
  arguments.push_back(fmt::arg(name.c_str(), ShownFigure{shown_value(name, value, language), language}));
}

std::optional<std::string> fill(std::string_view sentence, std::span<const Figure> figures,
                                Arguments& arguments, Phrase phrase, Language language) {
  const auto words_of = [&](const Figure& figure) {
    const auto* const word = std::get_if<std::string>(&figure.value);
    return word == nullptr || phrase == nullptr ? std::string_view() : phrase(figure.name, *word);
  };
  try {
    for (const Figure& figure : figures) {
      if (words_of(figure).empty()) add(arguments, figure.name, figure.value, language);
    }
    // These name figures themselves.
    for (const Figure& figure : figures) {
      const std::string_view words = words_of(figure);
      if (!words.empty()) add(arguments, figure.name, fmt::vformat(words, arguments), language);
    }
    return fmt::vformat(sentence, arguments);
  } catch (const fmt::format_error&) {
    return std::nullopt;
  }
}

}  // namespace

std::string filled(std::string_view sentence, const Finding& finding, Phrase phrase, Language language) {
  Arguments arguments;
  add(arguments, "terms", listed_names(finding.terms, language), language);
  add(arguments, "lines", listed(finding.lines, finding, language), language);
  return fill(sentence, finding.figures, arguments, phrase, language).value_or(plain(finding));
}

std::optional<std::string> filled(std::string_view sentence, std::span<const Figure> figures, Phrase phrase,
                                  Language language) {
  Arguments arguments;
  return fill(sentence, figures, arguments, phrase, language);
}

std::string plain_text(std::string_view code, std::span<const Figure> figures) {
  return std::string(code) + figures_text(figures);
}

std::string listed_names(const TermList& terms, Language language) {
  std::string text;
  for (const Term term : terms) text.append(text.empty() ? "" : kComma.in(language)).append(name(term));
  return text;
}

bool has_figure(const Finding& finding, std::string_view name) noexcept {
  return std::any_of(finding.figures.begin(), finding.figures.end(),
                     [name](const Figure& figure) { return figure.name == name; });
}

}  // namespace proofmass
