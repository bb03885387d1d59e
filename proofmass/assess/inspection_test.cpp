// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/inspection.hpp"

#include <gtest/gtest.h>

#include "proofmass/core/error.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

TEST(Inspection, SummarisesARecordInItsOwnUnits) {
  Dataset record = test::make_twin({.rows = 40});
  record.acceleration[2].clear();
  record.acceleration[0][5] = -30.0;
  record.acceleration_unit = {
      .quantity = Quantity::acceleration, .symbol = "m/s^2", .to_canonical = 1.0 / kStandardGravity};
  record.output_sigma.assign(40, 1e-3);
  record.mount.assign(40, "up");
  record.mount[7] = "down";
  record.acceleration[0][9] = record.acceleration[0][8];
  record.acceleration[1][9] = record.acceleration[1][8];

  const Inspection inspection = inspect(record);
  EXPECT_EQ(inspection.rows, 40U);
  ASSERT_EQ(inspection.columns.size(), 4U);
  EXPECT_EQ(inspection.columns[0].name, "Ai");
  EXPECT_EQ(inspection.columns[0].unit, "m/s^2");
  EXPECT_DOUBLE_EQ(inspection.columns[0].minimum, -30.0 * kStandardGravity);
  EXPECT_EQ(inspection.columns[3].name, "sigma_E");
  EXPECT_DOUBLE_EQ(inspection.columns[3].mean, 1e-3);
  EXPECT_TRUE(inspection.has_output_sigma);
  ASSERT_EQ(inspection.mounts.size(), 2U);
  EXPECT_EQ(inspection.mounts[1].name, "down");
  EXPECT_EQ(inspection.mounts[0].rows, 39U);
  EXPECT_EQ(inspection.repeated_inputs, 1U);
  EXPECT_EQ(inspection.repeated_rows, 0U);
}

TEST(Inspection, JudgesEveryPreset) {
  Dataset record = test::make_twin({.rows = 40});
  record.acceleration[2].clear();
  const Inspection inspection = inspect(record);
  ASSERT_EQ(inspection.presets.size(), 4U);
  EXPECT_EQ(inspection.presets[0].name, "linear");
  EXPECT_EQ(join_names(inspection.presets[0].found.identified), "K0, Ki, Ko");
  const PresetVerdict& full = inspection.presets[3];
  EXPECT_EQ(full.rows_needed, 22U);
  EXPECT_EQ(full.found.identified.size() + full.found.unidentified.size(), 21U);
  EXPECT_EQ(full.found.unidentified.size(), 10U);  // every product with Ap
  for (const Finding& finding : full.found.unidentified) EXPECT_EQ(finding.code, Code::term_without_column);
}

TEST(Inspection, RefusesValuesBeyondArithmetic) {
  for (const double value : {1e41, 1e200}) {
    Dataset record = test::make_twin({.rows = 40});
    record.acceleration[0][3] = value;
    try {
      (void)inspect(record);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    }
  }
}

TEST(Inspection, NeedsRows) { EXPECT_THROW((void)inspect(Dataset{}), Error); }

}  // namespace
}  // namespace proofmass
