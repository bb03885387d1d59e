// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/lines.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;  // bytes read at a time
constexpr std::size_t kMegabyte = 1'000'000;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

Error unreadable(const std::string& name, int os_error) {
  return bad_data({.file = name, .row = 0, .column = {}}, std::generic_category().message(os_error),
                  "a readable record (a CSV file)");
}

std::FILE* open(const std::filesystem::path& path, const std::string& name) {
  if (path == "-") return stdin;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw cannot_open(name, EISDIR);
  errno = 0;
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) throw cannot_open(name, errno);
  return file;
}

// Bytes in a regular file (standard input may be one); 0 for anything else.
std::size_t size_of(std::FILE* file) noexcept {
  struct stat status {};
  if (fstat(fileno(file), &status) != 0 || !S_ISREG(status.st_mode)) return 0;
  return static_cast<std::size_t>(status.st_size);
}

// Only a tab, which may be a separator, and `line_end` are allowed among the characters below a blank.
bool has_control(std::string_view text, char line_end = '\t') noexcept {
  unsigned char found = 0;  // no early exit, and bytes: the compiler then vectorises the loop
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != line_end;
    found = static_cast<unsigned char>(found | static_cast<unsigned char>(control));
  }
  return found != 0;
}

// The first control character and the text around it.
std::string_view around_control(std::string_view line) {
  const auto* const at = std::find_if(line.begin(), line.end(), [](char c) { return has_control({&c, 1}); });
  const auto position = static_cast<std::size_t>(at - line.begin());
  const std::size_t first = position > 20 ? position - 20 : 0;
  return line.substr(first, 30);
}

}  // namespace

void LineReader::Close::operator()(std::FILE* file) const noexcept {
  if (file != stdin) std::fclose(file);
}

LineReader::LineReader(const std::filesystem::path& path, Progress& progress)
    : name_(path == "-" ? "standard input" : path.string()),
      file_(open(path, name_)),
      progress_(progress),
      size_(size_of(file_.get())) {}

std::size_t LineReader::expected_lines() const noexcept {
  const std::size_t returned = read_ - (end_ - begin_);
  if (returned == 0) return 0;
  return static_cast<std::size_t>(static_cast<double>(size_) / static_cast<double>(returned) *
                                  static_cast<double>(line_number_));
}

void LineReader::report() const {
  if (progress_.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
  if (size_ == 0) return;
  const auto megabytes = [](std::size_t bytes) { return (bytes + kMegabyte - 1) / kMegabyte; };
  progress_.update("reading (MB)", megabytes(read_), megabytes(std::max(size_, read_)));  // it may grow
}

bool LineReader::fill() {
  if (at_end_) return false;
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() < end_ + kBlock) buffer_.resize(end_ + kBlock);
  errno = 0;
  const std::size_t got = std::fread(buffer_.data() + end_, 1, kBlock, file_.get());
  if (std::ferror(file_.get()) != 0) throw unreadable(name_, errno);
  hash_.update({buffer_.data() + end_, got});
  end_ += got;
  read_ += got;
  clean_ = !has_control({buffer_.data(), end_}, '\n');
  at_end_ = got < kBlock;
  report();
  return got > 0;
}

std::optional<std::string_view> LineReader::next() {
  std::size_t searched = 0;
  while (true) {
    const std::size_t available = end_ - begin_;
    const char* const text = buffer_.data() + begin_;
    const void* const found =
        available > searched ? std::memchr(text + searched, '\n', available - searched) : nullptr;
    if (found != nullptr) return take(static_cast<std::size_t>(static_cast<const char*>(found) - text), 1);
    if (available > kLongestLine) {
      throw bad_data({.file = name_, .row = line_number_ + 1, .column = {}}, {text, 64},
                     "lines of at most 1048576 bytes");
    }
    searched = available;
    if (!fill()) break;
  }
  if (begin_ == end_) return std::nullopt;
  return take(end_ - begin_, 0);
}

std::string_view LineReader::take(std::size_t length, std::size_t skip) {
  std::string_view line(buffer_.data() + begin_, length);
  begin_ += length + skip;
  ++line_number_;
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (line_number_ == 1 && line.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    line.remove_prefix(kByteOrderMark.size());
  }
  check(line);
  return line;
}

void LineReader::check(std::string_view line) const {
  const Place place{.file = name_, .row = line_number_, .column = {}};
  if (line.size() > kLongestLine) throw bad_data(place, line.substr(0, 64), "lines of at most 1048576 bytes");
  if (line_number_ == 1 && (line.substr(0, 2) == "\xFF\xFE" || line.substr(0, 2) == "\xFE\xFF")) {
    throw bad_data(place, line.substr(0, 8), "text in UTF-8, not UTF-16");
  }
  if (clean_ || !has_control(line)) return;
  const std::string_view found = around_control(line);
  if (line.find('\0') == std::string_view::npos && line.find('\r') != std::string_view::npos) {
    throw bad_data(place, found, "lines that end in LF or CRLF, not in CR alone");
  }
  throw bad_data(place, found, "text without control characters, not a binary file");
}

}  // namespace proofmass
