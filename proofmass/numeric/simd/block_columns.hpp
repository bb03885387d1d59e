// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// Columns of all samples, a block of rows after the other, that a pass over the samples leaves for later
// ones. Keeps nothing where that would be so much that reading it takes as long as computing it again. Memory
// goes from one to the next of a thread, as training begins anew often and the system takes its time to hand
// out pages.
class BlockColumns {
 public:
  // Rows of a block, and how far apart its columns stand: all of them stay in the second level of cache,
  // those that are multiplied in the first, where a stride that is a power of two would send them all to a
  // few sets.
  static constexpr std::size_t kRows = 256;
  static constexpr std::size_t kStride = kRows + 8;

  BlockColumns() = default;
  BlockColumns(std::size_t columns, std::size_t padded_rows);
  BlockColumns(BlockColumns&&) noexcept = default;
  BlockColumns& operator=(BlockColumns&&) noexcept = default;
  BlockColumns(const BlockColumns&) = delete;
  BlockColumns& operator=(const BlockColumns&) = delete;
  ~BlockColumns();

  [[nodiscard]] bool keeps() const noexcept { return !storage_.empty(); }
  // One block's columns, in values.
  [[nodiscard]] std::size_t block_size() const noexcept { return columns_ * kStride; }
  // The columns of the block whose first row is `first`; those of `scratch` where nothing is kept.
  [[nodiscard]] double* block(std::size_t first, double* scratch) noexcept {
    return keeps() ? storage_.data() + first / kRows * block_size() : scratch;
  }

 private:
  static constexpr std::size_t kMost = (std::size_t{3} << 20) / sizeof(double);

  std::size_t columns_ = 0;
  AlignedColumn storage_;  // of at least the size needed, whatever it holds
};

}  // namespace proofmass
