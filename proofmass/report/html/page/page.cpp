// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/page/page.hpp"

#include <fmt/format.h>

#include "proofmass/core/version.hpp"
#include "proofmass/files/sha256.hpp"
#include "proofmass/report/base64.hpp"
#include "proofmass/report/html/page/assets.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/plot/svg.hpp"

namespace proofmass::html {
namespace {

std::string_view code_of(Language language) { return language == Language::zh ? "zh-CN" : "en"; }

// The hash of a script by which a Content-Security-Policy lets it run (CSP Level 3, 2.3.1).
std::string script_hash(std::string_view script) {
  constexpr std::size_t kDigits = 2;
  constexpr int kBase = 16;
  const std::string hex = sha256_hex(script);
  std::string bytes;
  for (std::size_t k = 0; k < hex.size(); k += kDigits)
    bytes += static_cast<char>(std::stoi(hex.substr(k, kDigits), nullptr, kBase));
  return "'sha256-" + base64(bytes) + "'";
}

// No network at all: only what the file itself holds. Our script runs by its hash, and what it loads, the
// plotting library, by its trust.
std::string policy(bool live) {
  const std::string scripts =
      live ? fmt::format("script-src {} 'strict-dynamic'; ", script_hash(page_script())) : std::string();
  return "default-src 'none'; " + scripts +
         "style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'";
}

std::string head(const Page& page, const ReportStyle& style, bool live) {
  const std::string title = page.title.in(style.language) + (page.subject.empty() ? "" : ": " + page.subject);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"Proofmass {}\">\n<title>{}</title>\n<style>{}{}</style>\n</head>\n",
      code_of(style.language), policy(live), version(), escaped(title), svg_colours(), page_style());
}

// Without any script: a style sheet shows the language of the button that is checked.
std::string language_buttons(Language language) {
  std::string inputs;
  for (const Language one : kLanguages) {
    inputs += fmt::format(
        "<input class=\"choice\" type=\"radio\" name=\"language\" id=\"lang-{0}\" aria-label=\"{1}\"{2}>\n",
        one == Language::zh ? "zh" : "en", one == Language::zh ? "中文" : "English",
        one == language ? " checked" : "");
  }
  return inputs;
}

std::string contents(const Page& page) {
  std::string items;
  for (const Section& section : page.sections)
    items += fmt::format("<li><a href=\"#{}\">{}</a></li>", section.id, both(text_of(section.title)));
  return fmt::format("<nav aria-labelledby=\"contents\"><h2 id=\"contents\">{}</h2><ul>{}</ul></nav>\n",
                     both(text_of(Label::contents)), items);
}

std::string header(const Page& page) {
  return fmt::format(
      "<header><div class=\"languages\"><label for=\"lang-en\" lang=\"en\">English</label>"
      "<label for=\"lang-zh\" lang=\"zh\">中文</label></div>\n<h1>{}</h1>\n<p "
      "class=\"subject\">{}</p></header>\n",
      both(page.title), escaped(page.subject));
}

std::string sections(const Page& page) {
  std::string out;
  for (const Section& section : page.sections) {
    out += fmt::format("<section id=\"{}\"{}><h2>{}</h2>\n{}</section>\n", section.id,
                       section.short_ ? " class=\"short\"" : "", both(text_of(section.title)), section.body);
  }
  return out;
}

std::string live_parts(const InteractiveFigures& interactive) {
  return fmt::format(
      "<script type=\"application/json\" id=\"figure-data\">{}</script>\n"
      "<script type=\"text/plain\" id=\"plotting-licence\">{}</script>\n"
      "<script type=\"text/plain\" id=\"plotting-library\">{}</script>\n<script>{}</script>\n",
      interactive.json(), plotting_licence(), plotting_library(), page_script());
}

}  // namespace

std::string render(const Page& page, const InteractiveFigures& interactive, const ReportStyle& style) {
  const bool live = style.interactive && !plotting_library().empty() && !interactive.empty();
  const Text made = text_of(Label::made_by, {{"version", std::string(version())}});
  return head(page, style, live) + "<body>\n" + language_buttons(style.language) + header(page) +
         contents(page) + "<main>\n" + sections(page) + "</main>\n" + element("footer", both(made)) +
         (live ? live_parts(interactive) : std::string()) + "</body>\n</html>\n";
}

}  // namespace proofmass::html
