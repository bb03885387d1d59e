// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/sample_rows.hpp"

#include <cstdint>

namespace proofmass {
namespace {

// A number below `size` that differs from row to row without a period (Knuth's multiplicative hashing). The
// rows chosen are thus not in phase with a test plan that repeats its set-ups.
std::size_t scattered(std::uint64_t row, std::uint64_t size) {
  constexpr std::uint64_t kLow = 0xffffffff;
  return static_cast<std::size_t>(((row * 2654435769U & kLow) * size) >> 32U);
}

}  // namespace

SampleRows one_of_each_stretch(const Samples& samples, const ColumnBlock& fixed, std::size_t rows) {
  SampleRows some{Samples(samples.inputs(), rows), {}};
  some.fixed = ColumnBlock(fixed.columns(), some.samples.padded_rows());
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t first = row * samples.rows() / rows;
    const std::size_t beyond = (row + 1) * samples.rows() / rows;
    const std::size_t from = first + scattered(row, beyond - first);
    for (std::size_t k = 0; k < samples.inputs(); ++k)
      some.samples.input(k)[row] = samples.input_data(k)[from];
    some.samples.target()[row] = samples.target()[from];
    for (std::size_t c = 0; c < fixed.columns(); ++c) some.fixed.column(c)[row] = fixed.column(c)[from];
  }
  return some;
}

}  // namespace proofmass
