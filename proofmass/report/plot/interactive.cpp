// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/plot/interactive.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "proofmass/report/base64.hpp"

namespace proofmass {
namespace {

using Json = nlohmann::ordered_json;

template <typename Bits>
std::string packed(const std::vector<double>& values, Bits (*bits_of)(double)) {
  std::string bytes;
  bytes.reserve(sizeof(Bits) * values.size());
  for (const double value : values) {
    const Bits bits = bits_of(value);
    for (unsigned shift = 0; shift < 8 * sizeof(Bits); shift += 8)
      bytes += static_cast<char>((bits >> shift) & 0xFFU);
  }
  return base64(bytes);
}

// Whether single precision tells the values apart as well as a screen does: not those of a clock, or beyond
// its range.
bool suit_floats(const std::vector<double>& values) {
  constexpr double kLeastSpan = 1e-3;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const double largest = std::max(std::abs(low), std::abs(high));
  return low > high ||
         (largest < std::numeric_limits<float>::max() && (high == low || high - low > kLeastSpan * largest) &&
          high - low > std::numeric_limits<float>::min());
}

// "f" or "d", for single or double precision, and the values.
std::string as_text(const std::vector<double>& values) {
  const bool single = suit_floats(values);
  std::string text(1, single ? 'f' : 'd');
  text += single ? packed<std::uint32_t>(
                       values, [](double v) { return std::bit_cast<std::uint32_t>(static_cast<float>(v)); })
                 : packed<std::uint64_t>(values, [](double v) { return std::bit_cast<std::uint64_t>(v); });
  return text;
}

Json words(const Text& text) { return Json::array({text.en, text.zh}); }

Json axis_of(const ChartAxis& axis) {
  Json made{{"label", words(axis.label)}};
  if (axis.log) made["log"] = true;
  for (const Text& category : axis.categories) made["categories"].push_back(words(category));
  return made;
}

std::string_view name_of(Mark mark) {
  constexpr std::array<std::string_view, 6> kNames{"line", "dashes", "points", "squares", "steps", "band"};
  return kNames.at(static_cast<std::size_t>(mark));
}

}  // namespace

std::size_t InteractiveFigures::column(const std::vector<double>& values) {
  const auto [place, is_new] = numbers_.try_emplace(as_text(values), columns_.size());
  if (is_new) columns_.push_back(place->first);
  return place->second;
}

void InteractiveFigures::add(const Drawing& figure) {
  Json made;
  if (const auto* chart = std::get_if<Chart>(&figure)) {
    made = {{"id", chart->id},
            {"title", words(chart->title)},
            {"x", axis_of(chart->x)},
            {"y", axis_of(chart->y)}};
    for (const Series& s : chart->series) {
      Json one{{"name", words(s.name)}, {"mark", name_of(s.mark)}, {"colour", s.colour}};
      if (s.x.size() <= kFewPoints) one["few"] = true;
      one["x"] = column(s.x);
      one["y"] = column(s.y);
      if (!s.high.empty()) one["high"] = column(s.high);
      if (!s.whisker.empty()) one["whisker"] = column(s.whisker);
      made["series"].push_back(std::move(one));
    }
    for (const Guide& guide : chart->guides) {
      made["guides"].push_back(
          {{"at", guide.at}, {"vertical", guide.vertical}, {"label", words(guide.label)}});
    }
  } else if (const auto* space = std::get_if<SpacePlot>(&figure)) {
    made = {{"id", space->id}, {"title", words(space->title)}};
    for (const Text& axis : space->axes) made["axes"].push_back(words(axis));
    made["space"] = {column(space->x), column(space->y), column(space->z)};
  } else {
    return;
  }
  figures_.push_back(made.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string InteractiveFigures::json() const {
  std::string text = "{\"columns\":[";
  for (std::size_t k = 0; k < columns_.size(); ++k) text += (k == 0 ? "\"" : ",\"") + columns_[k] + "\"";
  text += "],\"figures\":[";
  for (std::size_t k = 0; k < figures_.size(); ++k) text += (k == 0 ? "" : ",") + figures_[k];
  text += "]}";
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace proofmass
