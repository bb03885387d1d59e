// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "proofmass/report/plot/figure.hpp"
#include "proofmass/study/paper/reproduction.hpp"

namespace proofmass {

struct PaperFigure {
  std::string name;  // of its files, without the ending
  Chart chart;
};

// Figures 4 to 8, in order.
[[nodiscard]] std::vector<PaperFigure> figures_of(const Reproduction& made);

// The figure's numbers: series,x,y.
[[nodiscard]] std::string figure_csv(const Chart& chart);

}  // namespace proofmass
