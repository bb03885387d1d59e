// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/page/html.hpp"

#include <fmt/format.h>

#include <array>

#include "proofmass/report/typography.hpp"
#include "proofmass/report/xml_text.hpp"

namespace proofmass::html {

std::string escaped(std::string_view text) { return xml_escaped(text); }

std::string in_print(std::string_view text) { return escaped(typeset_unit(typeset(text))); }

Text in_print(const Text& text) { return {typeset(text.en), typeset(text.zh)}; }

std::string both(const Text& text) {
  if (text.en == text.zh) return escaped(text.en);
  return fmt::format("<span lang=\"en\">{}</span><span lang=\"zh\">{}</span>", escaped(text.en),
                     escaped(text.zh));
}

std::string element(std::string_view tag, std::string_view content, std::string_view attributes) {
  return fmt::format("<{0}{1}{2}>{3}</{0}>\n", tag, attributes.empty() ? "" : " ", attributes, content);
}

std::string paragraph(const Text& text) {
  if (text.en.empty()) return {};
  return element("p", both(text));
}

std::string Table::html() const {
  std::string head;
  const auto alignment = [&](std::size_t k) {
    constexpr std::array<std::string_view, 3> kClasses{"", " class=\"number\"", " class=\"reading\""};
    return kClasses.at(static_cast<std::size_t>(columns_[k].align));
  };
  for (std::size_t k = 0; k < columns_.size(); ++k)
    head += fmt::format("<th scope=\"col\"{}>{}</th>", alignment(k), both(columns_[k].name));
  std::string body;
  for (const auto& cells : rows_) {
    body += "<tr>";
    for (std::size_t k = 0; k < cells.size(); ++k) {
      body += k == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", alignment(k), cells[k])
                     : fmt::format("<td{}>{}</td>", alignment(k), cells[k]);
    }
    body += "</tr>\n";
  }
  return fmt::format(
      "<div class=\"wide\" tabindex=\"0\" "
      "role=\"group\"><table><caption{}>{}</caption>\n<thead><tr>{}</tr></thead>\n"
      "<tbody>\n{}</tbody></table></div>\n",
      hidden_ ? " class=\"hidden\"" : "", caption_, head, body);
}

void Definitions::add(const Text& name, std::string_view content) {
  body_ += fmt::format("<dt>{}</dt><dd>{}</dd>\n", both(name), content);
}

std::string Definitions::html() const { return element("dl", body_); }

}  // namespace proofmass::html
