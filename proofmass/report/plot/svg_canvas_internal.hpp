// SPDX-License-Identifier: Apache-2.0
// The strokes and letters that every image is made of.
#pragma once

#include <string>
#include <string_view>

#include "proofmass/report/plot/scale.hpp"
#include "proofmass/report/plot/svg.hpp"
#include "proofmass/report/xml_text.hpp"

namespace proofmass {

class SvgCanvas {
 public:
  SvgCanvas(double width, double height, const SvgUse& use);

  enum class Anchor { start, middle, end };
  // Of CSS class `style`, besides that of the language where the languages differ.
  void text(double x, double y, const Text& text, Anchor anchor = Anchor::middle,
            std::string_view style = "");
  void text(double x, double y, std::string_view text, Anchor anchor = Anchor::middle,
            std::string_view style = "");
  // Read from below to above.
  void upright(double x, double y, const Text& text);
  void path(std::string_view data, std::string_view style);
  void raw(std::string_view svg) { body_ += svg; }
  [[nodiscard]] std::string finish() const;

 private:
  void element(std::string_view attributes, const Text& text, std::string_view style);
  double width_, height_;
  SvgUse use_;
  std::string body_;
};

[[nodiscard]] std::string svg_of(const Chart& chart, const SvgUse& use);
[[nodiscard]] std::string svg_of(const HeatMap& map, const SvgUse& use);
[[nodiscard]] std::string svg_of(const BoxPlot& plot, const SvgUse& use);
[[nodiscard]] std::string svg_of(const SpacePlot& plot, const SvgUse& use);

// The frame of a chart: where its data are, in units of the image.
struct SvgFrame {
  double left = 102.0, right = 618.0, top = 56.0, bottom = 338.0;
};
inline constexpr double kSvgWidth = 640.0, kSvgHeight = 400.0;
// The room that a column of text takes at the size of narrow screens and paper.
inline constexpr double kSvgColumn = 9.8;
// Grid, ticks, labels and title.
void draw_axes(SvgCanvas& canvas, const SvgFrame& frame, const Text& title, const ChartAxis& x_axis,
               const Scale& x, const ChartAxis& y_axis, const Scale& y);

}  // namespace proofmass
