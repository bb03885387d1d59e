// SPDX-License-Identifier: Apache-2.0
#include "progress_text.hpp"

#include <gtest/gtest.h>

namespace proofmass::test {
namespace {

using cli::progress_text;
using cli::StageProgress;

// 12 of 60 in 13 s; each test says what differs.
StageProgress swarm() { return {.stage = "swarm", .done = 12, .total = 60, .seconds = 13.0}; }

TEST(ProgressText, TellsTheTimeSoFarBeforeATenthIsDone) {
  StageProgress progress = swarm();
  progress.done = 5;
  EXPECT_EQ(progress_text(progress), "swarm: 5 of 60 (8 %), 0:13 so far");
  progress.done = 0;
  EXPECT_EQ(progress_text(progress), "swarm: 0 of 60 (0 %), 0:13 so far");
  EXPECT_EQ(progress_text({.stage = "tls", .total = 1, .seconds = 33.2}), "tls: 0:34 so far");
}

TEST(ProgressText, TellsWhatIsLeftFromATenthOn) {
  StageProgress progress = swarm();
  EXPECT_EQ(progress_text(progress), "swarm: 12 of 60 (20 %), 0:52 left");
  progress.done = 6;
  EXPECT_EQ(progress_text(progress), "swarm: 6 of 60 (10 %), 1:57 left");
  progress.seconds = 1000.0;
  EXPECT_EQ(progress_text(progress), "swarm: 6 of 60 (10 %), 2:30:00 left");
  progress.done = 60;
  EXPECT_EQ(progress_text(progress), "swarm: 60 of 60 (100 %), 0:00 left");
}

// What was done before the stage was first heard of took none of its time.
TEST(ProgressText, CountsFromWhereTheStageWasFirstHeardOf) {
  StageProgress progress = swarm();
  progress.first = 10;
  EXPECT_EQ(progress_text(progress), "swarm: 12 of 60 (20 %), 0:13 so far");
  progress.done = 20;
  EXPECT_EQ(progress_text(progress), "swarm: 20 of 60 (33 %), 0:52 left");
  progress.first = 60;
  progress.done = 60;
  EXPECT_EQ(progress_text(progress), "swarm: 60 of 60 (100 %), 0:13 so far");
}

TEST(ProgressText, KeepsToTheWidth) {
  const std::string whole = progress_text(swarm());
  EXPECT_EQ(progress_text(swarm(), whole.size()), whole);
  EXPECT_EQ(progress_text(swarm(), whole.size() - 1), "swarm: 20 %, 0:52 left");
  EXPECT_EQ(progress_text(swarm(), 10), "swarm: 20 ");
  EXPECT_EQ(progress_text({.stage = "tls", .total = 1, .seconds = 33.2}, 5), "tls: ");
}

}  // namespace
}  // namespace proofmass::test
