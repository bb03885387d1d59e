// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/term.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "proofmass/core/error.hpp"
#include "proofmass/core/text.hpp"

namespace proofmass {
namespace {

constexpr std::array<TermInfo, kTermCount> kTerms{{
    {Term::K0, "K0", "1", {0, 0, 0}},
    {Term::Ki, "Ki", "Ai", {1, 0, 0}},
    {Term::Kii, "Kii", "Ai^2", {2, 0, 0}},
    {Term::Koq, "Koq", "|Ai|*Ai", {2, 0, 0}},
    {Term::Kiii, "Kiii", "Ai^3", {3, 0, 0}},
    {Term::Kio, "Kio", "Ai*Ao", {1, 1, 0}},
    {Term::Kip, "Kip", "Ai*Ap", {1, 0, 1}},
    {Term::Kop, "Kop", "Ao*Ap", {0, 1, 1}},
    {Term::Ko, "Ko", "Ao", {0, 1, 0}},
    {Term::Koo, "Koo", "Ao^2", {0, 2, 0}},
    {Term::Kooo, "Kooo", "Ao^3", {0, 3, 0}},
    {Term::Kp, "Kp", "Ap", {0, 0, 1}},
    {Term::Kpp, "Kpp", "Ap^2", {0, 0, 2}},
    {Term::Kppp, "Kppp", "Ap^3", {0, 0, 3}},
    {Term::Kioo, "Kioo", "Ai*Ao^2", {1, 2, 0}},
    {Term::Kipp, "Kipp", "Ai*Ap^2", {1, 0, 2}},
    {Term::Kopp, "Kopp", "Ao*Ap^2", {0, 1, 2}},
    {Term::Koii, "Koii", "Ao*Ai^2", {2, 1, 0}},
    {Term::Kpoo, "Kpoo", "Ap*Ao^2", {0, 2, 1}},
    {Term::Kpii, "Kpii", "Ap*Ai^2", {2, 0, 1}},
    {Term::Kiop, "Kiop", "Ai*Ao*Ap", {1, 1, 1}},
}};

constexpr std::array kLinear{Term::K0, Term::Ki, Term::Ko, Term::Kp};
constexpr std::array kQuadratic{Term::K0,  Term::Ki, Term::Kii, Term::Kio, Term::Kip,
                                Term::Kop, Term::Ko, Term::Koo, Term::Kp,  Term::Kpp};
// The 15 terms of the paper's Table 2.
constexpr std::array kPaper{Term::K0,  Term::Ki,  Term::Kii,  Term::Kiii, Term::Kio,
                            Term::Kip, Term::Kop, Term::Ko,   Term::Koo,  Term::Kooo,
                            Term::Kp,  Term::Kpp, Term::Kipp, Term::Koii, Term::Kpoo};

TermList sorted(std::span<const Term> terms) {
  TermList list(terms.begin(), terms.end());
  std::sort(list.begin(), list.end());
  return list;
}

double power(double base, int exponent) noexcept {
  double result = 1.0;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

TermList parse_list(std::string_view text) {
  TermList list;
  while (true) {
    const auto comma = text.find(',');
    const auto word = trimmed(text.substr(0, comma));
    const auto term = find_term(word);
    if (!term) {
      throw usage_error(
          message("unknown term '{}'; expected linear, quadratic, paper, full, or names among {}", word,
                  join_names(parse_terms("full"))));
    }
    if (std::find(list.begin(), list.end(), *term) != list.end()) {
      throw usage_error(message("term '{}' is listed twice", word));
    }
    list.push_back(*term);
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  return sorted(list);
}

}  // namespace

std::string_view axis_name(Axis axis) noexcept {
  constexpr std::array<std::string_view, 3> names{"Ai", "Ao", "Ap"};
  return names[static_cast<std::size_t>(axis)];
}

const std::array<TermInfo, kTermCount>& all_terms() noexcept { return kTerms; }

const TermInfo& info(Term term) noexcept { return kTerms[static_cast<std::size_t>(term)]; }

std::optional<Term> find_term(std::string_view name) noexcept {
  const auto* const found =
      std::find_if(kTerms.begin(), kTerms.end(), [&](const TermInfo& t) { return t.name == name; });
  if (found == kTerms.end()) return std::nullopt;
  return found->term;
}

double regressor(Term term, const Acceleration& a) noexcept {
  if (term == Term::Koq) return std::abs(a.i) * a.i;
  const auto& powers = info(term).powers;
  return power(a.i, powers[0]) * power(a.o, powers[1]) * power(a.p, powers[2]);
}

double regressor_slope(Term term, const Acceleration& a, Axis axis) noexcept {
  if (term == Term::Koq) return axis == Axis::input ? 2.0 * std::abs(a.i) : 0.0;
  auto powers = info(term).powers;
  int& own = powers[static_cast<std::size_t>(axis)];
  if (own == 0) return 0.0;
  const double factor = own--;
  return factor * power(a.i, powers[0]) * power(a.o, powers[1]) * power(a.p, powers[2]);
}

TermList parse_terms(std::string_view text) {
  const auto word = trimmed(text);
  if (word == "linear") return linear_terms();
  if (word == "quadratic") return quadratic_terms();
  if (word == "paper") return paper_terms();
  if (word == "full") return full_terms();
  return parse_list(word);
}

TermList linear_terms() { return sorted(kLinear); }
TermList quadratic_terms() { return sorted(kQuadratic); }
TermList paper_terms() { return sorted(kPaper); }
TermList full_terms() {
  TermList list;
  for (const auto& entry : kTerms) list.push_back(entry.term);
  return list;
}

std::string join_names(const TermList& terms) {
  std::string text;
  for (const Term term : terms) {
    if (!text.empty()) text += ", ";
    text += name(term);
  }
  return text;
}

double magnitude(const Acceleration& a) noexcept { return std::sqrt(a.i * a.i + a.o * a.o + a.p * a.p); }

}  // namespace proofmass
