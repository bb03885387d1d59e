// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "proofmass/report/plot/svg_canvas_internal.hpp"
#include "proofmass/report/text/display_width.hpp"

namespace proofmass {
namespace {

// Data are drawn on a grid of half units: finer than the eye sees, and one point for all that fall on one
// place.
constexpr double kGrid = 2.0;
using Place = std::pair<long, long>;

std::string_view class_of(Mark mark) {
  constexpr std::array<std::string_view, 6> kClasses{"line", "dashes", "points", "squares", "steps", "band"};
  return kClasses.at(static_cast<std::size_t>(mark));
}

// Few points are drawn larger: they are looked at one by one.
std::string stroke_of(const Series& s) {
  const bool few = s.x.size() <= kFewPoints && (s.mark == Mark::points || s.mark == Mark::squares);
  return fmt::format("{}{} s{}", class_of(s.mark), few ? " few" : "", s.colour);
}

constexpr double kLegendSample = 22.0, kLegendGap = 14.0;  // of a legend
constexpr double kLegendTop = 43.0, kLegendLine = 20.0, kLegendEdge = 6.0;

double legend_width(const Series& s) {
  const auto columns = static_cast<double>(std::max(display_width(s.name.en), display_width(s.name.zh)));
  return s.name.en.empty() ? 0.0 : kLegendSample + 4.0 + kSvgColumn * columns + kLegendGap;
}

double legend_start(const Chart& chart) {
  double width = 0.0;
  for (const Series& s : chart.series) width += legend_width(s);
  return std::clamp(kSvgWidth - width, kLegendEdge, SvgFrame().left);
}

// Where the entry of a series begins, and in which line of the legend.
struct LegendPlace {
  double at = 0.0;
  std::size_t line = 0;
};

// Of each series, above the data; the legend begins further left where it is long, and goes on in further
// lines.
std::vector<LegendPlace> legend_places(const Chart& chart) {
  const double start = legend_start(chart);
  std::vector<LegendPlace> places;
  LegendPlace next{.at = start};
  for (const Series& s : chart.series) {
    const double width = legend_width(s);
    if (next.at + width > kSvgWidth && next.at > start) next = {.at = start, .line = next.line + 1};
    places.push_back(next);
    next.at += width;
  }
  return places;
}

// Lower where the legend has more lines than one.
SvgFrame frame_of(const std::vector<LegendPlace>& legend) {
  SvgFrame frame;
  if (!legend.empty()) frame.top += kLegendLine * static_cast<double>(legend.back().line);
  return frame;
}

class ChartDrawing {
 public:
  ChartDrawing(const Chart& chart, const SvgUse& use)
      : chart_(chart),
        legend_(legend_places(chart)),
        frame_(frame_of(legend_)),
        canvas_(kSvgWidth, kSvgHeight, use),
        x_(frame_.left, frame_.right, chart.x.log),
        y_(frame_.bottom, frame_.top, chart.y.log) {
    fit_scales();
  }

  std::string draw() {
    draw_axes(canvas_, frame_, chart_.title, chart_.x, x_, chart_.y, y_);
    draw_guides();
    canvas_.raw("<g transform=\"scale(.5)\">");
    for (const Series& series : chart_.series) draw_series(series);
    canvas_.raw("</g>");
    draw_legend();
    return canvas_.finish();
  }

 private:
  void fit_scales() {
    for (const Series& s : chart_.series) {
      for (const double v : s.x) x_.include(v);
      for (std::size_t k = 0; k < s.y.size(); ++k) {
        const double reach = k < s.whisker.size() && std::isfinite(s.whisker[k]) ? s.whisker[k] : 0.0;
        y_.include(s.y[k] - reach);
        y_.include(s.y[k] + reach);
      }
      for (const double v : s.high) y_.include(v);
      if (s.mark == Mark::steps) y_.include(0.0);
    }
    for (const Guide& guide : chart_.guides) (guide.vertical ? x_ : y_).include(guide.at);
    if (!chart_.x.categories.empty()) {
      x_.include(-0.5);
      x_.include(static_cast<double>(chart_.x.categories.size()) - 0.5);
    }
    x_.finish();
    y_.finish();
  }

  [[nodiscard]] bool shows(double x, double y) const { return x_.shows(x) && y_.shows(y); }
  [[nodiscard]] Place place(double x, double y) const {
    return {std::lround(kGrid * x_.place(x)), std::lround(kGrid * y_.place(y))};
  }

  [[nodiscard]] std::string dots(const Series& s) const {
    std::vector<Place> places;
    for (std::size_t k = 0; k < std::min(s.x.size(), s.y.size()); ++k)
      if (shows(s.x[k], s.y[k])) places.push_back(place(s.x[k], s.y[k]));
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::string path;
    Place last{0, 0};
    for (const Place& p : places) {
      const long down = p.second - last.second;
      path += fmt::format("m{}{}{}h0", p.first - last.first, down < 0 ? "" : " ", down);
      last = p;
    }
    return path;
  }

  // Of many points that fall into one column of the image the first, the last and both ends.
  [[nodiscard]] std::string curve(const std::vector<double>& xs, const std::vector<double>& ys) const {
    std::string path;
    bool pen_down = false;
    std::size_t k = 0;
    const std::size_t n = std::min(xs.size(), ys.size());
    while (k < n) {
      if (!shows(xs[k], ys[k])) {
        pen_down = false;
        ++k;
        continue;
      }
      std::vector<Place> column;
      const long at = place(xs[k], ys[k]).first;
      while (k < n && shows(xs[k], ys[k]) && place(xs[k], ys[k]).first == at)
        column.push_back(place(xs[k], ys[k])), ++k;
      const auto [least, most] = std::minmax_element(column.begin(), column.end());
      std::vector<Place> kept{column.front()};
      if (column.size() > 1) {
        kept.insert(kept.end(), least < most ? std::initializer_list<Place>{*least, *most, column.back()}
                                             : std::initializer_list<Place>{*most, *least, column.back()});
      }
      kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
      for (const Place& p : kept) {
        path += fmt::format("{}{} {}", std::exchange(pen_down, true) ? "L" : "M", p.first, p.second);
      }
    }
    return path;
  }

  [[nodiscard]] std::string staircase(const Series& s) const {
    std::string path;
    for (std::size_t k = 0; k < s.y.size() && k + 1 < s.x.size(); ++k) {
      const Place from = place(s.x[k], s.y[k]);
      if (k == 0) path = fmt::format("M{} {}", from.first, std::lround(kGrid * y_.place(0.0)));
      path += fmt::format("V{}H{}", from.second, place(s.x[k + 1], s.y[k]).first);
    }
    return path.empty() ? path : path + fmt::format("V{}", std::lround(kGrid * y_.place(0.0)));
  }

  [[nodiscard]] std::string area(const Series& s) const {
    std::string path;
    const std::size_t n = std::min({s.x.size(), s.y.size(), s.high.size()});
    for (std::size_t k = 0; k < 2 * n; ++k) {
      const std::size_t at = k < n ? k : 2 * n - 1 - k;
      const Place p = place(s.x[at], k < n ? s.y[at] : s.high[at]);
      path += fmt::format("{}{} {}", k == 0 ? "M" : "L", p.first, p.second);
    }
    return path.empty() ? path : path + "Z";
  }

  [[nodiscard]] std::string whiskers(const Series& s) const {
    std::string path;
    for (std::size_t k = 0; k < std::min(s.y.size(), s.whisker.size()); ++k) {
      if (!shows(s.x[k], s.y[k]) || !(s.whisker[k] > 0.0) || !y_.shows(s.y[k] - s.whisker[k])) continue;
      const Place low = place(s.x[k], s.y[k] - s.whisker[k]);
      const Place high = place(s.x[k], s.y[k] + s.whisker[k]);
      path += fmt::format("M{0} {1}h12m-6 0V{2}m-6 0h12", low.first - 6, low.second, high.second);
    }
    return path;
  }

  void draw_series(const Series& s) {
    const std::string stroke = stroke_of(s);
    canvas_.path(whiskers(s), fmt::format("whisker s{}", s.colour));
    switch (s.mark) {
      case Mark::points:
      case Mark::squares:
        return canvas_.path(dots(s), stroke);
      case Mark::line:
      case Mark::dashes:
        return canvas_.path(curve(s.x, s.y), stroke);
      case Mark::steps:
        return canvas_.path(staircase(s), stroke);
      case Mark::band:
        return canvas_.path(area(s), fmt::format("band f{}", s.colour));
    }
  }

  void draw_guides() {
    for (const Guide& guide : chart_.guides) {
      if (guide.vertical) {
        const double at = x_.place(guide.at);
        canvas_.path(fmt::format("M{:.1f} {:.1f}V{:.1f}", at, frame_.top, frame_.bottom), "guide");
        const bool right = at > 0.5 * (frame_.left + frame_.right);
        canvas_.text(at + (right ? -4.0 : 4.0), frame_.top + 12.0, guide.label,
                     right ? SvgCanvas::Anchor::end : SvgCanvas::Anchor::start);
      } else {
        const double at = y_.place(guide.at);
        canvas_.path(fmt::format("M{:.1f} {:.1f}H{:.1f}", frame_.left, at, frame_.right), "guide");
        canvas_.text(frame_.right - 4.0, at - 4.0, guide.label, SvgCanvas::Anchor::end);
      }
    }
  }

  void draw_legend() {
    for (std::size_t k = 0; k < chart_.series.size(); ++k) {
      const Series& s = chart_.series[k];
      const double y = kLegendTop + kLegendLine * static_cast<double>(legend_[k].line);
      if (!s.name.en.empty()) draw_entry(s, legend_[k].at, y);
    }
  }

  void draw_entry(const Series& s, double at, double y) {
    const std::string stroke = stroke_of(s);
    const bool dot = s.mark == Mark::points || s.mark == Mark::squares;
    canvas_.raw("<g transform=\"scale(.5)\">");
    if (s.mark == Mark::band) {
      canvas_.path(fmt::format("M{:.0f} {:.0f}h{:.0f}v20h-{:.0f}Z", kGrid * at, kGrid * (y - 9.0),
                               kGrid * kLegendSample, kGrid * kLegendSample),
                   fmt::format("band f{}", s.colour));
    } else {
      canvas_.path(fmt::format("M{:.0f} {:.0f}h{:.0f}", kGrid * (dot ? at + 0.5 * kLegendSample : at),
                               kGrid * (y - 5.0), dot ? 0.0 : kGrid * kLegendSample),
                   stroke);
    }
    canvas_.raw("</g>");
    canvas_.text(at + kLegendSample + 4.0, y, s.name, SvgCanvas::Anchor::start);
  }

  const Chart& chart_;
  std::vector<LegendPlace> legend_;
  SvgFrame frame_;
  SvgCanvas canvas_;
  Scale x_, y_;
};

}  // namespace

std::string svg_of(const Chart& chart, const SvgUse& use) { return ChartDrawing(chart, use).draw(); }

}  // namespace proofmass
