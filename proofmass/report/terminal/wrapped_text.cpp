// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/wrapped_text.hpp"

#include <algorithm>

#include "proofmass/report/text/display_width.hpp"

namespace proofmass {
namespace {

constexpr std::string_view kClosing = "，。；：、！？）」』》】〉”’…—·％";
constexpr std::string_view kOpening = "（「『《【〈“‘";

// What stays together.
struct WrapPiece {
  std::string_view text;
  bool after_blank = false;
};

bool may_part(const DisplayedCharacter& before, const DisplayedCharacter& after) {
  if (before.width != 2 && after.width != 2) return false;
  return kClosing.find(after.bytes) == std::string_view::npos &&
         kOpening.find(before.bytes) == std::string_view::npos && after.width > 0;
}

std::vector<WrapPiece> pieces_of_word(std::string_view word, bool after_blank) {
  std::vector<WrapPiece> pieces;
  std::size_t start = 0;
  DisplayedCharacter before = first_character(word);
  for (std::size_t at = before.bytes.size(); at < word.size(); at += before.bytes.size()) {
    const DisplayedCharacter after = first_character(word.substr(at));
    if (may_part(before, after)) {
      pieces.push_back({.text = word.substr(start, at - start), .after_blank = after_blank && start == 0});
      start = at;
    }
    before = after;
  }
  pieces.push_back({.text = word.substr(start), .after_blank = after_blank && start == 0});
  return pieces;
}

std::vector<WrapPiece> pieces_of(std::string_view text) {
  std::vector<WrapPiece> pieces;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::vector<WrapPiece> word = pieces_of_word(text.substr(at, end - at), at > 0);
    pieces.insert(pieces.end(), word.begin(), word.end());
    at = std::min(text.find_first_not_of(' ', end), text.size());
  }
  return pieces;
}

}  // namespace

std::vector<std::string> wrapped_lines(std::string_view text, std::size_t width, std::size_t indent) {
  if (width == 0 || display_width(text) <= width) return {std::string(text)};
  std::vector<std::string> lines;
  // Blanks before the first word stay.
  const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
  std::string line(text.substr(0, start));
  std::size_t used = start;
  bool has_piece = false;
  for (const WrapPiece& piece : pieces_of(text.substr(start))) {
    const std::size_t needed = display_width(piece.text);
    if (has_piece && used + (piece.after_blank ? 1 : 0) + needed > width) {
      lines.push_back(line);
      line.assign(indent, ' ');
      used = indent;
      has_piece = false;
    }
    if (has_piece && piece.after_blank) {
      line += ' ';
      ++used;
    }
    line += piece.text;
    used += needed;
    has_piece = true;
  }
  lines.push_back(std::move(line));
  return lines;
}

}  // namespace proofmass
