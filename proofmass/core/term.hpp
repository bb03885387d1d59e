// SPDX-License-Identifier: Apache-2.0
// The 21 terms of the static model equation (IEEE Std 836, IEEE Std 1293), in the order used in code, files
// and reports.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proofmass {

enum class Axis : std::uint8_t { input, output, pendulous };
inline constexpr std::array<Axis, 3> kAxes{Axis::input, Axis::output, Axis::pendulous};

// "Ai", "Ao" or "Ap".
[[nodiscard]] std::string_view axis_name(Axis axis) noexcept;

enum class Term : std::uint8_t {
  K0,
  Ki,
  Kii,
  Koq,
  Kiii,
  Kio,
  Kip,
  Kop,
  Ko,
  Koo,
  Kooo,
  Kp,
  Kpp,
  Kppp,
  Kioo,
  Kipp,
  Kopp,
  Koii,
  Kpoo,
  Kpii,
  Kiop
};
inline constexpr std::size_t kTermCount = 21;

// Specific force along the three axes, in g.
struct Acceleration {
  double i = 0.0;
  double o = 0.0;
  double p = 0.0;
};
[[nodiscard]] double magnitude(const Acceleration& a) noexcept;

struct TermInfo {
  Term term;
  std::string_view name;      // "Kioo"
  std::string_view product;   // "Ai*Ao^2"
  std::array<int, 3> powers;  // of Ai, Ao, Ap; Koq counts as Ai^2
  [[nodiscard]] constexpr int order() const noexcept { return powers[0] + powers[1] + powers[2]; }
  [[nodiscard]] constexpr bool uses(Axis axis) const noexcept {
    return powers[static_cast<std::size_t>(axis)] > 0;
  }
};

[[nodiscard]] const std::array<TermInfo, kTermCount>& all_terms() noexcept;
[[nodiscard]] const TermInfo& info(Term term) noexcept;
[[nodiscard]] inline std::string_view name(Term term) noexcept { return info(term).name; }
[[nodiscard]] std::optional<Term> find_term(std::string_view name) noexcept;

// The regressor of a term, for example Ai*Ao^2 (and |Ai|*Ai for Koq), in powers of g.
[[nodiscard]] double regressor(Term term, const Acceleration& a) noexcept;

// Its derivative along an axis; that of |Ai|*Ai is 2|Ai|.
[[nodiscard]] double regressor_slope(Term term, const Acceleration& a, Axis axis) noexcept;

using TermList = std::vector<Term>;  // canonical order, no repeats

// A preset (linear, quadratic, paper, full) or a comma-separated list of names. Throws a usage Error that
// states the name that is unknown or repeated.
[[nodiscard]] TermList parse_terms(std::string_view text);
[[nodiscard]] TermList linear_terms();
[[nodiscard]] TermList quadratic_terms();
[[nodiscard]] TermList paper_terms();
[[nodiscard]] TermList full_terms();
[[nodiscard]] std::string join_names(const TermList& terms);

}  // namespace proofmass
