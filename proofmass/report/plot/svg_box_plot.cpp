// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "proofmass/report/plot/svg_canvas_internal.hpp"

namespace proofmass {

std::string svg_of(const BoxPlot& plot, const SvgUse& use) {
  const SvgFrame frame;
  SvgCanvas canvas(kSvgWidth, kSvgHeight, use);
  Scale y(frame.bottom, frame.top, plot.y.log);
  Scale x(frame.left, frame.right);
  x.include(-0.5);
  x.include(static_cast<double>(plot.boxes.size()) - 0.5);
  ChartAxis names;
  for (const Box& box : plot.boxes) {
    names.categories.push_back(box.name);
    for (const double v : {box.low, box.high}) y.include(v);
    for (const double v : box.beyond) y.include(v);
  }
  x.finish(0.0);
  y.finish();
  draw_axes(canvas, frame, plot.title, names, x, plot.y, y);
  for (std::size_t k = 0; k < plot.boxes.size(); ++k) {
    const Box& box = plot.boxes[k];
    constexpr double kHalf = 18.0, kCap = 9.0;
    const double at = x.place(static_cast<double>(k));
    const auto h = [&](double value) { return y.place(value); };
    canvas.path(fmt::format("M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}Z", at - kHalf, h(box.lower), at + kHalf,
                            h(box.upper), at - kHalf),
                "band f0");
    canvas.path(fmt::format("M{0:.1f} {1:.1f}H{2:.1f}V{3:.1f}H{0:.1f}ZM{0:.1f} {4:.1f}H{2:.1f}", at - kHalf,
                            h(box.lower), at + kHalf, h(box.upper), h(box.median)),
                "box s0");
    canvas.path(fmt::format("M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {2:.1f}h{5:.1f}M{0:.1f} "
                            "{4:.1f}V{6:.1f}M{3:.1f} {6:.1f}h{5:.1f}",
                            at, h(box.upper), h(box.high), at - kCap, h(box.lower), 2.0 * kCap, h(box.low)),
                "box s0");
    for (const double v : box.beyond) canvas.path(fmt::format("M{:.1f} {:.1f}h0", at, h(v)), "spot s1");
  }
  return canvas.finish();
}

}  // namespace proofmass
