// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/mape_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace proofmass {

void MapeRows::Counts::add(std::size_t count) {
  least = most == 0 ? count : std::min(least, count);
  most = std::max(most, count);
}

void MapeRows::add(const Text& part, const std::optional<Metrics>& metrics) {
  if (!metrics || metrics->mape_rows == 0) return;
  auto known =
      std::find_if(parts_.begin(), parts_.end(), [&part](const Part& other) { return other.name == part; });
  if (known == parts_.end()) {
    known = parts_.insert(parts_.end(), Part{.name = part, .used = {}, .rows = {}});
  }
  known->used.add(metrics->mape_rows);
  known->rows.add(metrics->n);
  known->leaves_out = known->leaves_out || metrics->mape_rows < metrics->n;
}

std::string MapeRows::text(Language language) const {
  constexpr Words kTo{"{} to {}", "{} 至 {}"};
  constexpr Words kComma{", ", "、"};
  constexpr Words kPart{"{0} of {1} {2} rows", "{2} {1} 行中的 {0} 行"};
  constexpr Words kAll{"MAPE leaves out outputs below {:g} % of their range: it is over {}",
                       "MAPE 不计小于输出范围 {:g} % 的输出：只统计{}"};
  const auto counted = [&](const Counts& counts) {
    return counts.least == counts.most
               ? fmt::format("{}", counts.most)
               : fmt::format(fmt::runtime(kTo.in(language)), counts.least, counts.most);
  };
  std::string parts;
  for (const Part& part : parts_) {
    if (!part.leaves_out) continue;
    if (!parts.empty()) parts += kComma.in(language);
    parts += fmt::format(fmt::runtime(kPart.in(language)), counted(part.used), counted(part.rows),
                         part.name.in(language));
  }
  if (parts.empty()) return {};
  return fmt::format(fmt::runtime(kAll.in(language)), 100.0 * kMapeFloor, parts);
}

}  // namespace proofmass
