// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/plot/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace proofmass {
namespace {

constexpr double kWidth = 720.0, kHeight = 420.0;
constexpr double kLeft = 84.0, kRight = 700.0, kTop = 40.0, kBottom = 364.0;
// Told apart by those who see red and green alike (Wong, Nature Methods 8, 2011).
constexpr std::array<std::string_view, 5> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"};

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else {
      out += c;
    }
  }
  return out;
}

// A stretch of numbers, or of their logarithms, along a stretch of the image.
struct Scale {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double from = 0.0, to = 1.0;
  bool log = false;

  [[nodiscard]] bool shows(double value) const { return std::isfinite(value) && (!log || value > 0.0); }
  [[nodiscard]] double raw(double value) const { return log ? std::log10(value) : value; }
  void include(double value) {
    if (!shows(value)) return;
    low = std::min(low, raw(value));
    high = std::max(high, raw(value));
  }
  void finish() {
    if (!(low <= high)) low = 0.0, high = 1.0;
    if (low == high) low -= 0.5, high += 0.5;
    if (log) low = std::floor(low), high = std::ceil(high);
  }
  [[nodiscard]] double at(double raw_value) const {
    return from + (to - from) * (raw_value - low) / (high - low);
  }
  [[nodiscard]] double place(double value) const { return at(raw(value)); }
};

// Round numbers, 1, 2 or 5 times a power of ten apart; of a logarithm whole powers.
std::vector<double> ticks(const Scale& scale) {
  const double rough = (scale.high - scale.low) / 6.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) {
      step = factor * power;
      break;
    }
  }
  if (scale.log) step = std::max(1.0, std::ceil(step));
  std::vector<double> found;
  const double first = std::ceil(scale.low / step - 1e-9);
  for (double k = first; k * step <= scale.high + 1e-9 * step; k += 1.0) {
    found.push_back(k == 0.0 ? 0.0 : k * step);
  }
  return found;
}

std::string tick_text(const Scale& scale, double tick) {
  return scale.log ? fmt::format("1e{:.0f}", tick) : fmt::format("{:.4g}", tick);
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(text));
}

std::string axes(const Plot& plot, const Scale& x, const Scale& y) {
  std::string out;
  for (const double tick : ticks(y)) {
    out += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#ddd\"/>\n", kLeft, y.at(tick), kRight);
    out += text_at(kLeft - 6.0, y.at(tick) + 4.0, "end", tick_text(y, tick));
  }
  for (const double tick : ticks(x)) {
    out += fmt::format("<path d=\"M{:.1f} {:.1f}v5\" stroke=\"#333\"/>\n", x.at(tick), kBottom);
    out += text_at(x.at(tick), kBottom + 18.0, "middle", tick_text(x, tick));
  }
  out += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}\" fill=\"none\" stroke=\"#333\"/>\n", kLeft,
                     kTop, kBottom, kRight);
  out += text_at(0.5 * (kLeft + kRight), kHeight - 12.0, "middle", plot.x_label);
  out +=
      fmt::format("<text transform=\"translate(18 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                  0.5 * (kTop + kBottom), escaped(plot.y_label));
  return out + text_at(0.5 * (kLeft + kRight), 20.0, "middle", plot.title);
}

std::string drawn(const PlotSeries& series, std::string_view colour, const Scale& x, const Scale& y) {
  std::string path;
  const bool line = series.style == SeriesStyle::line;
  bool pen_down = false;
  for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
    const bool shown = x.shows(series.x[k]) && y.shows(series.y[k]);
    if (shown) {
      path += fmt::format("{}{:.1f} {:.1f}", line && pen_down ? "L" : "M", x.place(series.x[k]),
                          y.place(series.y[k]));
      if (!line) path += "h0";
    }
    pen_down = shown;
  }
  return fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\"/>\n", path,
      colour, line ? 1.5 : 3.5);
}

}  // namespace

std::string render_svg(const Plot& plot) {
  Scale x{.from = kLeft, .to = kRight};
  Scale y{.from = kBottom, .to = kTop, .log = plot.log_y};
  for (const PlotSeries& series : plot.series) {
    for (const double value : series.x) x.include(value);
    for (const double value : series.y) y.include(value);
  }
  x.finish();
  y.finish();
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"#fff\"/>\n",
      kWidth, kHeight);
  out += axes(plot, x, y);
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const std::string_view colour = kColours[k % kColours.size()];
    out += drawn(plot.series[k], colour, x, y);
    const double row = kTop + 16.0 + 16.0 * static_cast<double>(k);
    out += fmt::format("<path d=\"M{:.1f} {:.1f}h20\" stroke=\"{}\" stroke-width=\"3\"/>\n", kRight - 30.0,
                       row - 4.0, colour);
    out += text_at(kRight - 36.0, row, "end", plot.series[k].name);
  }
  return out + "</svg>\n";
}

}  // namespace proofmass
