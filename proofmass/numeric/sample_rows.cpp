// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/sample_rows.hpp"

namespace proofmass {

SampleRows evenly_spaced(const Samples& samples, const ColumnBlock& fixed, std::size_t rows) {
  SampleRows some{Samples(samples.inputs(), rows), {}};
  some.fixed = ColumnBlock(fixed.columns(), some.samples.padded_rows());
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t from = row * samples.rows() / rows;
    for (std::size_t k = 0; k < samples.inputs(); ++k)
      some.samples.input(k)[row] = samples.input_data(k)[from];
    some.samples.target()[row] = samples.target()[from];
    for (std::size_t c = 0; c < fixed.columns(); ++c) some.fixed.column(c)[row] = fixed.column(c)[from];
  }
  return some;
}

}  // namespace proofmass
