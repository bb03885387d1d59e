// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "proofmass/report/plot/svg_canvas_internal.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass {
namespace {

constexpr double kCentreX = 320.0, kCentreY = 220.0,
                 kReach = 140.0;  // of the largest coordinate, in the image

// Seen from a corner above, without perspective: as far along one axis as along another.
struct View {
  double largest;
  [[nodiscard]] std::pair<double, double> place(double x, double y, double z) const {
    constexpr double kCosine = 0.8660254, kSine = 0.5;  // of 30 degrees
    const double scale = kReach / largest;
    return {kCentreX + scale * kCosine * (y - x), kCentreY + scale * (kSine * (x + y) - z)};
  }
};

void draw_axis(SvgCanvas& canvas, const View& view, const std::array<double, 3>& along, const Text& label) {
  constexpr double kBeyond = 1.12, kLabel = 1.27;
  const double far = view.largest * kBeyond;
  const auto from = view.place(-far * along[0], -far * along[1], -far * along[2]);
  const auto to = view.place(far * along[0], far * along[1], far * along[2]);
  canvas.path(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", from.first, from.second, to.first, to.second),
              "axis");
  const double out = view.largest * kLabel;
  const auto at = view.place(out * along[0], out * along[1], out * along[2]);
  canvas.text(at.first, at.second + 4.0, label);
  const auto mark = view.place(view.largest * along[0], view.largest * along[1], view.largest * along[2]);
  canvas.text(mark.first + 8.0, mark.second - 6.0, typeset(fmt::format("{:.3g}", view.largest)),
              SvgCanvas::Anchor::start, "small");
}

}  // namespace

std::string svg_of(const SpacePlot& plot, const SvgUse& use) {
  SvgCanvas canvas(kSvgWidth, kSvgHeight, use);
  View view{.largest = 0.0};
  for (const auto* column : {&plot.x, &plot.y, &plot.z}) {
    for (const double v : *column)
      view.largest = std::max(view.largest, std::isfinite(v) ? std::abs(v) : 0.0);
  }
  // A point that is far out along several axes at once must not reach the title.
  constexpr double kRoom = 165.0;  // above and below the centre
  for (std::size_t k = 0; k < plot.x.size(); ++k) {
    const double height = std::abs(0.5 * (plot.x[k] + plot.y[k]) - plot.z[k]);
    if (std::isfinite(height)) view.largest = std::max(view.largest, height * kReach / kRoom);
  }
  if (view.largest == 0.0) view.largest = 1.0;
  canvas.text(0.5 * kSvgWidth, 21.0, plot.title, SvgCanvas::Anchor::middle, "title");
  for (std::size_t axis = 0; axis < plot.axes.size(); ++axis) {
    std::array<double, 3> along{};
    along.at(axis) = 1.0;
    draw_axis(canvas, view, along, plot.axes[axis]);
  }
  std::vector<std::pair<long, long>> places;
  for (std::size_t k = 0; k < plot.x.size(); ++k) {
    const auto at = view.place(plot.x[k], plot.y[k], plot.z[k]);
    places.emplace_back(std::lround(2.0 * at.first), std::lround(2.0 * at.second));
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::string path;
  for (const auto& [x, y] : places) path += fmt::format("M{} {}h0", x, y);
  canvas.raw("<g transform=\"scale(.5)\">");
  canvas.path(path, "points s0");
  canvas.raw("</g>");
  return canvas.finish();
}

}  // namespace proofmass
