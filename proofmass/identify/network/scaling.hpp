// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// The min-max scaling of a network, learned from the training rows: inputs and output each to [-1, 1]. The
// network's weights are left empty. An input that does not vary maps to 0.
[[nodiscard]] TrainedNetwork learn_scaling(const Dataset& training);

// Canonical units a scaled output of 1 stands for.
[[nodiscard]] double output_half_range(const TrainedNetwork& network) noexcept;

// The rows of a record as scaled samples, in the record's order; the target is left zero when the record has
// no output. Throws bad data when the record lacks an input of the network.
[[nodiscard]] Samples scale_rows(const TrainedNetwork& network, const Dataset& data);

// The rows of a record in an order that depends on their values alone, so that training, whose rounding
// depends on the order of summation, cannot depend on the order of the file.
[[nodiscard]] Dataset in_canonical_order(const Dataset& data);

// The network's output for every row, in the output's canonical unit.
[[nodiscard]] std::vector<double> network_outputs(const TrainedNetwork& network, const Dataset& data);

}  // namespace proofmass
