// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/parallel.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <utility>

#include "proofmass/numeric/parallel_internal.hpp"

namespace proofmass {
namespace {

// The exception of the lowest index among those thrown.
class FirstFailure {
 public:
  void record(std::size_t index, std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (error_ && index_ < index) return;
    index_ = index;
    error_ = std::move(error);
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::size_t index_ = 0;
  std::exception_ptr error_;
};

// One call of parallel_for. Writes of the caller must be visible to the bodies, and writes of the bodies to
// the caller. oneTBB guarantees this. The counter repeats the guarantee for sanitizers that cannot see into
// the library.
struct Loop {
  const std::function<void(std::size_t)>& body;
  FirstFailure failure{};
  std::atomic<std::size_t> ended{0};

  void step(std::size_t index) {
    static_cast<void>(ended.load(std::memory_order_acquire));
    try {
      body(index);
    } catch (...) {
      failure.record(index, std::current_exception());
    }
    ended.fetch_add(1, std::memory_order_release);
  }
};

}  // namespace

void parallel_for(std::size_t n, const std::function<void(std::size_t)>& body) {
  Loop loop{.body = body};
  loop.ended.store(0, std::memory_order_release);
  run_tbb_tasks(
      n, [](void* context, std::size_t index) { static_cast<Loop*>(context)->step(index); }, &loop);
  static_cast<void>(loop.ended.load(std::memory_order_acquire));
  loop.failure.rethrow();
}

}  // namespace proofmass
