// SPDX-License-Identifier: Apache-2.0
// Signals at every stage: while a verb reads, while it waits for its reader, while it writes.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <thread>

#include "support/command_line.hpp"

namespace proofmass::test {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

void pause_briefly() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }

class Interrupts : public CommandLine {
 protected:
  [[nodiscard]] std::string make_pipe(const std::string& name) const {
    EXPECT_EQ(mkfifo(at(name).c_str(), 0600), 0);
    return at(name);
  }
  [[nodiscard]] bool has_temporary() const {
    const auto list = names();
    return std::any_of(list.begin(), list.end(),
                       [](const std::string& name) { return name.ends_with(".tmp"); });
  }
};

void expect_interrupted(const Outcome& outcome) {
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("proofmass: error: interrupted"), std::string::npos) << outcome.err;
}

// A pipe that a writer holds open without a word is a record that never comes.
TEST_F(Interrupts, EndAVerbThatReads) {
  make_record();
  ASSERT_EQ(proofmass({"identify", at("run.csv"), "--json", at("r.json")}).exit_code, 0);
  const std::string pipe = make_pipe("pipe");
  const std::vector<std::vector<std::string>> commands{
      {"identify", pipe, "--out", at("results")}, {"inspect", pipe},
      {"compare", pipe, "--methods", "ols,wls"},  {"predict", at("r.json"), pipe, "--out", at("p.csv")},
      {"predict", pipe, at("run.csv")},           {"simulate", pipe}};
  for (const auto& command : commands) {
    for (const int signal_number : kSignals) {
      SCOPED_TRACE(command[0] + ", signal " + std::to_string(signal_number));
      Process process(launch(command));
      const int writer = open(pipe.c_str(), O_WRONLY);  // waits for the program to open it
      process.send(signal_number);
      const Outcome outcome = process.wait();
      close(writer);
      expect_interrupted(outcome);
      EXPECT_EQ(outcome.out, "");
    }
  }
  EXPECT_EQ(names().size(), 3U);  // record, result, pipe
}

// Standard output is full and nobody reads it: what else there is to write is ready by then.
TEST_F(Interrupts, LeaveNothingOfAVerbThatWaitsForItsReader) {
  const std::string record = make_record();
  const std::string pipe = make_pipe("pipe");
  const int both_ends = open(pipe.c_str(), O_RDWR | O_NONBLOCK);
  ASSERT_GE(both_ends, 0);
  const std::string filling(4096, '.');
  while (::write(both_ends, filling.data(), filling.size()) > 0) continue;
  for (const int signal_number : kSignals) {
    Launch program = launch({"identify", record, "--json", at("r.json"), "--out", at("new/results")});
    program.standard_output = pipe;
    Process process(program);
    while (process.is_running() && !exists("new/results/history.csv.1.tmp")) pause_briefly();
    process.send(signal_number);
    expect_interrupted(process.wait());
    EXPECT_EQ(names().size(), 2U);  // record, pipe
  }
  close(both_ends);
}

TEST_F(Interrupts, LeaveNoHalfOfALongFile) {
  ASSERT_EQ(proofmass({"identify", make_record(), "--json", at("r.json")}).exit_code, 0);
  std::string inputs = "Ai,Ao,Ap\n";
  for (int k = 0; k < 200'000; ++k) inputs += "1.25,2.5,-3.75\n";
  const std::string path = write("inputs.csv", inputs);
  for (const int signal_number : kSignals) {
    Process process(launch({"predict", at("r.json"), path, "--out", at("p.csv")}));
    while (process.is_running() && !has_temporary()) pause_briefly();
    process.send(signal_number);
    const Outcome outcome = process.wait();
    // It may have been done before it heard of it.
    if (outcome.exit_code != 0) expect_interrupted(outcome);
    EXPECT_EQ(exists("p.csv"), outcome.exit_code == 0);
    EXPECT_FALSE(has_temporary());
    std::filesystem::remove(at("p.csv"));
  }
}

TEST_F(Interrupts, SpareWhatNohupStarted) {
  make_record();
  const std::string pipe = make_pipe("pipe");
  Launch program{
      .command = {"/bin/sh", "-c", "trap '' HUP; exec \"$0\" \"$@\"", PROOFMASS_CLI, "identify", pipe}};
  Process process(program);
  const int writer = open(pipe.c_str(), O_WRONLY);
  process.send(SIGHUP);
  const std::string content = read("run.csv");
  EXPECT_EQ(::write(writer, content.data(), content.size()), static_cast<ssize_t>(content.size()));
  close(writer);
  EXPECT_EQ(process.wait().exit_code, 0);
}

}  // namespace
}  // namespace proofmass::test
