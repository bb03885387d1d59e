// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/lines.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/files/text_file.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;  // bytes read at a time
constexpr std::size_t kMegabyte = 1'000'000;
constexpr char kEndMark = '\x1A';

Error unreadable(const std::string& name, int os_error) {
  return bad_data({.file = name, .row = 0, .column = {}}, system_reason(os_error),
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

// Only a tab, which may be a separator, and line ends are allowed among the characters below a blank.
bool has_control(std::string_view text) noexcept {
  unsigned char found = 0;  // no early exit, and bytes: the compiler then vectorises the loop
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
    found = static_cast<unsigned char>(found | static_cast<unsigned char>(control));
  }
  return found != 0;
}

bool is_control(char c) noexcept { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; }

// The first control character of a line and the text around it.
std::string_view around_control(std::string_view line) {
  const auto position =
      static_cast<std::size_t>(std::find_if(line.begin(), line.end(), is_control) - line.begin());
  const std::size_t first = position > 20 ? position - 20 : 0;
  return line.substr(first, 30);
}

Message too_long() { return message("lines of at most {} bytes", ChunkReader::kLongestLine); }

// Whether a CR stands in the text that no LF follows.
bool has_lone_return(std::string_view text) noexcept {
  for (auto at = text.find('\r'); at != std::string_view::npos; at = text.find('\r', at + 1)) {
    if (at + 1 < text.size() && text[at + 1] != '\n') return true;
  }
  return false;
}

}  // namespace

void ChunkReader::Close::operator()(std::FILE* file) const noexcept {
  if (file != stdin) std::fclose(file);
}

ChunkReader::ChunkReader(const std::filesystem::path& path, std::optional<Encoding> encoding,
                         Progress& progress)
    : name_(path == "-" ? std::string(kStandardInput) : path.string()),
      file_(open(path, name_)),
      progress_(progress),
      size_(size_of(file_.get())),
      encoding_(encoding) {}

double ChunkReader::growth() const noexcept {
  return size_ > read_ ? static_cast<double>(size_) / static_cast<double>(read_) : 1.0;
}

void ChunkReader::report() const {
  if (progress_.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
  if (size_ == 0) return;
  const auto megabytes = [](std::size_t bytes) { return (bytes + kMegabyte - 1) / kMegabyte; };
  progress_.update("reading (MB)", megabytes(read_), megabytes(std::max(size_, read_)));  // it may grow
}

bool ChunkReader::fill() {
  if (at_end_) return false;
  block_.resize(kBlock);
  errno = 0;
  const std::size_t got = std::fread(block_.data(), 1, kBlock, file_.get());
  if (std::ferror(file_.get()) != 0) throw unreadable(name_, errno);
  const std::string_view bytes(block_.data(), got);
  hash_.update(bytes);
  if (read_ == 0) {
    if (!encoding_) encoding_ = encoding_by_mark(bytes);
    if (encoding_ == Encoding::utf16le || encoding_ == Encoding::utf16be) wide_.emplace(*encoding_);
  }
  read_ += got;
  at_end_ = got < kBlock;
  take_bytes(bytes);
  report();
  return got > 0;
}

void ChunkReader::take_bytes(std::string_view bytes) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const bool first = text_.empty() && line_number_ == 0;
  if (wide_) {
    const auto text = wide_->decode(bytes);
    if (!text || (at_end_ && wide_->incomplete())) {
      throw bad_data({.file = name_}, "", message("text in {}", to_string(*encoding_)));
    }
    text_ += *text;
  } else {
    text_ += bytes;
  }
  if (first && text_.starts_with(byte_order_mark)) text_.erase(0, byte_order_mark.size());
}

std::optional<Chunk> ChunkReader::next() {
  std::size_t end = std::string::npos;
  while (end == std::string::npos) {
    const bool more = fill();
    if (!more || at_end_) {
      end = text_.size();
    } else {
      end = text_.rfind('\n');
      if (end != std::string::npos) ++end;
    }
    if (end == std::string::npos && text_.size() > kLongestLine) {
      throw bad_data({.file = name_, .row = line_number_ + 1}, text_.substr(0, 64), too_long());
    }
    if (!more) break;
  }
  if (text_.empty()) return std::nullopt;
  Chunk chunk{.text = {}, .first_line = line_number_ + 1, .lines = 0};
  std::string rest = text_.substr(end);
  text_.resize(end);
  chunk.text = std::exchange(text_, std::move(rest));
  if (at_end_ && text_.empty() && chunk.text.ends_with(kEndMark)) {
    had_end_mark_ = true;
    chunk.text.resize(chunk.text.find_last_not_of(kEndMark) + 1);
    if (chunk.text.empty()) return std::nullopt;
  }
  decode(chunk);
  check(chunk);
  chunk.lines = static_cast<std::size_t>(std::count(chunk.text.begin(), chunk.text.end(), '\n'));
  line_number_ += chunk.lines;
  return chunk;
}

// Lines are whole, so that each can be converted by itself; LF is LF in all encodings that have ASCII in
// common.
void ChunkReader::decode(Chunk& chunk) {
  if (wide_ || is_ascii(chunk.text)) return;
  const bool guessed = !encoding_;
  if (guessed) encoding_ = encoding_by_content(chunk.text);
  if (encoding_ == Encoding::utf8) return;
  if (guessed && encoding_ == Encoding::gb18030) {
    Decoder trial(*encoding_);
    if (!trial.decode(chunk.text) || trial.incomplete()) encoding_ = Encoding::windows1252;
  }
  Decoder decoder(*encoding_);
  if (auto text = decoder.decode(chunk.text); text && !decoder.incomplete()) {
    chunk.text = std::move(*text);
    return;
  }
  for_each_line(chunk.text, chunk.first_line, [this](std::string_view line, std::size_t number) {
    Decoder one(*encoding_);
    const auto text = one.decode(line);
    if (text && !one.incomplete()) return true;
    throw bad_data({.file = name_, .row = number}, line, message("text in {}", to_string(*encoding_)),
                   {{"encoding", std::string(to_string(Encoding::windows1252))}});
  });
}

void ChunkReader::check(const Chunk& chunk) const {
  const bool bad = has_control(chunk.text) || has_lone_return(chunk.text);
  const bool may_be_long = chunk.text.size() > kLongestLine;
  if (!bad && !may_be_long) return;
  for_each_line(chunk.text, chunk.first_line, [this, bad](std::string_view line, std::size_t number) {
    const Place place{.file = name_, .row = number, .column = {}};
    if (line.size() > kLongestLine) throw bad_data(place, line.substr(0, 64), too_long());
    if (!bad || std::none_of(line.begin(), line.end(), is_control)) return true;
    const std::string_view found = around_control(line);
    if (line.find('\0') == std::string_view::npos && line.find('\r') != std::string_view::npos) {
      throw bad_data(place, found, "lines that end in LF or CRLF, not in CR alone");
    }
    throw bad_data(place, found, "text without control characters, not a binary file");
  });
}

}  // namespace proofmass
