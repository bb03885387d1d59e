// SPDX-License-Identifier: Apache-2.0
#include "proofmass/files/text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

struct Closer {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};

std::string read_stream(std::FILE* file, const Place& place, const Message& what, std::size_t most) {
  constexpr std::size_t kChunk = std::size_t{1} << 16;
  std::string bytes;
  while (bytes.size() <= most) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kChunk);
    const std::size_t got = std::fread(bytes.data() + before, 1, kChunk, file);
    bytes.resize(before + got);
    if (got < kChunk) break;
  }
  if (std::ferror(file) != 0) throw bad_data(place, system_reason(errno), what);
  if (bytes.size() > most) {
    throw bad_data(place, message("more than {} MiB", most >> 20U), what);
  }
  return bytes;
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path, const Message& what, std::size_t most) {
  if (path == "-")
    return read_stream(stdin, {.file = std::string(kStandardInput), .row = 0, .column = {}}, what, most);
  const Place place{.file = path.string(), .row = 0, .column = {}};
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw cannot_open(place.file, EISDIR);
  errno = 0;
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
  if (!file) throw cannot_open(place.file, errno);
  return read_stream(file.get(), place, what, most);
}

}  // namespace proofmass
