// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/random.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace proofmass {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t kGolden =
    0x9e3779b97f4a7c15ULL;  // 2^64 over the golden ratio, splitmix64's increment

// The finaliser of splitmix64 (Steele, Lea & Flood 2014): a bijection of 64-bit words.
std::uint64_t mix(std::uint64_t z) noexcept {
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

// log x for finite x > 0 from 2 artanh((m - 1)/(m + 1)) with m in [sqrt(1/2), sqrt(2)). It uses exactly
// rounded operations only, so draws do not depend on the machine's mathematical library. Accurate to about 2
// ulp.
double portable_log(double x) noexcept {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < std::numbers::sqrt2 / 2) {
    m *= 2.0;
    --exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  double series = 0.0;
  for (int k = 25; k >= 1; k -= 2) series = series * s2 + 1.0 / k;
  return exponent * std::numbers::ln2 + 2.0 * s * series;
}

}  // namespace

std::array<std::uint64_t, 4> philox_block(const std::array<std::uint64_t, 4>& counter,
                                          const std::array<std::uint64_t, 2>& key) noexcept {
  const r123::Philox4x64::ctr_type in{{counter[0], counter[1], counter[2], counter[3]}};
  const auto out = r123::Philox4x64()(in, {{key[0], key[1]}});
  return {out[0], out[1], out[2], out[3]};
}

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream) noexcept
    : seed_(seed), stream_(stream) {}

void RandomStream::refill() noexcept {
  words_ = philox_block({block_, 0, 0, 0}, {seed_, stream_});
  ++block_;
  used_ = 0;
}

std::uint64_t RandomStream::bits() noexcept {
  if (used_ == words_.size()) refill();
  return words_[used_++];
}

double RandomStream::uniform() noexcept { return static_cast<double>(bits() >> 11U) * 0x1p-53; }

double RandomStream::uniform(double low, double high) noexcept {
  const double value = low + (high - low) * uniform();
  // Rounding can give the excluded end of the interval.
  return value < high ? value : low;
}

std::size_t RandomStream::index(std::size_t n) noexcept {
  const std::uint64_t range = n;
  Wide product = Wide{bits()} * range;
  if (static_cast<std::uint64_t>(product) < range) {
    const std::uint64_t surplus = (0 - range) % range;  // 2^64 mod n
    while (static_cast<std::uint64_t>(product) < surplus) product = Wide{bits()} * range;
  }
  return static_cast<std::size_t>(product >> 64U);
}

double RandomStream::normal() noexcept {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double u = 0.0;
  double v = 0.0;
  double square = 0.0;
  do {
    u = 2.0 * uniform() - 1.0;
    v = 2.0 * uniform() - 1.0;
    square = u * u + v * v;
  } while (square >= 1.0 || square == 0.0);
  const double factor = std::sqrt(-2.0 * portable_log(square) / square);
  spare_ = v * factor;
  has_spare_ = true;
  return u * factor;
}

double RandomStream::gamma(double shape) noexcept {
  if (shape < 1.0) {
    const double u = 1.0 - uniform();  // in (0, 1]
    return gamma(shape + 1.0) * std::exp(portable_log(u) / shape);
  }
  const double d = shape - 1.0 / 3.0;
  const double c = 1.0 / std::sqrt(9.0 * d);
  while (true) {
    const double x = normal();
    const double root = 1.0 + c * x;
    if (root <= 0.0) continue;
    const double v = root * root * root;
    const double u = 1.0 - uniform();
    if (portable_log(u) < 0.5 * x * x + d - d * v + d * portable_log(v)) return d * v;
  }
}

double RandomStream::student_t(double degrees_of_freedom) noexcept {
  const double numerator = normal();
  const double chi_square = 2.0 * gamma(0.5 * degrees_of_freedom);
  return numerator / std::sqrt(chi_square / degrees_of_freedom);
}

std::uint64_t stream_id(const char* purpose, std::uint64_t index) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a, 64 bits: offset basis, then prime
  for (const char* c = purpose; *c != '\0'; ++c) {
    hash = (hash ^ static_cast<unsigned char>(*c)) * 0x100000001b3ULL;
  }
  return mix(hash + kGolden * index);
}

std::vector<std::size_t> random_permutation(std::size_t n, RandomStream& random) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t left = n; left > 1; --left) std::swap(order[left - 1], order[random.index(left)]);
  return order;
}

}  // namespace proofmass
