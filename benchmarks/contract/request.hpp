// SPDX-License-Identifier: Apache-2.0
// The request to a contestant, the same for ours and the peers:
//   PROGRAM TASK --data FILE [--starts FILE] [--variant NAME] [--seconds S] [--epochs K] [--rows N]
//   [--hidden H] [--target T]
// The answer is one line of JSON (answer.hpp). Tasks: forward, train, least-squares, read.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace bench {

struct Request {
  std::string task;
  std::string data;        // samples (forward, train), columns of doubles (least-squares), a record (read)
  std::string starts;      // weights, one network per row
  std::string variant;     // the algorithm, where a program has several
  std::string target;      // instruction set of our kernels: sse4, avx2, avx3; empty: the best available
  double seconds = 0.3;    // repeats until this much processor time has passed
  std::size_t epochs = 0;  // of training, at most
  std::size_t rows = 0;    // repeats the samples up to this many rows; 0: no repetition
  std::size_t hidden = 7;  // tanh units
};

inline Request parse_request(int argc, char** argv) {
  if (argc < 2 || argc % 2 != 0) throw std::runtime_error("usage: PROGRAM TASK [--FLAG VALUE]...");
  Request request;
  request.task = argv[1];
  for (int k = 2; k < argc; k += 2) {
    const std::string flag = argv[k];
    const std::string value = argv[k + 1];
    if (flag == "--data") {
      request.data = value;
    } else if (flag == "--starts") {
      request.starts = value;
    } else if (flag == "--variant") {
      request.variant = value;
    } else if (flag == "--target") {
      request.target = value;
    } else if (flag == "--seconds") {
      request.seconds = std::stod(value);
    } else if (flag == "--epochs") {
      request.epochs = std::stoul(value);
    } else if (flag == "--rows") {
      request.rows = std::stoul(value);
    } else if (flag == "--hidden") {
      request.hidden = std::stoul(value);
    } else {
      throw std::runtime_error("unknown flag " + flag);
    }
  }
  return request;
}

}  // namespace bench
