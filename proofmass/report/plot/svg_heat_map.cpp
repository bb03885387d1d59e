// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "proofmass/report/plot/svg_canvas_internal.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass {
namespace {

struct Colour {
  double r, g, b;
};

// Blue for minus one, white for zero, orange for one (ends of Wong's palette): told apart without red and
// green.
std::string fill_of(double value) {
  constexpr Colour kMinus{0, 114, 178}, kPlus{213, 94, 0};
  constexpr double kWhite = 255.0;
  const Colour end = value < 0.0 ? kMinus : kPlus;
  const double part = std::min(std::abs(value), 1.0);
  const auto mixed = [part](double to) { return std::lround(kWhite + part * (to - kWhite)); };
  return fmt::format("#{:02x}{:02x}{:02x}", mixed(end.r), mixed(end.g), mixed(end.b));
}

}  // namespace

// Squares with the value in each where there is room; a sign tells plus from minus without colour.
std::string svg_of(const HeatMap& map, const SvgUse& use) {
  constexpr double kLeft = 52.0, kTop = 76.0, kSide = 560.0;
  const std::size_t n = map.labels.size();
  const double side = std::min(kSide / static_cast<double>(std::max<std::size_t>(n, 1)), 46.0);
  SvgCanvas canvas(kSvgWidth, kTop + side * static_cast<double>(n) + 12.0, use);
  canvas.text(0.5 * kSvgWidth, 21.0, map.title, SvgCanvas::Anchor::middle, "title");
  for (std::size_t a = 0; a < n; ++a) {
    const double from = side * static_cast<double>(a);
    canvas.text(kLeft - 6.0, kTop + from + 0.5 * side + 4.5, map.labels[a], SvgCanvas::Anchor::end);
    canvas.upright(kLeft + from + 0.5 * side + 4.5, kTop - 24.0, same_text(map.labels[a]));
    for (std::size_t b = 0; b < n; ++b) {
      const double value = map.values[a * n + b];
      const double x = kLeft + side * static_cast<double>(b);
      canvas.raw(fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}v{:.1f}h-{:.1f}Z\" fill=\"{}\"/>", x,
                             kTop + from, side - 1, side - 1, side - 1, fill_of(value)));
      const std::string number = std::abs(value) < 0.005 ? "0" : typeset(fmt::format("{:.2f}", value));
      canvas.text(x + 0.5 * side, kTop + from + 0.5 * side + 4.0, a == b ? "1" : number,
                  SvgCanvas::Anchor::middle, std::abs(value) > 0.7 ? "cell strong" : "cell");
    }
  }
  return canvas.finish();
}

}  // namespace proofmass
