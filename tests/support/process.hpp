// SPDX-License-Identifier: Apache-2.0
// Runs a program as a shell does, for end-to-end tests.
#pragma once

#include <fcntl.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/temporary_folder.hpp"

namespace proofmass::test {

struct Outcome {
  int exit_code = -1;  // 128 + the signal that ended the process, as in shells
  std::string out;
  std::string err;
};

struct Launch {
  std::vector<std::string> command;
  std::string standard_input = {};
  std::vector<std::pair<std::string, std::string>> environment = {};  // added to the caller's
  std::string standard_output = {};  // a file such as /dev/full; captured when empty
};

inline int exit_code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// In the child process: runs the program.
[[noreturn]] inline void become(const Launch& launch) {
  for (const auto& [name, value] : launch.environment) setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> arguments;
  for (const std::string& word : launch.command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

// A running program. Its streams are files, so that nothing can block.
class Process {
 public:
  explicit Process(Launch launch) {
    const std::string input = folder_.write("in", launch.standard_input).string();
    const std::string output =
        launch.standard_output.empty() ? (folder_.path() / "out").string() : launch.standard_output;
    const std::string errors = (folder_.path() / "err").string();
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("cannot fork");
    if (pid_ == 0) {
      dup2(open(input.c_str(), O_RDONLY), STDIN_FILENO);
      dup2(open(output.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
      dup2(open(errors.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
      become(launch);
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }

  void send(int signal_number) const { kill(pid_, signal_number); }
  [[nodiscard]] std::string errors_so_far() const { return read_file(folder_.path() / "err"); }
  // True while the program runs.
  [[nodiscard]] bool is_running() {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == 0;
  }
  Outcome wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = 0;
    return {exit_code_of(status), read_file(folder_.path() / "out"), errors_so_far()};
  }

 private:
  TemporaryFolder folder_;
  pid_t pid_ = 0;
};

inline Outcome run_process(Launch launch) { return Process(std::move(launch)).wait(); }

// The output of the program when its streams are a terminal; both streams are mixed.
inline std::string run_on_terminal(const Launch& launch) {
  int terminal = -1;
  const pid_t pid = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (pid < 0) throw std::runtime_error("cannot open a terminal");
  if (pid == 0) become(launch);
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; (n = read(terminal, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  waitpid(pid, nullptr, 0);
  close(terminal);
  return text;
}

}  // namespace proofmass::test
