// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "contract/request.hpp"

namespace bench {

using Row = std::vector<double>;

// Comma-separated numbers without a header.
inline std::vector<Row> read_table(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<Row> table;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    Row row;
    for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
    table.push_back(std::move(row));
  }
  if (table.empty()) throw std::runtime_error(path + " is empty");
  return table;
}

// Scaled inputs and target of the networks, one row each: x1, x2, x3, target. When more rows are asked for
// than the file has, they are repeated: the cost grows, and the optimum stays the same.
struct NetworkSamples {
  std::vector<Row> file;
  std::size_t rows = 0;
  [[nodiscard]] const Row& at(std::size_t row) const { return file[row % file.size()]; }
};

inline NetworkSamples read_samples(const Request& request) {
  NetworkSamples samples;
  samples.file = read_table(request.data);
  samples.rows = request.rows > 0 ? request.rows : samples.file.size();
  return samples;
}

// A matrix of doubles stored as columns, one after the other.
inline std::vector<std::vector<double>> read_columns(const std::string& path, std::size_t columns) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw std::runtime_error("cannot read " + path);
  const auto rows = static_cast<std::size_t>(file.tellg()) / (columns * sizeof(double));
  file.seekg(0);
  std::vector<std::vector<double>> result(columns, std::vector<double>(rows));
  for (auto& column : result) {
    file.read(reinterpret_cast<char*>(column.data()), static_cast<std::streamsize>(rows * sizeof(double)));
  }
  if (!file) throw std::runtime_error(path + " is cut short");
  return result;
}

}  // namespace bench
