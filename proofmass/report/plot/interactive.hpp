// SPDX-License-Identifier: Apache-2.0
// Figures as data for the plotting library that a report carries (plotly.js), which lets people zoom, read
// values and save images. Heat maps and boxes stay as they are drawn.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "proofmass/report/plot/figure.hpp"

namespace proofmass {

// Collects figures; columns that several share are stored once, in single precision where that suits them.
class InteractiveFigures {
 public:
  void add(const Drawing& figure);
  [[nodiscard]] bool empty() const noexcept { return figures_.empty(); }
  // {"columns": ["f" and base64 of little-endian float32, or "d" and of float64, ...], "figures": [...]};
  // free of "<", so that it can stand in HTML.
  [[nodiscard]] std::string json() const;

 private:
  std::size_t column(const std::vector<double>& values);

  std::map<std::string, std::size_t> numbers_;  // of the columns, by their text
  std::vector<std::string> columns_;
  std::vector<std::string> figures_;  // each as JSON
};

}  // namespace proofmass
