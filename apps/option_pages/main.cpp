// SPDX-License-Identifier: Apache-2.0
// Prints the tables of options of docs/commands.md, in Markdown; scripts/docs.sh puts them there.
#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/identify/method_options.hpp"

namespace {

using namespace proofmass;

// A bar would end the cell.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped.append(c == '|' ? "\\|" : std::string(1, c));
  return escaped;
}

void print_header(const std::string& title) {
  std::printf("### %s\n\n| option | default | meaning |\n|---|---|---|\n", title.c_str());
}

void print_row(const OptionInfo& option, const std::string& value) {
  std::string meaning(option.help);
  if (!option.unit.empty()) meaning.append(", in ").append(option.unit);
  if (!option.range.empty()) meaning += "; " + option.range;
  const std::string_view place = option.place;
  std::printf("| `--%s %s` | %s | %s ([more](%s)) |\n", std::string(option.name).c_str(),
              cell(option.type).c_str(), cell(value).c_str(), cell(meaning).c_str(),
              std::string(place).c_str());
}

std::string joined(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) text.append(text.empty() ? "`" : ", `").append(name).append("`");
  return text;
}

}  // namespace

int main() {
  print_header("Options of every method");
  for (const OptionInfo& option : options_of(IdentifyOptions{})) print_row(option, option.value);
  std::vector<SharedOption> options = shared_options();
  while (!options.empty()) {
    const std::vector<std::string_view> methods = options.front().methods;
    std::printf("\n");
    print_header("Options of " + joined(methods));
    const auto same = [&methods](const SharedOption& option) { return option.methods == methods; };
    for (const SharedOption& option : options) {
      if (same(option)) print_row(option.info, option.defaults);
    }
    std::erase_if(options, same);
  }
  return 0;
}
