// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace proofmass {

enum class SeriesStyle { line, points };

struct PlotSeries {
  std::string name;
  std::vector<double> x, y;  // of the same length
  SeriesStyle style = SeriesStyle::line;
};

struct Plot {
  std::string title, x_label, y_label;
  bool log_y = false;  // values that are not positive are then left out
  std::vector<PlotSeries> series;
};

// The plot as an SVG image that stands alone, 720 by 420: axes with round ticks, a legend, and values that
// are not finite left out.
[[nodiscard]] std::string render_svg(const Plot& plot);

}  // namespace proofmass
