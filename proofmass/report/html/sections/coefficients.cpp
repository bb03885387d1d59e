// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "proofmass/report/coefficient_text.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/sections.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/text/findings.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

// Zero, the value and its interval on a line of its own. Ki is drawn as it reads: its distance from one.
std::string bar(const Coefficient& c, bool as_deviation) {
  if (!c.ci95) return {};
  const double offset = as_deviation && c.term == Term::Ki ? 1.0 : 0.0;
  const double value = c.value - offset;
  const double from = c.ci95->low - offset;
  const double to = c.ci95->high - offset;
  const double low = std::min(0.0, from);
  const double span = std::max(0.0, to) - low;
  if (!(span > 0.0) || !std::isfinite(span)) return {};
  const auto at = [&](double v) { return 4.0 + 112.0 * (v - low) / span; };
  return fmt::format(
      "<svg class=\"figure bar\" viewBox=\"0 0 120 16\" aria-hidden=\"true\"><path class=\"guide\" "
      "d=\"M{0:.1f} 0V16\"/>"
      "<path class=\"box s0\" d=\"M{1:.1f} 8H{2:.1f}M{1:.1f} 4v8M{2:.1f} 4v8\"/><path class=\"spot s0\" "
      "d=\"M{3:.1f} "
      "8h0\"/></svg>",
      at(0.0), at(from), at(to), at(value));
}

std::string reading(const Coefficient& c, const Unit& output) {
  const std::string what = output.is_acceleration() && c.term == Term::Ki ? "Ki − 1 = " : "";
  return what + in_print(readable_number(c, output)) + " " +
         escaped(typeset_unit(reading_unit(c.term, output)));
}

std::string table(const Text& caption, std::span<const Coefficient> coefficients, const Unit& output,
                  Table::Caption shown = Table::Caption::shown) {
  Table made(caption,
             {{text_of(Label::term), Align::left},
              {text_of(Label::reads), Align::reading},
              {text_of(Label::interval), Align::reading},
              {text_of(Label::bar), Align::left},
              {text_of(Label::value)},
              {text_of(Label::standard_error)},
              {same_text("t")},
              {same_text("p")}},
             shown);
  for (const Coefficient& c : coefficients) {
    if (!c.identified) continue;
    const auto optional = [](const std::optional<double>& value, int digits) {
      return value ? in_print(significant_text(*value, digits)) : std::string("–");
    };
    const std::string p = !c.p ? "–" : *c.p < 1e-4 ? "&lt; 0.0001" : in_print(fmt::format("{:.4f}", *c.p));
    const std::string interval = readable_interval(c, output);
    made.add({escaped(name(c.term)), reading(c, output), interval.empty() ? "–" : in_print(interval),
              bar(c, output.is_acceleration()), in_print(uncertain_text(c.value, c.standard_error)),
              optional(c.standard_error, 3), optional(c.t, 4), p});
  }
  return made.empty() ? std::string() : made.html();
}

std::string refused(std::span<const Coefficient> coefficients) {
  Table made(text_of(Label::not_identified),
             {{text_of(Label::term), Align::left}, {text_of(Label::reason), Align::left}});
  for (const Coefficient& c : coefficients) {
    if (c.identified) continue;
    const Text why =
        c.reason ? Text{reason(*c.reason, Language::en), reason(*c.reason, Language::zh)} : Text();
    made.add({escaped(name(c.term)), both(in_print(why))});
  }
  return made.empty() ? std::string() : made.html();
}

std::optional<Section> coefficients_section(const IdentificationContext& context) {
  const Identification& result = context.run.identification;
  std::string body =
      table(text_of(Label::coefficients), result.coefficients, result.output_unit, Table::Caption::hidden);
  if (!result.output_unit.is_acceleration()) {
    std::vector<Coefficient> referred = referred_to_input(result);
    std::erase_if(referred, [](const Coefficient& c) { return c.term == Term::Ki; });  // 1 by definition
    body += table(text_of(Label::referred), referred, Unit{});
  }
  body += refused(result.coefficients);
  return Section{.id = "coefficients", .title = Label::coefficients, .body = body, .short_ = true};
}

}  // namespace

extern const PageSection coefficients_part;
const PageSection coefficients_part{.place = 20, .make = &coefficients_section};

}  // namespace proofmass::html
