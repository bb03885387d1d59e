// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"

namespace proofmass::html {

ShownUnit residual_unit(const IdentificationContext& context) {
  return shown_unit(context.run.identification.output_unit, largest_of(context.record->rows.residuals));
}

std::vector<Series> series_by_part(const RecordFigures& record, const std::vector<double>& x,
                                   const std::vector<double>& y) {
  struct Shown {
    Part part;
    Label label;
    Mark mark;
  };
  constexpr std::array kParts{Shown{Part::training, Label::train, Mark::points},
                              Shown{Part::validation, Label::validation, Mark::points},
                              Shown{Part::test, Label::test, Mark::squares}};
  constexpr std::array<std::size_t, 3> kPartColours{0, 2, 1};
  std::vector<Series> made;
  for (std::size_t k = 0; k < kParts.size(); ++k) {
    Series one{.name = text_of(kParts[k].label),
               .x = {},
               .y = {},
               .mark = kParts[k].mark,
               .colour = kPartColours[k]};
    for (std::size_t row = 0; row < y.size(); ++row) {
      if (record.rows.parts[row] != kParts[k].part) continue;
      one.x.push_back(x[row]);
      one.y.push_back(y[row]);
    }
    if (!one.x.empty()) made.push_back(std::move(one));
  }
  if (made.size() == 1) made.front().name = {};
  return made;
}

std::string thinning_note(const RecordFigures& record) {
  if (record.numbers.size() == record.total_rows) return {};
  return paragraph(text_of(Label::thinned, {{"count", record.numbers.size()}, {"total", record.total_rows}}));
}

}  // namespace proofmass::html
