// SPDX-License-Identifier: Apache-2.0
#include "output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <system_error>

#include "proofmass/core/error.hpp"

namespace proofmass::cli {

void print(std::string_view text) {
  errno = 0;
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
  if (written != text.size() || std::fflush(stdout) != 0) {
    if (errno == EPIPE) return;  // the reader has seen enough, as head does
    throw usage_error(
        fmt::format("cannot write to standard output: {}", std::generic_category().message(errno)));
  }
}

TerminalStyle terminal_style() {
  const char* const no_colour = std::getenv("NO_COLOR");
  const bool refused = no_colour != nullptr && *no_colour != '\0';
  return {.colour = !refused && isatty(STDOUT_FILENO) == 1};
}

void OutputFiles::add(const std::filesystem::path& path, std::string_view text) {
  if (path == "-") {
    standard_output_ += text;
    return;
  }
  files_.emplace_back(path).stream() << text;
}

void OutputFiles::add(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  if (path != "-") return write(files_.emplace_back(path).stream());
  std::ostringstream text;
  write(text);
  standard_output_ += text.view();
}

void OutputFiles::commit() {
  for (AtomicFile& file : files_) file.close();
  if (!standard_output_.empty()) print(standard_output_);
  for (AtomicFile& file : files_) file.commit();
  files_.clear();
}

void require_other_file(const std::filesystem::path& output,
                        std::initializer_list<std::filesystem::path> inputs) {
  if (output.empty() || output == "-") return;
  for (const auto& input : inputs) {
    std::error_code ignored;
    if (input == "-" || !std::filesystem::is_regular_file(output, ignored)) continue;
    if (std::filesystem::equivalent(output, input, ignored)) {
      throw usage_error(fmt::format("'{}' is an input: writing it would destroy it", output.string()));
    }
  }
}

void require_folder_of(const std::filesystem::path& file) {
  if (file.empty() || file == "-" || !file.has_parent_path()) return;
  std::error_code ignored;
  if (!std::filesystem::is_directory(file.parent_path(), ignored)) {
    throw usage_error(fmt::format("cannot write '{}': there is no folder '{}'", file.string(),
                                  file.parent_path().string()));
  }
}

}  // namespace proofmass::cli
