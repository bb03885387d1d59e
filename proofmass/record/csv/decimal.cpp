// SPDX-License-Identifier: Apache-2.0
// Reads eight digits at a time in one word. The integer w that the digits form and the power of ten that
// divides it are exact in the 64-bit significand of the x87 format. So w / 10^q is rounded once to 64 bits
// and once more to 53. The result equals a single rounding unless the 64 bits lie midway between two doubles.
#include "proofmass/record/csv/decimal.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace proofmass {
namespace {

using Word = std::uint64_t;

constexpr bool kExtended =
    std::numeric_limits<long double>::digits == 64 && std::endian::native == std::endian::little;
constexpr std::size_t kWide = sizeof(Word);  // digits read at a time
constexpr std::size_t kMostDecimals = 27;    // 5^27 < 2^64 <= 5^28
constexpr Word kZeros = 0x3030303030303030;  // "00000000"
constexpr Word kLargest = Word{1} << 63U;    // limit, because signed integers are converted faster

constexpr std::array<Word, kWide + 1> kPowers{1,       10,        100,        1000,       10'000,
                                              100'000, 1'000'000, 10'000'000, 100'000'000};

// A number w below kRoom[k] has room for k more digits.
constexpr auto kRoom = [] {
  std::array<Word, kWide + 1> room{};
  for (std::size_t k = 0; k <= kWide; ++k) room[k] = kLargest / kPowers[k] - 1;
  return room;
}();

constexpr auto kTens = [] {
  std::array<long double, kMostDecimals + 1> tens{};
  tens[0] = 1.0L;
  for (std::size_t k = 1; k <= kMostDecimals; ++k) tens[k] = tens[k - 1] * 10.0L;
  return tens;
}();

// Number of digits in `text` before its first other character, from the lowest byte up.
std::size_t digits_in(Word text) noexcept {
  const Word values = text ^ kZeros;  // a digit's byte becomes its value
  const Word others = ((values + 0x7676767676767676) | values) & 0x8080808080808080;
  return static_cast<std::size_t>(std::countr_zero(others)) / 8U;
}

// The number that eight digits form: neighbours are joined to pairs, pairs to fours, fours to eight.
Word value_of(Word text) noexcept {
  text -= kZeros;
  text = text * 10 + (text >> 8U);
  constexpr Word mask = 0x000000FF000000FF;
  constexpr Word even = 100 + (Word{1'000'000} << 32U);
  constexpr Word odd = 1 + (Word{10'000} << 32U);
  return ((text & mask) * even + ((text >> 16U) & mask) * odd) >> 32U;
}

// Appends the digits at `at` to `w` and returns their end; null when there is no room for them.
const char* append_digits(const char* at, const char* last, Word& w) noexcept {
  while (static_cast<std::size_t>(last - at) >= kWide) {
    Word text = 0;
    std::memcpy(&text, at, kWide);
    const std::size_t n = digits_in(text);
    if (w >= kRoom[n]) return nullptr;
    if (n == 0) return at;
    // Fewer than eight digits are shifted up, with zeros in front.
    if (n < kWide) text = (text << (64 - 8 * n)) | (kZeros >> (8 * n));
    w = w * kPowers[n] + value_of(text);
    at += n;
    if (n < kWide) return at;
  }
  for (; at != last && *at >= '0' && *at <= '9'; ++at) {
    if (w >= kRoom[1]) return nullptr;
    w = w * 10 + static_cast<Word>(*at - '0');
  }
  return at;
}

// Computes w / 10^decimals. False when the quotient is, or seems to be, midway between two doubles.
bool divide(Word w, std::size_t decimals, double& value) noexcept {
  const long double quotient = static_cast<long double>(static_cast<std::int64_t>(w)) / kTens[decimals];
  Word significand = 0;
  std::memcpy(&significand, &quotient, sizeof significand);
  value = static_cast<double>(quotient);
  return (significand & 0x7FFU) != 0x400U;
}

}  // namespace

Decimal scan_decimal(const char* first, const char* last) noexcept {
  if (!kExtended || first == last) return {};
  const bool negative = *first == '-';
  const char* const whole = first + (negative ? 1 : 0);
  Word w = 0;
  const char* at = append_digits(whole, last, w);
  if (at == nullptr) return {};
  auto digits = static_cast<std::size_t>(at - whole);
  std::size_t decimals = 0;
  if (at != last && *at == '.') {
    const char* const fraction = at + 1;
    at = append_digits(fraction, last, w);
    if (at == nullptr) return {};
    decimals = static_cast<std::size_t>(at - fraction);
    digits += decimals;
  }
  if (digits == 0 || decimals > kMostDecimals || (at != last && (*at == 'e' || *at == 'E'))) return {};
  double value = 0.0;
  if (!divide(w, decimals, value)) return {};
  // Signs follow no pattern, so a branch would be mispredicted.
  return {.value = std::bit_cast<double>(std::bit_cast<Word>(value) | Word{negative} << 63U),
          .end = at,
          .decimals = static_cast<int>(decimals)};
}

}  // namespace proofmass
