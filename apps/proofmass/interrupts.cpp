// SPDX-License-Identifier: Apache-2.0
#include "interrupts.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <string>

#include "proofmass/core/error.hpp"

namespace proofmass::cli {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
constexpr int kInterrupted = 130;  // exit_code(ErrorKind::interrupted)

// As a handler finds it: written before there is one, and never destroyed.
std::array<char, 256> farewell{};
std::size_t farewell_length = 0;
std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "or a signal handler must not touch it");

// Both do only what POSIX allows in a handler.
extern "C" void leave(int) {
  const auto unheard = write(STDERR_FILENO, farewell.data(), farewell_length);
  static_cast<void>(unheard);
  _exit(kInterrupted);
}

extern "C" void ask_to_stop(int) {
  if (asked.exchange(true)) _exit(kInterrupted);
}

// Interrupted system calls are not restarted: whoever waits in one shall hear of it.
struct sigaction action_of(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  return action;
}

// One who started the program by nohup wants it to outlive the terminal.
bool is_ignored_hangup(int signal_number, const struct sigaction& before) {
  return signal_number == SIGHUP && before.sa_handler == SIG_IGN;
}

void handle(int signal_number, void (*handler)(int), struct sigaction& before) {
  const struct sigaction action = action_of(handler);
  sigaction(signal_number, nullptr, &before);
  if (!is_ignored_hangup(signal_number, before)) sigaction(signal_number, &action, nullptr);
}

}  // namespace

void leave_when_interrupted(const std::string& word) {
  farewell_length = std::min(word.size(), farewell.size());
  std::copy_n(word.begin(), farewell_length, farewell.begin());
  struct sigaction before {};
  for (const int signal_number : kSignals) handle(signal_number, leave, before);
}

InterruptGuard::InterruptGuard() {
  for (std::size_t k = 0; k < kSignals.size(); ++k) handle(kSignals[k], ask_to_stop, previous_[k]);
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t k = 0; k < kSignals.size(); ++k) sigaction(kSignals[k], &previous_[k], nullptr);
}

bool interrupted() noexcept { return asked.load(); }

Error interruption() { return Error(ErrorKind::interrupted, "interrupted; nothing was written"); }

void stop_if_interrupted() {
  if (interrupted()) throw interruption();
}

}  // namespace proofmass::cli
