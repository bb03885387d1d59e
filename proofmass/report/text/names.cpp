// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/names.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "proofmass/report/text/label.hpp"

namespace proofmass {
namespace {

struct NamedCurve {
  std::string_view name;
  Label label;
};
constexpr std::array kCurves{NamedCurve{"train", Label::train},
                             NamedCurve{"training", Label::train},
                             NamedCurve{"validation", Label::validation},
                             NamedCurve{"test", Label::test},
                             NamedCurve{"swarm_best", Label::swarm_best},
                             NamedCurve{"swarm_mean", Label::swarm_mean},
                             NamedCurve{"fish_best", Label::fish_best},
                             NamedCurve{"fish_mean", Label::fish_mean},
                             NamedCurve{"information_criterion", Label::information_criterion},
                             NamedCurve{"weighted_sum_of_squares", Label::weighted_squares},
                             NamedCurve{"criterion_by_terms", Label::criterion_by_terms},
                             NamedCurve{"criterion_by_layer", Label::criterion_by_layer}};

// What stands behind the comma of an entry, or in front of its method.
constexpr std::array kEntryWords{Words{", 8 terms", "，8 项"},   Words{", 15 terms", "，15 项"},
                                 Words{", 21 terms", "，21 项"}, Words{", paper", "，论文设置"},
                                 Words{", ours", "，默认设置"},  Words{"multistart BP", "多次初始化 BP"}};

}  // namespace

Text curve_name(const std::string& curve) {
  for (const NamedCurve& known : kCurves)
    if (known.name == curve) return words(known.label);
  return same_text(curve);
}

Text entry_name(const std::string& entry) {
  for (const Words& known : kEntryWords) {
    if (!entry.ends_with(known.en)) continue;
    std::string chinese = entry.substr(0, entry.size() - known.en.size()).append(known.zh);
    return {entry, std::move(chinese)};
  }
  return same_text(entry);
}

}  // namespace proofmass
