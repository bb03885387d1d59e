// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace proofmass {

// While this object exists, parallel work uses at most `threads` threads, including the caller's; 0 means one
// per core. More threads than cores are allowed. When several limits exist at once, the lowest holds for the
// whole process.
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

// Calls body(0) … body(n - 1) once each, in any order and on any thread, and returns when all have ended. If
// a body writes only data of its own index, the results cannot depend on the number of threads. When bodies
// throw, the others still run, and then the exception of the lowest index is thrown. Calls may be nested.
void parallel_for(std::size_t n, const std::function<void(std::size_t)>& body);

}  // namespace proofmass
