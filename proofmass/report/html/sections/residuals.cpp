// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"
#include "proofmass/report/html/sections/sections.hpp"
#include "proofmass/report/text/display_width.hpp"

namespace proofmass::html {
namespace {

// What residuals are drawn against.
struct Along {
  std::string id;
  Text what;
  std::string unit;  // empty: none
  std::vector<double> values;
  std::vector<Text> categories{};
};

std::vector<double> magnitudes(const Dataset& record) {
  std::vector<double> values;
  for (std::size_t row = 0; row < record.rows(); ++row) values.push_back(magnitude(record.at(row)));
  return values;
}

Along along_order(const RecordFigures& figures) {
  Along made{.id = "order", .what = text_of(Label::order), .unit = {}, .values = {}};
  for (const std::size_t number : figures.numbers) made.values.push_back(static_cast<double>(number + 1));
  return made;
}

std::string shortened(const std::string& label) {
  constexpr std::size_t kMost = 24;
  if (display_width(label) <= kMost) return label;
  std::string text;
  for (std::string_view rest = label; !rest.empty() && display_width(text) + 2 < kMost;) {
    const std::string_view next = first_character(rest).bytes;
    text += next;
    rest.remove_prefix(next.size());
  }
  return text + "…";
}

// As many labels as fit below the axis: each, or each second, and so on.
Along along_mounts(const Dataset& record) {
  constexpr std::size_t kMostColumns = 50;
  Along made{
      .id = "mount", .what = text_of(Label::mount), .unit = {}, .values = std::vector<double>(record.rows())};
  const auto mounts = rows_by_mount(record.mount);
  std::size_t widest = 1;
  for (std::size_t k = 0; k < mounts.size(); ++k) {
    for (const std::size_t row : mounts[k]) made.values[row] = static_cast<double>(k);
    widest = std::max(widest, display_width(record.mount[mounts[k].front()]) + 1);
  }
  const std::size_t room = std::max<std::size_t>(1, kMostColumns / widest);
  const std::size_t step = (mounts.size() + room - 1) / room;
  for (std::size_t k = 0; k < mounts.size(); ++k)
    made.categories.push_back(k % step == 0 ? same_text(shortened(record.mount[mounts[k].front()])) : Text());
  return made;
}

std::vector<Along> all_along(const RecordFigures& figures) {
  const Dataset& record = figures.record;
  constexpr std::array<std::string_view, 3> kIds{"ai", "ao", "ap"};
  std::vector<Along> all;
  for (const Axis axis : record.axes()) {
    all.push_back({.id = std::string(kIds.at(static_cast<std::size_t>(axis))),
                   .what = same_text(std::string(axis_name(axis))),
                   .unit = "g",
                   .values = record.along(axis)});
  }
  all.push_back({.id = "magnitude", .what = same_text("|A|"), .unit = "g", .values = magnitudes(record)});
  all.push_back(along_order(figures));
  if (!record.time.empty()) {
    all.push_back(
        {.id = "time", .what = text_of(Label::time), .unit = record.time_unit.symbol, .values = record.time});
  }
  if (!record.temperature.empty()) {
    all.push_back({.id = "temperature",
                   .what = text_of(Label::temperature),
                   .unit = record.temperature_unit.symbol == "degC" ? "°C" : record.temperature_unit.symbol,
                   .values = record.temperature});
  }
  if (!record.mount.empty()) all.push_back(along_mounts(record));
  return all;
}

Text axis_label(const Along& along) {
  if (along.unit.empty()) return along.what;
  return {along.what.en + ", " + along.unit, along.what.zh + "，" + along.unit};
}

std::optional<Section> residuals_section(const IdentificationContext& context) {
  if (context.record == nullptr) return std::nullopt;
  const RecordFigures& record = *context.record;
  const ShownUnit unit = residual_unit(context);
  const std::vector<double> residuals = scaled(record.rows.residuals, unit.factor);
  std::string figures;
  for (const Along& along : all_along(record)) {
    const Text title = text_of(Label::residuals_against, "what", along.what);
    const Chart chart{.id = "residuals-" + along.id,
                      .title = title,
                      .x = {.label = axis_label(along), .categories = along.categories},
                      .y = {.label = text_of(Label::residual, {{"unit", unit.symbol}})},
                      .series = series_by_part(record, along.values, residuals),
                      .guides = {{.at = 0.0}}};
    figures += figure(chart, context.interactive, findings_of(context.run.identification.findings, chart.id));
  }
  return Section{.id = "residuals",
                 .title = Label::residuals,
                 .body = thinning_note(record) + element("div", figures, "class=\"figures\"")};
}

}  // namespace

extern const PageSection residuals_part;
const PageSection residuals_part{.place = 50, .make = &residuals_section};

}  // namespace proofmass::html
