// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/simd/block_columns.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace proofmass {
namespace {

// The number of columns that two training problems hold.
using Spare = std::array<AlignedColumn, 4>;

Spare& spare() {
  thread_local Spare storage;
  return storage;
}

bool shorter(const AlignedColumn& a, const AlignedColumn& b) { return a.size() < b.size(); }

}  // namespace

BlockColumns::BlockColumns(std::size_t columns, std::size_t padded_rows) : columns_(columns) {
  const std::size_t size = (padded_rows + kRows - 1) / kRows * columns * kStride;
  if (size == 0 || size > kMost) return;
  const auto longest = std::max_element(spare().begin(), spare().end(), shorter);
  if (longest->size() >= size) storage_ = std::exchange(*longest, {});
  if (storage_.size() < size) storage_.resize(size);
}

BlockColumns::~BlockColumns() {
  const auto shortest = std::min_element(spare().begin(), spare().end(), shorter);
  if (shortest->size() < storage_.size()) *shortest = std::move(storage_);
}

}  // namespace proofmass
