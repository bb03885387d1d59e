// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace proofmass {

// This many bytes from the start of a number must be readable; their values do not matter.
inline constexpr std::size_t kDecimalWindow = 40;

struct Decimal {
  double value = 0.0;
  const char* end = nullptr;  // first character after the number; null when it was not read
  int decimals = 0;           // digits after the point
};

// Reads the number that begins at `first`, correctly rounded, if it has the usual form: an optional '-', at
// most 8 digits, optionally a point and more digits, at most 18 digits in all. Other numbers, and the rare
// ones that would need more than one rounding, are left to scan_number.
[[nodiscard]] Decimal scan_decimal(const char* first, const char* last) noexcept;

}  // namespace proofmass
