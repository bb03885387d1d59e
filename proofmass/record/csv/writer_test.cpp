// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/writer.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>

#include "proofmass/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace proofmass {
namespace {

Dataset small_record() {
  Dataset record;
  record.acceleration = {std::vector{1.0, -0.1}, {}, std::vector{0.0, 1e-7}};
  record.acceleration_sigma[2] = {0.5, 0.25};
  record.output = {2.0, 4.0};
  record.output_sigma = {0.001, 1e22};
  record.mount = {"IA up", "a, \"b\""};
  record.temperature = {21.0, 22.0};
  record.output_unit = *find_unit("mA");
  record.acceleration_unit = *find_unit("mg");
  return record;
}

std::string text_of(const Dataset& record, const WriteOptions& options = {}) {
  std::ostringstream out;
  write_record(out, record, options);
  return out.str();
}

TEST(WriteRecord, WritesCanonicalUnitsInContractOrder) {
  EXPECT_EQ(text_of(small_record(), {.comments = {"seed 7"}}),
            "# seed 7\n"
            "Ai[g],Ap[g],E[mA],sigma_E[mA],sigma_Ap[g],mount,T[degC]\n"
            "1,0,2,0.001,0.5,IA up,21\n"
            "-0.1,1e-07,4,1e+22,0.25,\"a, \"\"b\"\"\",22\n");
}

TEST(WriteRecord, WritesDeclaredUnits) {
  Dataset record = small_record();
  record.acceleration[2][1] = 0.25;
  EXPECT_EQ(text_of(record, {.units = RecordUnits::declared}),
            "Ai[mg],Ap[mg],E[mA],sigma_E[mA],sigma_Ap[mg],mount,T[degC]\n"
            "1000,0,2,0.001,500,IA up,21\n"
            "-100,250,4,1e+22,250,\"a, \"\"b\"\"\",22\n");
}

TEST(WriteRecord, RefusesWhatCouldNotBeReadBackAndLeavesNoFile) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const Dataset& record, const WriteOptions& options) {
    EXPECT_THROW(write_record(folder.path() / "run.csv", record, options), Error);
    EXPECT_TRUE(folder.names().empty());
  };
  refused(small_record(), {.comments = {"two\nlines"}});
  Dataset record = small_record();
  record.mount[0] = "two\nlines";
  refused(record, {});
  record = small_record();
  record.output[1] = std::numeric_limits<double>::quiet_NaN();
  refused(record, {});
  record = small_record();
  record.acceleration[0].clear();
  refused(record, {});
}

}  // namespace
}  // namespace proofmass
