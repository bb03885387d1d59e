// SPDX-License-Identifier: Apache-2.0
#include "initial_swarm.hpp"

#include <charconv>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>

#include "proofmass/core/error.hpp"
#include "proofmass/core/text.hpp"
#include "proofmass/files/text_file.hpp"

namespace proofmass::cli {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20U;

double coordinate(std::string_view text, const Place& place) {
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw bad_data(place, text.empty() ? FoundText("nothing") : FoundText(text), "a finite number");
  }
  return value;
}

std::vector<double> position(std::string_view line, const Place& place) {
  std::vector<double> values;
  while (true) {
    const std::size_t comma = line.find(',');
    values.push_back(coordinate(trimmed(line.substr(0, comma)), place));
    if (comma == std::string_view::npos) return values;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

std::vector<std::vector<double>> read_positions(const std::filesystem::path& path) {
  Place place{.file = path.string(), .row = 0, .column = {}};
  std::istringstream file(read_text_file(path, "a file of positions that can be read", kMostBytes));
  std::vector<std::vector<double>> positions;
  for (std::string line; std::getline(file, line);) {
    ++place.row;
    const std::string_view text = trimmed(line);
    if (!text.empty() && text.front() != '#') positions.push_back(position(text, place));
  }
  place.row = 0;
  if (positions.empty()) throw bad_data(place, "no position", "a line of numbers for each particle");
  return positions;
}

}  // namespace proofmass::cli
