// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// Columns of all samples, stored block by block of rows, that a pass over the samples keeps for later passes.
// Nothing is kept when the columns would be so large that reading them takes as long as computing them again.
// A thread passes its memory on to the next object, because training starts often and the system takes time
// to provide new pages.
class BlockColumns {
 public:
  // Rows of a block, and the distance between its columns. All columns stay in the second-level cache, those
  // being multiplied in the first. A stride of a power of two would put them all into the same few cache
  // sets.
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
  // Length of one block's columns, in values.
  [[nodiscard]] std::size_t block_size() const noexcept { return columns_ * kStride; }
  // The columns of the block whose first row is `first`; `scratch` when nothing is kept.
  [[nodiscard]] double* block(std::size_t first, double* scratch) noexcept {
    return keeps() ? storage_.data() + first / kRows * block_size() : scratch;
  }

 private:
  static constexpr std::size_t kMost = (std::size_t{3} << 20) / sizeof(double);

  std::size_t columns_ = 0;
  AlignedColumn storage_;  // of at least the size needed; contents undefined
};

}  // namespace proofmass
