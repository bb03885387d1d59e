// SPDX-License-Identifier: Apache-2.0
// Numbers as text for people: as many digits as mean something.
#pragma once

#include <optional>
#include <string>

namespace proofmass {

// The value to two digits of its standard error: uncertain_text(0.99997900123, 2.2e-9) is "0.9999790012".
// Between 3 and 15 significant digits; six without a standard error.
[[nodiscard]] std::string uncertain_text(double value, const std::optional<double>& standard_error);

// `digits` significant digits, trailing zeros kept: "1.500e-06", "12.30".
[[nodiscard]] std::string significant_text(double value, int digits);

// "13.062 ± 0.022", "(1.30617 ± 0.00022)e-05", "-280000 ± 500000": both to two digits of the error.
[[nodiscard]] std::string plus_minus_text(double value, double standard_error);

// "[13.018, 13.106]", "[1.30573, 1.30661]e-05": the interval of such a value, in the same digits.
[[nodiscard]] std::string interval_text(double value, double standard_error, double low, double high);

// R², as "0.998712"; where 1 - R² is below 1e-4 as what it lacks of one, "1 - 2.31e-13".
[[nodiscard]] std::string determination_text(double r2);

}  // namespace proofmass
