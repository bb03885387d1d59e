// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// A selection of the samples, with the same rows of further columns.
struct SampleRows {
  Samples samples;
  ColumnBlock fixed;
};

// Selects one row from each of `rows` equal stretches; at most as many rows as there are samples.
[[nodiscard]] SampleRows one_of_each_stretch(const Samples& samples, const ColumnBlock& fixed,
                                             std::size_t rows);

}  // namespace proofmass
