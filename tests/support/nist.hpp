// SPDX-License-Identifier: Apache-2.0
// Reads the .dat files of the NIST Statistical Reference Datasets, linear and nonlinear.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace proofmass::test {

struct NistProblem {
  std::string name;
  std::vector<double> certified;            // one a parameter
  std::vector<double> certified_sd;         // standard deviations of the estimates
  std::vector<std::vector<double>> starts;  // two for nonlinear problems, none for linear ones
  double residual_sd = 0.0;
  double residual_sum_of_squares = 0.0;
  std::vector<double> y;
  std::vector<std::vector<double>> x;  // one vector a predictor
};

inline std::vector<double> numbers_in(std::string text) {
  std::replace(text.begin(), text.end(), '=', ' ');
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    std::size_t used = 0;
    try {
      const double value = std::stod(word, &used);
      if (used == word.size()) numbers.push_back(value);
    } catch (const std::invalid_argument&) {
      continue;
    }
  }
  return numbers;
}

// The two line numbers in a header entry such as "Certified Values  (lines 31 to 51)".
inline std::pair<std::size_t, std::size_t> line_range(const std::vector<std::string>& lines,
                                                      const std::string& what) {
  for (const std::string& line : lines) {
    const auto at = line.find("(lines");
    if (at == std::string::npos || line.find(what) == std::string::npos) continue;
    std::string range = line.substr(at + 6);
    std::replace(range.begin(), range.end(), ')', ' ');
    const auto numbers = numbers_in(range);
    return {static_cast<std::size_t>(numbers.at(0)), static_cast<std::size_t>(numbers.at(1))};
  }
  throw std::runtime_error("no line range for " + what);
}

inline void read_certified_line(const std::string& line, NistProblem& problem) {
  const auto first = line.find_first_not_of(' ');
  if (first == std::string::npos) return;
  const auto numbers = numbers_in(line.substr(first));
  const bool parameter = first + 1 < line.size() && std::tolower(line[first]) == 'b' &&
                         std::isdigit(static_cast<unsigned char>(line[first + 1])) != 0;
  if (parameter && numbers.size() == 4) {
    problem.starts.resize(2);
    problem.starts[0].push_back(numbers[0]);
    problem.starts[1].push_back(numbers[1]);
  }
  if (parameter && numbers.size() >= 2) {
    problem.certified.push_back(numbers[numbers.size() - 2]);
    problem.certified_sd.push_back(numbers.back());
  } else if (line.find("Standard Deviation") != std::string::npos && numbers.size() == 1) {
    problem.residual_sd = numbers[0];
  } else if (line.find("Sum of Squares") != std::string::npos && numbers.size() == 1) {
    problem.residual_sum_of_squares = numbers[0];
  } else if (line.find("Residual") != std::string::npos && numbers.size() == 3) {
    problem.residual_sum_of_squares = numbers[1];  // of degrees of freedom, sum, mean
  }
}

inline NistProblem read_nist(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines(1);  // so that line numbers count from 1
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  NistProblem problem;
  problem.name = path.stem().string();
  const auto [first_row, last_row] = line_range(lines, "Data");
  // The sums of squares follow the certified values that the header announces.
  const std::size_t first_certified = line_range(lines, "Certified Values").first;
  for (std::size_t k = first_certified; k < first_row; ++k) read_certified_line(lines.at(k), problem);
  for (std::size_t k = first_row; k <= last_row; ++k) {
    const auto row = numbers_in(lines.at(k));
    problem.y.push_back(row.at(0));
    problem.x.resize(row.size() - 1);
    for (std::size_t c = 1; c < row.size(); ++c) problem.x[c - 1].push_back(row[c]);
  }
  return problem;
}

// Correct digits of a value (NIST's log relative error), at most 15. For a certified zero, by the absolute
// error.
inline double correct_digits(double value, double certified) {
  const double error = std::abs(value - certified) / (certified == 0.0 ? 1.0 : std::abs(certified));
  return error == 0.0 ? 15.0 : std::clamp(-std::log10(error), 0.0, 15.0);
}

}  // namespace proofmass::test
