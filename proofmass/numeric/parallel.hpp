// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace proofmass {

// While it lives, parallel work uses at most `threads` threads, the caller's among them; 0 means one for
// every core. More threads than cores are allowed. Of several limits alive at once the lowest holds, across
// the whole process.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
  ThreadLimit(ThreadLimit&&) = delete;
  ThreadLimit& operator=(ThreadLimit&&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

// Calls body(0) … body(n - 1) once each, in any order and on any thread, and returns when all have ended.
// What a body writes must be its own index's alone; then results cannot depend on the number of threads. When
// bodies throw, the others still run, and the exception of the lowest index is thrown. May be nested.
void parallel_for(std::size_t n, const std::function<void(std::size_t)>& body);

}  // namespace proofmass
