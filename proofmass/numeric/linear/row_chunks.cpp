// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/row_chunks.hpp"

#include <algorithm>

#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/parallel.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kLeastRows = 32 * RowBlock::kRows;  // smaller portions are not worth another thread
constexpr std::size_t kMostShares = 64;

std::size_t chunk_rows(std::size_t rows) noexcept {
  const std::size_t even = (rows + kMostShares - 1) / kMostShares;
  const std::size_t blocks = (even + RowBlock::kRows - 1) / RowBlock::kRows;
  return std::max(kLeastRows, blocks * RowBlock::kRows);
}

}  // namespace

std::size_t row_chunks(std::size_t rows) noexcept { return (rows + chunk_rows(rows) - 1) / chunk_rows(rows); }

void for_each_row_chunk(std::size_t rows,
                        const std::function<void(std::size_t, std::size_t, std::size_t)>& body) {
  const std::size_t size = chunk_rows(rows);
  const auto run = [&](std::size_t chunk) { body(chunk, chunk * size, std::min(rows, (chunk + 1) * size)); };
  if (row_chunks(rows) == 1) {
    run(0);  // small problems start no threads
  } else {
    parallel_for(row_chunks(rows), run);
  }
}

}  // namespace proofmass
