// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "contract/answer.hpp"
#include "contract/request.hpp"
#include "contract/table.hpp"

namespace bench {

// Processor time of the process, all threads together. On an idle machine it is the wall-clock time for one
// thread; time slices of other processes do not count.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Runs the work once to warm up (short work only), then until `seconds` have passed. The median run counts.
inline Answer measure(double seconds, const std::function<void()>& work) {
  std::vector<double> times;
  const auto once = [&] {
    const double start = processor_seconds();
    work();
    times.push_back(processor_seconds() - start);
  };
  once();
  if (times.front() < seconds) {
    times.clear();
    const double start = processor_seconds();
    while (times.empty() || processor_seconds() - start < seconds) once();
  }
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  Answer answer;
  answer.seconds = times[times.size() / 2];
  answer.repetitions = times.size();
  return answer;
}

// The result of training from one start.
struct Trained {
  std::vector<double> weights;
  double rmse = 0.0;       // of the scaled output over the training samples
  std::size_t epochs = 0;  // Jacobians computed, as exactly as the program can tell
};
using TrainOne = std::function<Trained(std::span<const double> start, std::size_t epochs)>;

// Trains every start of the request by `train`.
inline Answer contend_training(const Request& request, const NetworkSamples& samples, const TrainOne& train) {
  const std::vector<Row> starts = read_table(request.starts);
  std::vector<Trained> runs(starts.size());
  Answer answer = measure(request.seconds, [&] {
    for (std::size_t k = 0; k < starts.size(); ++k) runs[k] = train(starts[k], request.epochs);
  });
  for (const Trained& run : runs) {
    answer.values.push_back(run.rmse);
    answer.counts.push_back(static_cast<double>(run.epochs));
    answer.weights.push_back(run.weights);
  }
  const double epochs = std::accumulate(answer.counts.begin(), answer.counts.end(), 0.0);
  answer.ns = 1e9 * answer.seconds / (epochs * static_cast<double>(samples.rows));
  return answer;
}

using Task = std::function<Answer(const Request&)>;

// The body of a contestant's main().
inline int contend(int argc, char** argv, const std::map<std::string, Task>& tasks) {
  try {
    const Request request = parse_request(argc, argv);
    const auto found = tasks.find(request.task);
    if (found == tasks.end()) throw std::runtime_error("no task " + request.task);
    print(found->second(request));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  }
  return 0;
}

}  // namespace bench
