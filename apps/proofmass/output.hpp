// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <iosfwd>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interrupts.hpp"
#include "proofmass/files/atomic_file.hpp"
#include "proofmass/report/terminal/terminal.hpp"

namespace proofmass::cli {

// Writes to standard output and flushes. Throws a usage Error when that fails, as on a full disk; that nobody
// reads any more is not a failure. Throws an Error of kind interrupted when asked to stop.
void print(std::string_view text);

// How many columns the terminal behind a file descriptor has; nothing where there is none, or it does not
// say.
[[nodiscard]] std::optional<std::size_t> terminal_columns(int descriptor);

// Colour on standard output: only on a terminal, and not when NO_COLOR is set (no-color.org). Lines are as
// long as the terminal is wide, 80 columns elsewhere, and of any length when `wide`.
[[nodiscard]] TerminalStyle terminal_style(bool wide, Language language = Language::en);

// Files that appear once every one of them is complete and standard output has taken its text; until then,
// none does. A failure or an interruption before that leaves neither temporary files nor new folders.
class OutputFiles {
 public:
  OutputFiles() = default;
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;
  // The folder, with those above it, unless it is there; gone again without a commit().
  void make_folder(const std::filesystem::path& path);
  // "-" is standard output, written by commit().
  void add(const std::filesystem::path& path, std::string_view text);
  // The same for long text, which is not held in memory when it goes to a file.
  void add(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
  // Throws an Error of kind interrupted when asked to stop before all is done.
  void commit();

 private:
  InterruptGuard guard_;
  std::vector<std::filesystem::path> new_folders_;  // outermost first
  std::list<AtomicFile> files_;
  std::string standard_output_;
};

// Throws a usage Error when an output would replace one of the inputs. "-" and "" are always well.
void require_other_file(const std::filesystem::path& output,
                        std::initializer_list<std::filesystem::path> inputs);

// Throws a usage Error when two outputs are one file, or two are standard output; "" is none.
void require_distinct_outputs(std::initializer_list<std::filesystem::path> outputs);

// Throws a usage Error when the folder that would hold the file is not there. "-" and "" are always well.
void require_folder_of(const std::filesystem::path& file);

// These two throw a usage Error when a file cannot be written, or files in and beside a folder that is made
// if need be: better before a long computation than after it. They try it and leave nothing behind; what is
// not a regular file, such as a pipe, is only asked for its permissions. "-" and "" are always well.
void require_writable_file(const std::filesystem::path& file);
void require_writable(const std::filesystem::path& folder,
                      std::initializer_list<std::filesystem::path> files);

}  // namespace proofmass::cli
