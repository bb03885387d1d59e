// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/page/section.hpp"
#include "proofmass/report/plot/svg.hpp"

namespace proofmass::html {

std::string figure(const Drawing& drawing, InteractiveFigures& interactive, const std::string& findings) {
  interactive.add(drawing);
  return std::visit(
      [&](const auto& one) {
        return fmt::format(
            "<figure id=\"figure-{0}\" role=\"figure\" aria-labelledby=\"caption-{0}\"><div "
            "class=\"drawing\">{1}"
            "<div class=\"live\"></div></div><figcaption id=\"caption-{0}\">{2}</figcaption>{3}</figure>\n",
            one.id, render_svg(drawing), both(one.title), findings);
      },
      drawing);
}

}  // namespace proofmass::html
