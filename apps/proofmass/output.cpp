// SPDX-License-Identifier: Apache-2.0
#include "output.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <set>
#include <sstream>
#include <system_error>

#include "proofmass/core/error.hpp"

namespace proofmass::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kUsualWidth = 80;  // columns, where standard output is no terminal
constexpr std::size_t kLeastWidth = 40;  // less is not a width that anybody reads tables in

}  // namespace

std::optional<std::size_t> terminal_columns(int descriptor) {
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

void print(std::string_view text) {
  // Streams would go on waiting for the reader after a signal.
  while (!text.empty()) {
    if (interrupted()) {
      throw Error(ErrorKind::interrupted, "interrupted while writing to standard output");
    }
    const ssize_t written = write(STDOUT_FILENO, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
      continue;
    }
    if (errno == EPIPE) return;  // the reader has seen enough, as head does
    if (errno == EINTR) continue;
    throw usage_error(message("cannot write to standard output: {}", system_reason(errno)));
  }
}

TerminalStyle terminal_style(bool wide, Language language) {
  const char* const no_colour = std::getenv("NO_COLOR");
  const bool refused = no_colour != nullptr && *no_colour != '\0';
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  const std::size_t width =
      terminal ? std::max(terminal_columns(STDOUT_FILENO).value_or(kUsualWidth), kLeastWidth) : kUsualWidth;
  return {.colour = !refused && terminal,
          .width = wide ? 0 : width,
          .more_columns = "--wide",
          .language = language};
}

OutputFiles::~OutputFiles() {
  files_.clear();
  // One that something else has been put into stays.
  std::error_code ignored;
  for (; !new_folders_.empty(); new_folders_.pop_back()) fs::remove(new_folders_.back(), ignored);
}

void OutputFiles::make_folder(const fs::path& path) {
  fs::path folder;
  for (const fs::path& part : path) {
    folder /= part;
    std::error_code failure;
    if (fs::is_directory(folder, failure)) continue;
    if (fs::create_directory(folder, failure)) new_folders_.push_back(folder);
    if (failure) {
      throw usage_error(
          message("cannot make the folder '{}': {}", path.string(), system_reason(failure.value())));
    }
  }
}

void OutputFiles::add(const fs::path& path, std::string_view text) {
  add(path, [text](std::ostream& out) { out << text; });
}

void OutputFiles::add(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  if (path == "-") {
    std::ostringstream text;
    write(text);
    standard_output_ += text.view();
    return;
  }
  try {
    write(files_.emplace_back(path).stream());
  } catch (const Error&) {
    stop_if_interrupted();  // which is then why a pipe without a reader could not be opened
    throw;
  }
}

void OutputFiles::commit() {
  for (AtomicFile& file : files_) file.close();
  stop_if_interrupted();
  if (!standard_output_.empty()) print(standard_output_);
  for (AtomicFile& file : files_) file.commit();
  files_.clear();
  new_folders_.clear();
}

void require_other_file(const fs::path& output, std::initializer_list<fs::path> inputs) {
  if (output.empty() || output == "-") return;
  for (const auto& input : inputs) {
    std::error_code ignored;
    if (input == "-" || !fs::is_regular_file(output, ignored)) continue;
    if (fs::equivalent(output, input, ignored)) {
      throw usage_error(message("'{}' is an input: writing it would destroy it", output.string()));
    }
  }
}

void require_distinct_outputs(std::initializer_list<fs::path> outputs) {
  std::set<fs::path> seen;
  for (const auto& output : outputs) {
    if (output.empty()) continue;
    std::error_code ignored;
    const fs::path place =
        output == "-" ? output : fs::weakly_canonical(fs::absolute(output, ignored), ignored);
    if (!seen.insert(place).second) {
      throw usage_error(
          message("'{}' is to be written twice: give each output a file of its own", output.string()));
    }
  }
}

void require_folder_of(const fs::path& file) {
  if (file.empty() || file == "-" || !file.has_parent_path()) return;
  std::error_code ignored;
  if (!fs::is_directory(file.parent_path(), ignored)) {
    throw usage_error(
        message("cannot write '{}': there is no folder '{}'", file.string(), file.parent_path().string()));
  }
}

void require_writable_file(const fs::path& file) {
  require_folder_of(file);
  if (file.empty() || file == "-") return;
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status)) {
    OutputFiles().add(file, std::string_view{});
  } else if (access(file.c_str(), W_OK) != 0) {
    throw usage_error(message("cannot write '{}': {}", file.string(), system_reason(errno)));
  }
}

void require_writable(const fs::path& folder, std::initializer_list<fs::path> files) {
  std::error_code ignored;
  if (!folder.empty() && fs::exists(folder, ignored) && !fs::is_directory(folder, ignored)) {
    throw usage_error(message("--out: '{}' is not a folder", folder.string()));
  }
  OutputFiles attempt;  // the folder is there while the files in it are tried
  if (!folder.empty()) {
    attempt.make_folder(folder);
    attempt.add(folder / ".proofmass", std::string_view{});
  }
  for (const auto& file : files) require_writable_file(file);
}

}  // namespace proofmass::cli
