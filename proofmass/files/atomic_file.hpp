// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

namespace proofmass {

// A file that appears under its name only when it is complete. Writing goes to a temporary file beside it,
// named "<file>.<number>.tmp"; commit() renames it into place, and without commit() the destructor removes
// it, so that a failure or an interruption leaves nothing that looks like a result, and a file that was there
// before stays. A symbolic link keeps pointing where it did. What is not a regular file (/dev/null, a pipe)
// is written directly. Errors are usage Errors that name the file and the operating system's reason.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  [[nodiscard]] std::ostream& stream() noexcept { return stream_; }
  // Everything has been written: makes sure that it is on its way to the disk. Nothing is visible yet.
  void close();
  // Closes if need be and makes the file visible. Call once.
  void commit();

 private:
  [[nodiscard]] bool direct() const noexcept { return temporary_.empty(); }
  std::filesystem::path path_;       // as the caller names it, for messages
  std::filesystem::path target_;     // symbolic links resolved
  std::filesystem::path temporary_;  // empty when written directly or committed
  std::ofstream stream_;
};

}  // namespace proofmass
