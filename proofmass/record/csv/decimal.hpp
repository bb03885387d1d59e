// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace proofmass {

// So many bytes from the first of a number on must be readable, whatever they are.
inline constexpr std::size_t kDecimalWindow = 40;

struct Decimal {
  double value = 0.0;
  const char* end = nullptr;  // first character after the number; null when it was not read
};

// Reads the number that begins at `first`, correctly rounded, when it is one as records mostly hold: with or
// without '-', at most 8 digits, then perhaps a point and more digits, at most 18 in all. Any other, and the
// rare one that would take more than one rounding, is left to scan_number.
[[nodiscard]] Decimal scan_decimal(const char* first, const char* last) noexcept;

}  // namespace proofmass
