// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bench {

struct Answer {
  double ns = 0.0;       // processor time per unit of work: particle x sample, epoch x sample, row, byte
  double seconds = 0.0;  // of one repetition
  std::size_t repetitions = 0;
  std::vector<double> values;                // results: RMSE of each network, coefficients, …
  std::vector<double> counts;                // training: epochs of each start
  std::vector<std::vector<double>> weights;  // training: final weights of each start
  std::map<std::string, std::string> about;  // library versions, instruction set, kernels in use
};

inline std::string json_list(const std::vector<double>& numbers) {
  std::string text = "[";
  char buffer[32];
  for (const double number : numbers) {
    std::snprintf(buffer, sizeof buffer, "%s%.17g", text.size() > 1 ? "," : "", number);
    text += buffer;
  }
  return text + "]";
}

// Peak resident memory. getrusage() would include the process before it became this program.
inline long peak_memory_kib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stol(line.substr(6));
  }
  return 0;
}

inline void print(const Answer& answer) {
  std::printf("{\"ns\":%.17g,\"seconds\":%.17g,\"repetitions\":%zu,\"peak_kib\":%ld", answer.ns,
              answer.seconds, answer.repetitions, peak_memory_kib());
  std::printf(",\"values\":%s,\"counts\":%s,\"weights\":[", json_list(answer.values).c_str(),
              json_list(answer.counts).c_str());
  for (std::size_t k = 0; k < answer.weights.size(); ++k) {
    std::printf("%s%s", k > 0 ? "," : "", json_list(answer.weights[k]).c_str());
  }
  std::printf("],\"about\":{");
  const char* comma = "";
  for (const auto& [key, value] : answer.about) {
    std::printf("%s\"%s\":\"%s\"", std::exchange(comma, ","), key.c_str(), value.c_str());
  }
  std::printf("}}\n");
}

}  // namespace bench
