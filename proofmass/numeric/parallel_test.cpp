// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace proofmass {
namespace {

TEST(Parallel, CallsEveryIndexOnce) {
  for (const std::size_t threads : {0U, 1U, 2U, 4U}) {
    const ThreadLimit limit(threads);
    std::vector<std::atomic<int>> calls(1000);
    parallel_for(calls.size(), [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) ASSERT_EQ(count, 1) << threads << " threads";
  }
  parallel_for(0, [](std::size_t) { FAIL(); });
}

TEST(Parallel, OneThreadStaysOnTheCaller) {
  const ThreadLimit limit(1);
  std::set<std::thread::id> seen;
  parallel_for(100, [&](std::size_t) { seen.insert(std::this_thread::get_id()); });
  EXPECT_EQ(seen, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(Parallel, LimitHoldsAndEnds) {
  const auto widest = [] {
    std::atomic<int> running = 0;
    std::atomic<int> most = 0;
    parallel_for(64, [&](std::size_t) {
      const int now = ++running;
      int seen = most;
      while (seen < now && !most.compare_exchange_weak(seen, now)) {
      }
      std::this_thread::yield();
      --running;
    });
    return most.load();
  };
  {
    const ThreadLimit outer(2);
    const ThreadLimit inner(1);
    EXPECT_EQ(widest(), 1);
  }
  const ThreadLimit again(2);
  EXPECT_LE(widest(), 2);
}

TEST(Parallel, ThrowsTheLowestIndexAfterTheOthersRan) {
  const ThreadLimit limit(2);
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::atomic<int> ran = 0;
    try {
      parallel_for(100, [&](std::size_t i) {
        ++ran;
        if (i % 30 == 17) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "17");
    }
    EXPECT_EQ(ran, 100);
  }
}

TEST(Parallel, Nests) {
  std::vector<std::vector<int>> cells(8, std::vector<int>(8, 0));
  parallel_for(8, [&](std::size_t i) { parallel_for(8, [&](std::size_t j) { cells[i][j] = 1; }); });
  for (const auto& row : cells) EXPECT_EQ(row, std::vector<int>(8, 1));
}

}  // namespace
}  // namespace proofmass
