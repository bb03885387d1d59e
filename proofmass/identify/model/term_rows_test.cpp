// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/term_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

void expect_design(const Dataset& record) {
  const TermList terms = parse_terms("full");
  const Matrix design = design_matrix(record, terms);
  const TermRows rows(record, terms, axis_ranges(record));
  RowBlock block(terms.size() + 1);
  for (std::size_t first = 0; first < record.rows(); first += RowBlock::kRows) {
    const std::size_t count = std::min(RowBlock::kRows, record.rows() - first);
    rows.fill(first, count, block);
    for (std::size_t c = 0; c < terms.size(); ++c) {
      for (std::size_t r = 0; r < count; ++r) {
        ASSERT_EQ(block.column(c)[r], design(first + r, c) * rows.scales()[c]) << name(terms[c]);
      }
    }
    for (std::size_t r = 0; r < count; ++r)
      ASSERT_EQ(block.column(terms.size())[r], record.output[first + r]);
  }
}

TEST(TermRows, AreTheDesignMatrixToTheLastBit) {
  Dataset record = test::make_twin({.rows = 300, .greatest = 70.0});
  expect_design(record);
  record.acceleration[1].clear();
  expect_design(record);
}

TEST(TermRows, ScalesKeepHugeAccelerationsInRange) {
  Dataset record = test::make_twin();
  for (auto& axis : record.acceleration) {
    for (double& value : axis) value *= 1e60;
  }
  const Identifiability found = analyse_identifiability(record, parse_terms("full"));
  EXPECT_EQ(found.identified, parse_terms("full"));
}

TEST(StaticOutputs, AreThoseOfTheModelToTheLastBit) {
  const Dataset record = test::make_twin({.rows = 10'000, .greatest = 70.0});
  const StaticModel model = test::paper_truth();
  const std::vector<double> outputs = static_outputs(model, record);
  ASSERT_EQ(outputs.size(), record.rows());
  for (std::size_t r = 0; r < outputs.size(); ++r) ASSERT_EQ(outputs[r], model.output(record.at(r)));
}

TEST(TermSums, ServeAnyOfTheirTerms) {
  const Dataset record = test::make_twin();
  const TermSums sums(record, parse_terms("full"));
  for (const char* preset : {"linear", "paper"}) {
    const TermList terms = parse_terms(preset);
    const Identifiability found = analyse_identifiability(sums, terms);
    EXPECT_EQ(found.identified, terms);
    EXPECT_DOUBLE_EQ(found.condition_scaled, analyse_identifiability(record, terms).condition_scaled);
  }
  EXPECT_THROW((void)TermSums(record, parse_terms("linear")).gram({Term::Kiop}), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
