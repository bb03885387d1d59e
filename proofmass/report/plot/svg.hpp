// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "proofmass/report/plot/figure.hpp"

namespace proofmass {

// How an image is meant to be used.
struct SvgUse {
  // A file of its own, with its colours, in one language; otherwise a part of an HTML page, which has the
  // colours (svg_colours) and shows the texts of the language that is chosen.
  std::optional<Language> file{};
};

// Width 640; height 400 but for maps. Complete without any script.
[[nodiscard]] std::string render_svg(const Drawing& figure, const SvgUse& use = {});

// The style sheet that the classes of the images refer to: colours for light and dark that are told apart by
// those who see red and green alike (Wong, Nature Methods 8, 2011) and by their grey.
[[nodiscard]] std::string_view svg_colours();

}  // namespace proofmass
