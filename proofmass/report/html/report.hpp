// SPDX-License-Identifier: Apache-2.0
// Reports as one HTML file each, which opens from disk and asks no network.
#pragma once

#include <string>

#include "proofmass/assess/residuals/record_figures.hpp"
#include "proofmass/core/run.hpp"
#include "proofmass/report/html/page/style.hpp"
#include "proofmass/study/comparison.hpp"
#include "proofmass/study/paper/reproduction.hpp"

namespace proofmass {

// `record`: figures of the rows, or null where the record is not at hand; `why` then says why.
[[nodiscard]] std::string render_report(const Run& run, const RecordFigures* record,
                                        const ReportStyle& style = {}, const Text& why = {});

[[nodiscard]] std::string render_report(const Comparison& comparison, const ReportStyle& style = {});
[[nodiscard]] std::string render_report(const Reproduction& made, const ReportStyle& style = {});

}  // namespace proofmass
