// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/core/progress.hpp"
#include "proofmass/files/sha256.hpp"

namespace proofmass {

// Reads a text file line by line in blocks, so that memory is bounded by the longest line allowed, and hashes
// what it reads. Lines end in LF or CRLF. Refuses, with a bad-data Error, what is not a text file:
// directories, control characters, UTF-16, lines that are too long. Reports megabytes read while the file's
// size is known, and stops with an Error of kind interrupted when it is told to.
class LineReader {
 public:
  static constexpr std::size_t kLongestLine = std::size_t{1} << 20;  // bytes

  // "-" is standard input. Keeps the progress, which must outlive it.
  LineReader(const std::filesystem::path& path, Progress& progress);

  // The next line without its end, valid until the next call; nothing at the end of the file.
  [[nodiscard]] std::optional<std::string_view> next();
  // Of the line last returned, from 1.
  [[nodiscard]] std::size_t line_number() const noexcept { return line_number_; }
  // How many lines the file holds if they are as long as those so far; 0 when its size is unknown.
  [[nodiscard]] std::size_t expected_lines() const noexcept;
  // The file as messages name it.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  // Of the bytes read; call once, at the end of the file.
  [[nodiscard]] std::string sha256() { return hash_.hex(); }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept;
  };
  bool fill();
  void report() const;
  [[nodiscard]] std::string_view take(std::size_t length, std::size_t skip);
  void check(std::string_view line) const;

  std::string name_;
  std::unique_ptr<std::FILE, Close> file_;
  Progress& progress_;
  std::size_t size_ = 0;  // of the file in bytes; 0 when unknown, as that of a pipe
  std::size_t read_ = 0;  // bytes
  Sha256 hash_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  // of the bytes in the buffer that have not been returned yet
  std::size_t end_ = 0;
  bool clean_ = false;  // no control character but tabs and line ends in the buffer
  bool at_end_ = false;
  std::size_t line_number_ = 0;
};

}  // namespace proofmass
