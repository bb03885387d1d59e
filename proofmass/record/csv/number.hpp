// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "proofmass/core/message.hpp"

namespace proofmass {

enum class NumberFault { none, not_a_number, not_finite, out_of_range };

struct ScannedNumber {
  double value = 0.0;
  const char* end = nullptr;  // first character after the number
  NumberFault fault = NumberFault::none;
  int decimals =
      0;  // digits after the point of the number written out without its exponent: 8 for 1.25e-6, -1 for 5e1
};

// Reads the decimal number that begins at `first`, correctly rounded. A leading '+' is allowed, blanks are
// not.
[[nodiscard]] ScannedNumber scan_number(const char* first, const char* last) noexcept;

// What is wrong with a field that should hold one number and nothing else.
[[nodiscard]] NumberFault number_fault(std::string_view field) noexcept;

// What was expected instead of a wrong field, for an error message.
[[nodiscard]] Message expected_number(std::string_view field, NumberFault fault);

}  // namespace proofmass
