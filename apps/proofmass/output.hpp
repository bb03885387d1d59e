// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <iosfwd>
#include <list>
#include <string>
#include <string_view>

#include "proofmass/core/atomic_file.hpp"
#include "proofmass/report/terminal.hpp"

namespace proofmass::cli {

// Writes to standard output and flushes. Throws a usage Error when that fails, as on a full disk; that nobody
// reads any more is not a failure.
void print(std::string_view text);

// Colour on standard output: only on a terminal, and not when NO_COLOR is set (no-color.org).
[[nodiscard]] TerminalStyle terminal_style();

// Files that appear once every one of them is complete and standard output has taken its text; until then,
// none does.
class OutputFiles {
 public:
  // "-" is standard output, written by commit().
  void add(const std::filesystem::path& path, std::string_view text);
  // The same for long text, which is not held in memory when it goes to a file.
  void add(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
  void commit();

 private:
  std::list<AtomicFile> files_;
  std::string standard_output_;
};

// Throws a usage Error when an output would replace one of the inputs. "-" and "" are always well.
void require_other_file(const std::filesystem::path& output,
                        std::initializer_list<std::filesystem::path> inputs);

// Throws a usage Error when the folder that would hold the file is not there: better before a long
// computation than after it. "-" and "" are always well.
void require_folder_of(const std::filesystem::path& file);

}  // namespace proofmass::cli
