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

#include "proofmass/core/sha256.hpp"

namespace proofmass {

// Reads a text file line by line in blocks, so that memory is bounded by the longest line allowed, and hashes
// what it reads. Lines end in LF or CRLF. Refuses, with a bad-data Error, what is not a text file:
// directories, control characters, UTF-16, lines that are too long.
class LineReader {
 public:
  static constexpr std::size_t kLongestLine = std::size_t{1} << 20;  // bytes

  explicit LineReader(const std::filesystem::path& path);  // "-" is standard input

  // The next line without its end, valid until the next call; nothing at the end of the file.
  [[nodiscard]] std::optional<std::string_view> next();
  // Of the line last returned, from 1.
  [[nodiscard]] std::size_t line_number() const noexcept { return line_number_; }
  // The file as messages name it.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  // Of the bytes read; call once, at the end of the file.
  [[nodiscard]] std::string sha256() { return hash_.hex(); }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept;
  };
  bool fill();
  [[nodiscard]] std::string_view take(std::size_t length, std::size_t skip);
  void check(std::string_view line) const;

  std::string name_;
  std::unique_ptr<std::FILE, Close> file_;
  Sha256 hash_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  // of the bytes in the buffer that have not been returned yet
  std::size_t end_ = 0;
  bool at_end_ = false;
  std::size_t line_number_ = 0;
};

}  // namespace proofmass
