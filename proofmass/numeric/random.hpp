// SPDX-License-Identifier: Apache-2.0
// Counter-based random numbers. A draw depends only on (seed, stream, index of the draw), so the number of
// threads cannot change a result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace proofmass {

// The Philox 4x64-10 block function: four words from a counter of four words and a key of two.
[[nodiscard]] std::array<std::uint64_t, 4> philox_block(const std::array<std::uint64_t, 4>& counter,
                                                        const std::array<std::uint64_t, 2>& key) noexcept;

// An independent stream of draws. Streams with different (seed, stream) pairs are statistically independent
// (Philox 4x64-10; Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC11). The key is (seed,
// stream), the counter the number of the block. Normal and Student draws use no library function whose last
// bit depends on the machine (log is computed here), so they are the same everywhere. The exception are
// Student draws with fewer than two degrees of freedom, which need exp.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed, std::uint64_t stream = 0) noexcept;

  std::uint64_t bits() noexcept;                     // 64 uniform bits
  double uniform() noexcept;                         // in [0, 1), 53 bits
  double uniform(double low, double high) noexcept;  // in [low, high)
  std::size_t index(std::size_t n) noexcept;         // in [0, n), unbiased (Lemire 2019); n >= 1
  double normal() noexcept;                          // mean 0, variance 1 (Marsaglia's polar method, 1964)
  double gamma(double shape) noexcept;               // shape > 0, scale 1 (Marsaglia & Tsang 2000)
  // Normal over the root of a chi-square per degree of freedom; degrees_of_freedom > 0; scale 1, not
  // variance 1.
  double student_t(double degrees_of_freedom) noexcept;

 private:
  void refill() noexcept;
  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t block_ = 0;  // blocks of four words drawn so far
  unsigned used_ = 4;        // words of the current block already used
  std::array<std::uint64_t, 4> words_{};
  double spare_ = 0.0;  // second value of the last normal pair
  bool has_spare_ = false;
};

// A stream number for a named purpose, so that different uses of one seed do not share draws:
// stream_id("split"), stream_id("swarm", particle). FNV-1a of the purpose, mixed with the index by
// splitmix64's finaliser, which is a bijection of the index: two indices of one purpose never collide.
[[nodiscard]] std::uint64_t stream_id(const char* purpose, std::uint64_t index = 0) noexcept;

// A uniformly random permutation of 0 … n-1 (Fisher-Yates).
[[nodiscard]] std::vector<std::size_t> random_permutation(std::size_t n, RandomStream& random);

}  // namespace proofmass
