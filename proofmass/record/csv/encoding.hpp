// SPDX-License-Identifier: Apache-2.0
// The encodings in which benches and spreadsheets write text, and their conversion to UTF-8.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace proofmass {

enum class Encoding : std::uint8_t { utf8, utf16le, utf16be, gb18030, windows1252 };

// "UTF-8", "GB18030", …
[[nodiscard]] std::string_view to_string(Encoding encoding) noexcept;

// By its name or a usual other one, whatever the case: "gbk", "cp1252", "latin1".
[[nodiscard]] std::optional<Encoding> find_encoding(std::string_view name);

// "UTF-8, UTF-16LE, …", for error messages.
[[nodiscard]] std::string known_encodings();

// What the first bytes of a file say: its byte order mark, or a zero in every other byte as text in UTF-16
// has. Empty when neither does, which leaves the encodings that have ASCII in common.
[[nodiscard]] std::optional<Encoding> encoding_by_mark(std::string_view first_bytes) noexcept;

// The encoding of text with bytes beyond ASCII: UTF-8 when it is valid; otherwise GB18030 when most of those
// bytes come in the pairs of Chinese characters, and Windows-1252 when most stand alone or among letters.
[[nodiscard]] Encoding encoding_by_content(std::string_view text) noexcept;

[[nodiscard]] bool is_ascii(std::string_view text) noexcept;

// Converts text that comes in pieces to UTF-8. A character may begin in one piece and end in the next.
class Decoder {
 public:
  explicit Decoder(Encoding encoding);
  // Empty when the bytes are not text of that encoding.
  [[nodiscard]] std::optional<std::string> decode(std::string_view bytes);
  // Bytes of a character that has not ended.
  [[nodiscard]] bool incomplete() const noexcept { return !rest_.empty(); }

 private:
  struct Close {
    void operator()(void* converter) const noexcept;
  };
  std::unique_ptr<void, Close> converter_;
  std::string rest_;
};

}  // namespace proofmass
