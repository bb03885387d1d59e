// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/static_model.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/numeric/linear/regression_rows.hpp"

namespace proofmass {

// The largest |Ai|, |Ao|, |Ap| of a record; zero for an axis that it lacks.
using AxisRanges = std::array<double, 3>;
[[nodiscard]] AxisRanges axis_ranges(const Dataset& data);

// The regression of a record's output on terms of the static model: design_matrix, to the last bit, block by
// block and scaled by powers of two. An output that the record lacks counts as zero. The record must outlive
// this.
class TermRows final : public RegressionRows {
 public:
  // `ranges`: those of the record, or zeros to leave the regressors as they are.
  TermRows(const Dataset& data, TermList terms, const AxisRanges& ranges);

  [[nodiscard]] std::size_t rows() const noexcept override { return data_.rows(); }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return scales_; }
  void fill(std::size_t first, std::size_t count, RowBlock& block) const override;

 private:
  const Dataset& data_;
  TermList terms_;
  std::array<double, 3> axis_scales_{};
  std::vector<double> scales_;
};

// model.output of each row, to the last bit, block by block and in parallel.
[[nodiscard]] std::vector<double> static_outputs(const StaticModel& model, const Dataset& inputs);

// The measured output of each row less that.
[[nodiscard]] std::vector<double> static_residuals(const StaticModel& model, const Dataset& record);

}  // namespace proofmass
