// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/report/html/page/section.hpp"
#include "proofmass/study/comparison.hpp"

namespace proofmass::html {

// As HTML, with the sentence that explains it; empty where there are no data.
[[nodiscard]] std::string deviation_figure(const Comparison& comparison, InteractiveFigures& interactive);
// Box plots of the test RMSE, of three repeats and more.
[[nodiscard]] std::string repeats_figure(const Comparison& comparison, InteractiveFigures& interactive);
[[nodiscard]] std::string time_figure(const Comparison& comparison, InteractiveFigures& interactive);

}  // namespace proofmass::html
