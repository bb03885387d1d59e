// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "proofmass/report/plot/svg_canvas_internal.hpp"

namespace proofmass {
namespace {

constexpr std::string_view kColours = R"(
.figure{--ink:#222;--grid:#ddd;--paper:#fff;--c0:#0072b2;--c1:#d55e00;--c2:#009e73;--c3:#cc79a7;--c4:#8a6d00;--c5:#555}
.figure text{fill:var(--ink);font:16px sans-serif}
.figure .title{font-size:17px;font-weight:600}
.figure .grid{stroke:var(--grid);fill:none}
.figure .axis{stroke:var(--ink);fill:none}
.figure .guide{stroke:var(--ink);fill:none;stroke-dasharray:2 3}
.figure .line{fill:none;stroke-width:3.4;stroke-linejoin:round}
.figure .dashes{fill:none;stroke-width:3.4;stroke-dasharray:12 6}
.figure .points{fill:none;stroke-width:7;stroke-linecap:round}
.figure .squares{fill:none;stroke-width:6;stroke-linecap:square}
.figure .few.points{stroke-width:13}
.figure .few.squares{stroke-width:11}
.figure .steps{fill:none;stroke-width:2.8}
.figure .whisker{fill:none;stroke-width:2.8}
.figure .box{fill:none;stroke-width:1.6}
.figure .spot{fill:none;stroke-width:5;stroke-linecap:round}
.figure .cell{fill:#000;font-size:10.5px}
.figure .strong{font-weight:600}
.figure .small{font-size:13px}
.figure .band{stroke:none;opacity:.25}
.figure .s0{stroke:var(--c0)}.figure .s1{stroke:var(--c1)}.figure .s2{stroke:var(--c2)}
.figure .s3{stroke:var(--c3)}.figure .s4{stroke:var(--c4)}.figure .s5{stroke:var(--c5)}
.figure .f0{fill:var(--c0)}.figure .f1{fill:var(--c1)}.figure .f2{fill:var(--c2)}
.figure .f3{fill:var(--c3)}.figure .f4{fill:var(--c4)}.figure .f5{fill:var(--c5)}
@media print,(max-width:600px){.figure text,.figure .title{font-size:18px}}
@media (prefers-color-scheme:dark){@media screen{
.figure{--ink:#ddd;--grid:#444;--paper:#181a1b;--c0:#56b4e9;--c1:#e8884a;--c2:#3cc7a0;--c3:#dfa0c3;--c4:#d9b83c;--c5:#aaa}}}
)";

std::string_view name_of(SvgCanvas::Anchor anchor) {
  constexpr std::array<std::string_view, 3> kNames{"start", "middle", "end"};
  return kNames.at(static_cast<std::size_t>(anchor));
}

}  // namespace

std::string_view svg_colours() { return kColours; }

SvgCanvas::SvgCanvas(double width, double height, const SvgUse& use)
    : width_(width), height_(height), use_(use) {}

void SvgCanvas::element(std::string_view attributes, const Text& text, std::string_view style) {
  const auto put = [&](std::string_view words, std::string_view language) {
    const std::string classes = language.empty() || style.empty() ? fmt::format("{}{}", style, language)
                                                                  : fmt::format("{} {}", style, language);
    body_ += fmt::format("<text {}{}>{}</text>", attributes,
                         classes.empty() ? "" : fmt::format(" class=\"{}\"", classes), xml_escaped(words));
  };
  if (use_.file || text.en == text.zh) return put(text.in(use_.file.value_or(Language::en)), "");
  put(text.en, "en");
  put(text.zh, "zh");
}

void SvgCanvas::text(double x, double y, const Text& text, Anchor anchor, std::string_view style) {
  element(fmt::format("x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"", x, y, name_of(anchor)), text, style);
}

void SvgCanvas::text(double x, double y, std::string_view text, Anchor anchor, std::string_view style) {
  this->text(x, y, same_text(std::string(text)), anchor, style);
}

void SvgCanvas::upright(double x, double y, const Text& text) {
  element(fmt::format("transform=\"translate({:.1f} {:.1f}) rotate(-90)\" text-anchor=\"middle\"", x, y),
          text, "");
}

void SvgCanvas::path(std::string_view data, std::string_view style) {
  if (!data.empty()) body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>", style, data);
}

std::string SvgCanvas::finish() const {
  const std::string size = fmt::format("viewBox=\"0 0 {:.0f} {:.0f}\"", width_, height_);
  if (!use_.file) return fmt::format("<svg class=\"figure\" {} aria-hidden=\"true\">{}</svg>", size, body_);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"figure\" {} width=\"{:.0f}\" "
      "height=\"{:.0f}\"><style>{}</style>"
      "<rect width=\"100%\" height=\"100%\" style=\"fill:var(--paper)\"/>{}</svg>\n",
      size, width_, height_, kColours, body_);
}

std::string render_svg(const Drawing& figure, const SvgUse& use) {
  return std::visit([&](const auto& one) { return svg_of(one, use); }, figure);
}

}  // namespace proofmass
