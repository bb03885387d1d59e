// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "proofmass/numeric/perceptron_kernels.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// Some of the samples, with their part of further columns.
struct SampleRows {
  Samples samples;
  ColumnBlock fixed;
};

// `rows` of them, at most all, evenly spaced.
[[nodiscard]] SampleRows evenly_spaced(const Samples& samples, const ColumnBlock& fixed, std::size_t rows);

}  // namespace proofmass
