// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "proofmass/core/progress.hpp"
#include "proofmass/files/sha256.hpp"
#include "proofmass/record/csv/encoding.hpp"

namespace proofmass {

// Whole lines of a text file in UTF-8, each ended by LF or CRLF but perhaps the last of the file.
struct Chunk {
  std::string text;
  std::size_t first_line = 1;  // number of its first line in the file, from 1
  std::size_t lines = 0;       // line ends
};

// Calls line(text, number) for each line of a chunk from a byte on, without line ends. `number` is the first
// one's. Stops when the call returns false.
template <typename Line>
void for_each_line(std::string_view text, std::size_t number, Line&& line) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view one = text.substr(0, end);
    if (one.ends_with('\r')) one.remove_suffix(1);
    if (!line(one, number)) return;
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
    ++number;
  }
}

// Reads a text file in chunks of a quarter of a mebibyte or more, hashes what it reads and converts it to
// UTF-8. Throws a bad-data Error when the input is no text: a directory, control characters, lines of more
// than a mebibyte, bytes that are not of the encoding. Reports megabytes read when the file's size is known,
// and throws an Error of kind interrupted when it is told to stop. Not for several threads at once.
class ChunkReader {
 public:
  static constexpr std::size_t kLongestLine = std::size_t{1} << 20;  // bytes

  // "-" is standard input. Without an encoding it is found out. Keeps a reference to the progress, which must
  // outlive this object.
  ChunkReader(const std::filesystem::path& path, std::optional<Encoding> encoding, Progress& progress);

  // Empty at the end of the file.
  [[nodiscard]] std::optional<Chunk> next();
  // Bytes of the file over bytes read so far; 1 when the size is unknown.
  [[nodiscard]] double growth() const noexcept;
  // Name of the file for messages.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  // UTF-8 as long as nothing beyond ASCII was read.
  [[nodiscard]] Encoding encoding() const noexcept { return encoding_.value_or(Encoding::utf8); }
  // Whether the file ended in Ctrl-Z, as DOS programs mark the end; it is left out.
  [[nodiscard]] bool had_end_mark() const noexcept { return had_end_mark_; }
  // Hash of the bytes read. Call once, at the end of the file.
  [[nodiscard]] std::string sha256() { return hash_.hex(); }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept;
  };
  bool fill();
  void take_bytes(std::string_view bytes);
  void report() const;
  void decode(Chunk& chunk);
  void check(const Chunk& chunk) const;

  std::string name_;
  std::unique_ptr<std::FILE, Close> file_;
  Progress& progress_;
  std::size_t size_ = 0;  // of the file in bytes; 0 when unknown, as that of a pipe
  std::size_t read_ = 0;  // bytes
  Sha256 hash_;
  std::string block_;                 // as read
  std::string text_;                  // not returned yet; UTF-8 only where the encoding has no ASCII
  std::optional<Encoding> encoding_;  // not known before there is something beyond ASCII
  std::optional<Decoder> wide_;       // of UTF-16, whose line ends are two bytes
  bool at_end_ = false;
  bool had_end_mark_ = false;
  std::size_t line_number_ = 0;  // of the last line returned
};

}  // namespace proofmass
