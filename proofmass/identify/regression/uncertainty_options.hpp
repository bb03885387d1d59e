// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/options/field.hpp"

namespace proofmass {

// Standard errors from the uncertainties as they are, or multiplied by the root of chi²/dof.
enum class ChiSquareScaling { given, scaled };
inline constexpr std::array kScalingWords{Word<ChiSquareScaling>{"given", ChiSquareScaling::given},
                                          Word<ChiSquareScaling>{"chi2", ChiSquareScaling::scaled}};

// Which of a record's sigma columns a fit goes by.
struct SigmaColumns {
  bool output = false;
  bool inputs = false;
  // What a fit can go by instead.
  Remedy instead_of_output{};
  Remedy instead_of_inputs{};
};

// What tls and eiv take the uncertainties of inputs and output for.
struct UncertaintyOptions {
  std::optional<double> input{};   // g; of every axis in every row, in place of the record's sigma_Ai, …
  std::optional<double> output{};  // g, referred to the input (times |Ki|); in place of the record's sigma_E
  ChiSquareScaling scaling = ChiSquareScaling::given;  // chi² over output residuals and input offsets

  // Those that no constant takes the place of.
  [[nodiscard]] SigmaColumns sigma_columns() const noexcept;

  static constexpr auto fields = std::tuple{
      field("sigma-input-ug", &UncertaintyOptions::input,
            "uncertainty of the accelerations, in place of the record's sigma_Ai, ...", at_least(0.0),
            {.place = "eiv.md#what-it-needs", .unit = "ug", .per_unit = 1e6, .absent = "none"}),
      field("sigma-output-ug", &UncertaintyOptions::output,
            "uncertainty of the output, referred to the input, in place of sigma_E", above(0.0),
            {.place = "eiv.md#what-it-needs", .unit = "ug", .per_unit = 1e6, .absent = "none"}),
      field("sigma-scale", &UncertaintyOptions::scaling,
            "standard errors by the sigmas as given, or scaled by chi2/dof", kScalingWords,
            {.place = "eiv.md#standard-errors"})};
};

}  // namespace proofmass
