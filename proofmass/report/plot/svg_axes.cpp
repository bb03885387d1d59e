// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "proofmass/report/plot/svg_canvas_internal.hpp"
#include "proofmass/report/text/display_width.hpp"

namespace proofmass {
namespace {

// Where a category or tick is, and what it is called.
struct Tick {
  double place;
  Text text;
};

std::vector<Tick> ticks_of(const ChartAxis& axis, const Scale& scale) {
  std::vector<Tick> found;
  if (!axis.categories.empty()) {
    for (std::size_t k = 0; k < axis.categories.size(); ++k) {
      if (axis.categories[k].en.empty()) continue;  // too many to name
      found.push_back({scale.place(static_cast<double>(k)), axis.categories[k]});
    }
    return found;
  }
  const std::vector<double> values = scale.ticks();
  const std::vector<std::string> texts = tick_texts(scale, values);
  for (std::size_t k = 0; k < values.size(); ++k)
    found.push_back({scale.place(values[k]), same_text(texts[k])});
  return found;
}

// Whether names side by side would run into one another: they then stand in two lines by turns.
bool crowded(const std::vector<Tick>& ticks) {
  for (std::size_t k = 1; k < ticks.size(); ++k) {
    const auto columns = [](const Tick& tick) {
      return static_cast<double>(std::max(display_width(tick.text.en), display_width(tick.text.zh)));
    };
    const double needed = kSvgColumn * (0.5 * (columns(ticks[k - 1]) + columns(ticks[k])) + 0.5);
    if (ticks[k].place - ticks[k - 1].place < needed) return true;
  }
  return false;
}

}  // namespace

void draw_axes(SvgCanvas& canvas, const SvgFrame& frame, const Text& title, const ChartAxis& x_axis,
               const Scale& x, const ChartAxis& y_axis, const Scale& y) {
  using Anchor = SvgCanvas::Anchor;
  std::string grid;
  for (const Tick& tick : ticks_of(y_axis, y)) {
    grid += fmt::format("M{:.1f} {:.1f}H{:.1f}", frame.left, tick.place, frame.right);
    canvas.text(frame.left - 6.0, tick.place + 4.5, tick.text, Anchor::end);
  }
  const std::vector<Tick> along = ticks_of(x_axis, x);
  const bool two_lines = crowded(along);
  for (std::size_t k = 0; k < along.size(); ++k) {
    const Tick& tick = along[k];
    grid += fmt::format("M{:.1f} {:.1f}V{:.1f}", tick.place, frame.top, frame.bottom);
    canvas.text(tick.place, frame.bottom + (two_lines && k % 2 == 1 ? 36.0 : 18.0), tick.text);
  }
  canvas.path(grid, "grid");
  canvas.path(fmt::format("M{:.1f} {:.1f}V{:.1f}H{:.1f}", frame.left, frame.top, frame.bottom, frame.right),
              "axis");
  canvas.text(0.5 * (frame.left + frame.right), frame.bottom + (two_lines ? 57.0 : 43.0), x_axis.label);
  canvas.upright(22.0, 0.5 * (frame.top + frame.bottom), y_axis.label);
  canvas.text(0.5 * kSvgWidth, 21.0, title, Anchor::middle, "title");
}

}  // namespace proofmass
