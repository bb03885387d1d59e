// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/files/sha256.hpp"
#include "support/reference_data.hpp"
#include "support/temporary_folder.hpp"

namespace proofmass {
namespace {

using Column = std::vector<double>;

Dataset read_text(std::string_view text, const ReadOptions& options = {}) {
  const test::TemporaryFolder folder;
  return read_record(folder.write("run.csv", text), options);
}

TEST(ReadRecord, ReadsEveryColumnOfTheContract) {
  const std::string text =
      "# a test run\n"
      "t,T,mount,Ai,Ao,Ap,E,sigma_E,sigma_Ai,sigma_Ao,sigma_Ap\n"
      "0,21.5,IA up,1,2,3,4,0.1,0.01,0.02,0.03\n"
      "# between\n"
      "60,21.6,\"OA, \"\"up\"\"\",-1,-2,-3,-4e0,.2,1e-2,2e-2,3E-2\n"
      "\n";
  const Dataset record = read_text(text);
  EXPECT_EQ(record.rows(), 2U);
  EXPECT_EQ(record.acceleration, (std::array{Column{1, -1}, Column{2, -2}, Column{3, -3}}));
  EXPECT_EQ(record.output, (Column{4, -4}));
  EXPECT_EQ(record.output_sigma, (Column{0.1, 0.2}));
  EXPECT_EQ(record.acceleration_sigma,
            (std::array{Column{0.01, 0.01}, Column{0.02, 0.02}, Column{0.03, 0.03}}));
  EXPECT_EQ(record.mount, (std::vector<std::string>{"IA up", "OA, \"up\""}));
  EXPECT_EQ(record.temperature, (Column{21.5, 21.6}));
  EXPECT_EQ(record.time, (Column{0, 60}));
  EXPECT_EQ(record.line, (std::vector<std::size_t>{3, 5}));
  EXPECT_EQ(record.output_unit.symbol, "g");
  EXPECT_EQ(record.source_sha256, sha256_hex(text));
  EXPECT_TRUE(record.source.ends_with("run.csv"));
}

TEST(ReadRecord, ConvertsAccelerationsToGAndKeepsOtherUnits) {
  const Dataset record = read_text(
      "Ai[m/s\u00B2],Ao [m/s^2],E[mA],sigma_Ai[\u00B5g],sigma_Ao,sigma_E,T[K],t[ms]\n"
      "9.80665,19.6133,2.5,3,9.80665,0.5,300,7\n");
  EXPECT_DOUBLE_EQ(record.acceleration[0][0], 1.0);
  EXPECT_DOUBLE_EQ(record.acceleration[1][0], 2.0);
  EXPECT_FALSE(record.has(Axis::pendulous));
  EXPECT_EQ(record.output[0], 2.5);
  EXPECT_DOUBLE_EQ(record.acceleration_sigma[0][0], 3e-6);
  EXPECT_DOUBLE_EQ(record.acceleration_sigma[1][0], 1.0);  // no unit of its own: that of Ao
  EXPECT_EQ(record.output_sigma[0], 0.5);
  EXPECT_EQ(record.acceleration_unit.symbol, "m/s^2");
  EXPECT_EQ(record.output_unit.symbol, "mA");
  EXPECT_EQ(record.temperature_unit.symbol, "K");
  EXPECT_EQ(record.time_unit.symbol, "ms");
}

TEST(ReadRecord, AnOutputInAccelerationUnitsIsInG) {
  const Dataset record = read_text("Ai,E[mg],sigma_E[ug]\n1,1001,20\n");
  EXPECT_DOUBLE_EQ(record.output[0], 1.001);
  EXPECT_DOUBLE_EQ(record.output_sigma[0], 2e-5);
}

TEST(ReadRecord, SeparatorsLineEndsQuotesAndMarksDoNotMatter) {
  const std::vector<std::string> variants{
      "Ai,Ao,E\n1,2,3\n-4,5,6\n",
      "Ai;Ao;E\n1;2;3\n-4;5;6",
      "Ai\tAo\tE\n1\t2\t3\n-4\t5\t6\n",
      "Ai | Ao | E\n1 | 2 | 3\n-4 | 5 | 6\n",
      "Ai;Ao;E\n=\"1\";2;3\n-4;5;=\"6\"\n",
      "Ai,\tAo,\tE\n1,\t2,\t3\n-4,\t5,\t6\n",
      "\xEF\xBB\xBF\"Ai\",\"Ao [g]\",\"E\"\r\n\"1\",\" +2 \",3\r\n-4,5,6\r\n\r\n\r\n",
      "\n# first\n  # indented\nAi , Ao , E, note\n +1 , 2 ,3 ,\"a, b\"\n-4, 5, 6e0,x\n  \n",
      "E,remark \"a;b;c\",Ao,Ai\n3,,2,1\n6,,5,-4\n",
  };
  for (const std::string& text : variants) {
    const Dataset record = read_text(text);
    EXPECT_EQ(record.acceleration[0], (Column{1, -4})) << text;
    EXPECT_EQ(record.acceleration[1], (Column{2, 5})) << text;
    EXPECT_EQ(record.output, (Column{3, 6})) << text;
  }
}

TEST(ReadRecord, RenamesByNameByHeaderAndWithAUnit) {
  const char* text = "pos,ref [m/s^2],ref2,Ai,raw\na,9.80665,5,7,2040\n";
  const Dataset record =
      read_text(text, {.rename = {{"Ai", "ref [m/s^2]"}, {"E", "raw[counts]"}, {"mount", "pos"}}});
  EXPECT_DOUBLE_EQ(record.acceleration[0][0], 1.0);
  EXPECT_EQ(record.output[0], 2040.0);
  EXPECT_EQ(record.output_unit.symbol, "counts");
  EXPECT_EQ(record.mount[0], "a");
  EXPECT_DOUBLE_EQ(read_text(text, {.rename = {{"Ai", "ref"}, {"E", "raw"}}}).acceleration[0][0], 1.0);
}

TEST(ReadRecord, RenamingCanSwapColumns) {
  const Dataset record = read_text("Ai,Ao,E\n1,2,3\n", {.rename = {{"Ai", "Ao"}, {"Ao", "Ai"}}});
  EXPECT_EQ(record.acceleration[0][0], 2.0);
  EXPECT_EQ(record.acceleration[1][0], 1.0);
}

TEST(ReadRecord, InputsAloneAreEnoughWhenNoOutputIsRequired) {
  const Dataset record = read_text("Ai,sigma_E\n1,9\n2,9\n", {.rename = {}, .require_output = false});
  EXPECT_EQ(record.rows(), 2U);
  EXPECT_TRUE(record.output.empty());
  EXPECT_TRUE(record.output_sigma.empty());
}

TEST(ReadRecord, ReadsLinesThatSpanBlocks) {
  std::string text = "Ai,E\n";
  constexpr int kRows = 100000;
  for (int k = 0; k < kRows; ++k) text += std::to_string(k) + ".25," + std::to_string(-k) + "\n";
  const Dataset record = read_text(text);
  ASSERT_EQ(record.rows(), std::size_t{kRows});
  for (std::size_t k = 0; k < record.rows(); ++k) {
    ASSERT_EQ(record.acceleration[0][k], static_cast<double>(k) + 0.25);
    ASSERT_EQ(record.output[k], -static_cast<double>(k));
  }
  EXPECT_EQ(record.source_sha256, sha256_hex(text));
}

struct RecordingProgress final : Progress {
  void update(std::string_view, std::size_t done, std::size_t total) override {
    seen.emplace_back(done, total);
  }
  [[nodiscard]] bool cancelled() const noexcept override { return seen.size() >= patience; }
  std::size_t patience = 1000;
  std::vector<std::pair<std::size_t, std::size_t>> seen;
};

TEST(ReadRecord, ReportsMegabytesAndStopsWhenTold) {
  std::string text = "Ai,E\n";
  while (text.size() < 3'200'000) text += "1.5,2.5\n";
  const test::TemporaryFolder folder;
  const auto path = folder.write("run.csv", text);
  RecordingProgress progress;
  EXPECT_EQ(read_record(path, {}, progress).source_sha256, sha256_hex(text));
  ASSERT_GT(progress.seen.size(), 4U);
  EXPECT_TRUE(std::is_sorted(progress.seen.begin(), progress.seen.end()));
  EXPECT_EQ(progress.seen.back(), std::pair(std::size_t{4}, std::size_t{4}));

  RecordingProgress impatient;
  impatient.patience = 2;
  try {
    static_cast<void>(read_record(path, {}, impatient));
    ADD_FAILURE() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
}

// Control characters are searched for block by block. One in a later block is found, and only its line is
// refused.
TEST(ReadRecord, NamesTheLineOfAControlCharacterFarIntoAFile) {
  std::string text = "Ai,E\n";
  for (int k = 0; k < 200'000; ++k) text += k == 150'000 ? "1,2\x01\n" : "1,2\n";
  const test::TemporaryFolder folder;
  try {
    static_cast<void>(read_record(folder.write("run.csv", text)));
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(":150002: "), std::string::npos) << error.what();
  }
}

TEST(ReadRecord, UsageErrorsOfRenaming) {
  const auto refused = [](const ReadOptions& options, const std::string& culprit) {
    try {
      static_cast<void>(read_text("Ai,E,x\n1,2,3\n", options));
      ADD_FAILURE() << "accepted " << culprit;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_NE(std::string(error.what()).find(culprit), std::string::npos) << error.what();
    }
  };
  refused({.rename = {{"Az", "x"}}}, "'Az'");
  refused({.rename = {{"Ai", "x"}, {"E", "x"}}}, "'x' is renamed twice");
}

// The six labelled positions of a real triad: its reference accelerations and its raw x output.
TEST(ReadRecord, ReadsARealRecordThroughRenaming) {
  const auto path = test::reference_data("positions/imucal_ferraris_6pos.csv");
  if (!path) GTEST_SKIP() << test::kNoReferenceData;
  const Dataset record = read_record(
      *path,
      {.rename = {
           {"Ai", "ref_gx"}, {"Ao", "ref_gy"}, {"Ap", "ref_gz"}, {"E", "ax_raw[counts]"}, {"mount", "pos"}}});
  EXPECT_EQ(record.acceleration[0], (Column{1, -1, 0, 0, 0, 0}));
  EXPECT_EQ(record.acceleration[1], (Column{0, 0, 1, -1, 0, 0}));
  // The same field read independently: the sixth field of the first row.
  std::istringstream rows(test::read_file(*path));
  std::string field;
  std::getline(rows, field);
  for (int k = 0; k < 6; ++k) std::getline(rows, field, ',');
  EXPECT_EQ(record.output[0], std::stod(field));
  EXPECT_EQ(record.mount[3], "y_a");
}

// --- The forms of benches ----------------------------------------------------------------------------------

TEST(ReadRecord, FindsTheDataHoweverLongThePreambleIs) {
  for (const std::size_t lines : {0U, 1U, 998U, 999U, 1000U, 3000U}) {
    std::string text;
    for (std::size_t k = 0; k < lines; ++k) text += k % 2 == 0 ? "# note\n" : "Instrument: X\n";
    text += "Ai,E\n1,2\n3,4\n";
    const Dataset record = read_text(text);
    EXPECT_EQ(record.output, (Column{2, 4})) << lines;
    EXPECT_EQ(record.line.front(), lines + 2);
  }
}

TEST(ReadRecord, TakesColumnsByPosition) {
  const ReadOptions positions{.rename = {{"Ai", "#2[g]"}, {"E", "#3[V]"}}};
  EXPECT_EQ(read_text("d1,0.5,1.2\nd2,0.6,1.3\n", positions).output, (Column{1.2, 1.3}));
  const Dataset named = read_text("name,x,y\nd1,0.5,1.2\n", positions);
  EXPECT_EQ(named.output, (Column{1.2}));
  EXPECT_EQ(named.output_unit.symbol, "V");
  const ReadOptions inputs{.rename = {{"Ai", "#1"}}, .require_output = false};
  EXPECT_EQ(read_text("0.1\n0.2\n0.3\n", inputs).acceleration[0], (Column{0.1, 0.2, 0.3}));
}

TEST(ReadRecord, TellsCommentsFromRowsWithLabels) {
  const Dataset record = read_text("mount,Ai,E\n#0,1,2\n# mean,1,2\n#note,a,b\nP1,3,4\n");
  EXPECT_EQ(record.mount, (std::vector<std::string>{"#0", "P1"}));
  ASSERT_EQ(record.findings.size(), 3U);
  EXPECT_EQ(record.findings[0].code, Code::record_labels_with_mark);
  EXPECT_EQ(record.findings[1].code, Code::record_comments_skipped);
  EXPECT_EQ(record.findings[1].lines, (std::vector<std::size_t>{3, 4}));
}

TEST(ReadRecord, UnderstandsUnitsAtTheEndOfANameWhenNothingElseIsMeant) {
  const Dataset record = read_text("T,T_C,Ai_g,E,E_A\n20,21,1,2,3\n");
  EXPECT_EQ(record.output, (Column{2}));
  EXPECT_EQ(record.temperature, (Column{20}));
  EXPECT_EQ(read_text("Ai_ms2,E_mV\n9.80665,2\n").output_unit.symbol, "mV");
}

TEST(ReadRecord, NeverMindsWhatNobodyUses) {
  const ReadOptions inputs{.rename = {}, .require_output = false};
  EXPECT_EQ(read_text("Ai,E\n1,n/a\n2,\n", inputs).acceleration[0], (Column{1, 2}));
  const Dataset record = read_text("Ai,E,T,note\n1,2,20,x\n3,4,,\n");
  EXPECT_TRUE(record.temperature.empty());
  EXPECT_EQ(record.ignored.size(), 1U);
}

TEST(ReadRecord, ReadsClocksOverMidnight) {
  const Dataset record = read_text("t,Ai,E\n23:59:58,1,2\n23:59:59.5,1,2\n00:00:01,1,2\n");
  EXPECT_EQ(record.time, (Column{0, 1.5, 3}));
}

TEST(ReadRecord, KnowsTheStepInWhichInputsAreWritten) {
  const Dataset record = read_text("Ai[m/s^2],Ao[m/s^2],E\n9.8,1e-4,2\n-9.81,0,3\n");
  EXPECT_DOUBLE_EQ(record.acceleration_resolution[0], 0.01 / kStandardGravity);
  EXPECT_DOUBLE_EQ(record.acceleration_resolution[1], 1e-4 / kStandardGravity);
  EXPECT_EQ(record.acceleration_resolution[2], 0.0);
  // A value that is zero but for rounding is not written finer than the others.
  EXPECT_DOUBLE_EQ(read_text("Ai,E\n0.978148,2\n6.12323e-17,3\n-0.5,1\n").acceleration_resolution[0], 1e-6);
  EXPECT_DOUBLE_EQ(read_text("Ai,E\n9.78148e-01,2\n6.12323e-17,3\n").acceleration_resolution[0], 1e-6);
  // Whole numbers are positions by name.
  EXPECT_EQ(read_text("Ai,E\n1,2\n-1,3\n0,1\n").acceleration_resolution[0], 0.0);
}

// Rows of every kind in each of several chunks: threads must change nothing.
TEST(ReadRecord, IsTheSameForAnyNumberOfThreads) {
  std::string text = "mount,Ai,E\n";
  for (int k = 0; k < 120'000; ++k) {
    const std::string number = std::to_string(k);
    text += "P" + number + "," + number + ".25," + number + "\n";
    if (k % 10'000 == 0) text += "# note\nP,1,OVLD\nmount,Ai,E\n,,\n#0,\u22121.5,2\n";
  }
  const auto read = [&text](std::size_t threads) {
    return read_text(text, {.overload = OverloadPolicy::leave_out, .threads = threads});
  };
  const Dataset one = read(1);
  EXPECT_EQ(one.rows(), 120'012U);
  for (const std::size_t threads : {2U, 8U}) {
    const Dataset more = read(threads);
    EXPECT_EQ(more.acceleration, one.acceleration);
    EXPECT_EQ(more.output, one.output);
    EXPECT_EQ(more.mount, one.mount);
    EXPECT_EQ(more.line, one.line);
    EXPECT_EQ(more.findings, one.findings);
    EXPECT_EQ(more.acceleration_resolution, one.acceleration_resolution);
    EXPECT_EQ(more.source_sha256, one.source_sha256);
  }
}

// The first error of the file, whichever thread meets one first.
TEST(ReadRecord, NamesTheFirstErrorForAnyNumberOfThreads) {
  std::string text = "Ai,E\n";
  for (int k = 2; k <= 400'000; ++k) text += k == 150'000 || k == 300'000 ? "1,x\n" : "1.5,2.5\n";
  for (const std::size_t threads : {1U, 2U, 8U}) {
    try {
      (void)read_text(text, {.threads = threads});
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(":150000:"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace proofmass
