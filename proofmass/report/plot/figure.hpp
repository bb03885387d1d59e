// SPDX-License-Identifier: Apache-2.0
// Figures as data; drawn as SVG by svg.hpp, and handed to a plotting library by interactive.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "proofmass/report/text/language.hpp"

namespace proofmass {

enum class Mark : std::uint8_t {
  line,
  dashes,
  points,   // round
  squares,  // told from round ones without colour
  steps,    // y[k] between x[k] and x[k + 1]; x has one value more
  band,     // between y and high
};

struct Series {
  Text name;  // in the legend; empty: none there
  std::vector<double> x, y;
  Mark mark = Mark::line;
  std::size_t colour = 0;         // of the palette
  std::vector<double> high{};     // of a band
  std::vector<double> whisker{};  // half the length of a bar of uncertainty at each point
  std::string key{};              // its name in files of data; empty: the English one
};

// A series of no more points than these is drawn with larger ones.
inline constexpr std::size_t kFewPoints = 60;

struct ChartAxis {
  Text label;
  bool log = false;                // values that are not positive are then left out
  std::vector<Text> categories{};  // at 0, 1, ...; empty: numbers
};

// A line across a chart, with a label.
struct Guide {
  double at = 0.0;
  bool vertical = false;
  Text label{};
};

// Series over two axes. Values that are not finite are left out.
struct Chart {
  std::string id;  // unique in a document: lower-case letters, digits and hyphens
  Text title;
  ChartAxis x, y;
  std::vector<Series> series;
  std::vector<Guide> guides{};
};

// A matrix with values from -1 to 1, drawn as squares.
struct HeatMap {
  std::string id;
  Text title;
  std::vector<std::string> labels;  // of rows and columns
  std::vector<double> values;       // row-major
};

// Quartiles, the ends within 1.5 times their distance, and what lies beyond (Tukey 1977).
struct Box {
  Text name;
  double low = 0.0, lower = 0.0, median = 0.0, upper = 0.0, high = 0.0;
  std::vector<double> beyond{};
};
struct BoxPlot {
  std::string id;
  Text title;
  ChartAxis y;
  std::vector<Box> boxes;
};

// Points in space, seen from a corner.
struct SpacePlot {
  std::string id;
  Text title;
  std::vector<Text> axes;  // three labels
  std::vector<double> x, y, z;
};

using Drawing = std::variant<Chart, HeatMap, BoxPlot, SpacePlot>;

}  // namespace proofmass
