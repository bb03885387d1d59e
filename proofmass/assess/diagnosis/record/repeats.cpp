// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/repeats.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace proofmass {
namespace {

using Columns = std::span<const std::vector<double>* const>;

// A step of SplitMix64 (Steele, Lea and Flood 2014): every bit of the sum reaches every bit of the result.
std::uint64_t mix(std::uint64_t bits) noexcept {
  bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9;
  bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EB;
  return bits ^ (bits >> 31U);
}

std::uint64_t hash_of(Columns columns, std::size_t row) noexcept {
  std::uint64_t hash = 0;
  for (const auto* column : columns) {
    const double value = (*column)[row] + 0.0;  // minus zero becomes zero
    hash = mix(hash + 0x9E3779B97F4A7C15 + std::bit_cast<std::uint64_t>(value));
  }
  return hash;
}

bool equal(Columns columns, std::size_t a, std::size_t b) noexcept {
  return std::all_of(columns.begin(), columns.end(),
                     [a, b](const auto* column) { return (*column)[a] == (*column)[b]; });
}

}  // namespace

// Rows go into a hash table with open addressing, at most two thirds full; unlike sorting it takes one look
// at each row, however many are equal.
std::vector<std::size_t> earlier_equals(std::size_t rows, Columns columns) {
  std::vector<std::size_t> table(std::bit_ceil(rows + rows / 2 + 1), rows);  // `rows` means a free place
  const std::size_t mask = table.size() - 1;
  std::vector<std::size_t> earlier(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    std::size_t place = hash_of(columns, row) & mask;
    while (table[place] != rows && !equal(columns, table[place], row)) place = (place + 1) & mask;
    earlier[row] = table[place] == rows ? row : table[place];
    table[place] = row;
  }
  return earlier;
}

std::size_t count_repeats(std::size_t rows, Columns columns) {
  const std::vector<std::size_t> earlier = earlier_equals(rows, columns);
  std::size_t repeats = 0;
  for (std::size_t row = 0; row < rows; ++row) repeats += static_cast<std::size_t>(earlier[row] != row);
  return repeats;
}

}  // namespace proofmass
