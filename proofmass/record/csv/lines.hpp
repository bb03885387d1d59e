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

// Reads a text file line by line in blocks, and hashes what it reads. The longest line allowed limits the
// memory. Lines end in LF or CRLF. Throws a bad-data Error when the input is not a text file: a directory,
// control characters, UTF-16, or lines that are too long. Reports megabytes read when the file's size is
// known, and throws an Error of kind interrupted when it is told to stop.
class LineReader {
 public:
  static constexpr std::size_t kLongestLine = std::size_t{1} << 20;  // bytes

  // "-" is standard input. Keeps a reference to the progress, which must outlive this object.
  LineReader(const std::filesystem::path& path, Progress& progress);

  // The next line without its line end, valid until the next call. Empty at the end of the file.
  [[nodiscard]] std::optional<std::string_view> next();
  // Number of the line last returned, from 1.
  [[nodiscard]] std::size_t line_number() const noexcept { return line_number_; }
  // Estimated number of lines in the file, from the mean length so far; 0 when the file's size is unknown.
  [[nodiscard]] std::size_t expected_lines() const noexcept;
  // Name of the file for messages.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  // Hash of the bytes read. Call once, at the end of the file.
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
  bool clean_ = false;  // the buffer has no control characters other than tabs and line ends
  bool at_end_ = false;
  std::size_t line_number_ = 0;
};

}  // namespace proofmass
