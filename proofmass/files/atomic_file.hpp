// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

namespace proofmass {

// A file that appears under its name only when it is complete. Writing goes to a temporary file beside it,
// named "<file>.<number>.tmp"; commit() renames it. Without commit() the destructor removes it. So a failure
// or an interruption leaves no partial result, and a file that existed before is unchanged. A symbolic link
// keeps its target. A target that is not a regular file (/dev/null, a pipe) is written directly. Errors are
// usage Errors with the file's name and the operating system's reason.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  [[nodiscard]] std::ostream& stream() noexcept { return stream_; }
  // Call when everything has been written: closes the file and reports a failure to write. The file is not
  // visible yet.
  void close();
  // Closes the file if necessary and makes it visible. Call once.
  void commit();

 private:
  [[nodiscard]] bool direct() const noexcept { return temporary_.empty(); }
  std::filesystem::path path_;       // as the caller wrote it, for messages
  std::filesystem::path target_;     // symbolic links resolved
  std::filesystem::path temporary_;  // empty when written directly or committed
  std::ofstream stream_;
};

}  // namespace proofmass
