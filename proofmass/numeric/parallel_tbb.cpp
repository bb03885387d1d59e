// SPDX-License-Identifier: Apache-2.0
// The only file that uses oneTBB. Debian's library is not built for the thread sanitizer, which therefore
// reports false races inside it. This file is built without that sanitizer, and parallel.cpp states the
// orderings that hold.
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/parallel_internal.hpp"

namespace proofmass {
namespace {

std::size_t thread_count(std::size_t threads) {
  return threads > 0 ? threads : static_cast<std::size_t>(tbb::info::default_concurrency());
}

}  // namespace

struct ThreadLimit::Control {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(std::size_t threads)
    : control_(new Control{
          tbb::global_control(tbb::global_control::max_allowed_parallelism, thread_count(threads))}) {}

ThreadLimit::~ThreadLimit() = default;

void run_tbb_tasks(std::size_t n, void (*body)(void*, std::size_t), void* context) {
  const auto run = [=](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) body(context, i);
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1), run, tbb::simple_partitioner());
}

}  // namespace proofmass
