// SPDX-License-Identifier: Apache-2.0
#include "proofmass/files/atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

namespace fs = std::filesystem;

Error write_error(const fs::path& path, int os_error) {
  // The C++ standard does not guarantee that streams set errno.
  const Message reason = os_error == 0 ? Message("output error") : system_reason(os_error);
  return usage_error(message("cannot write '{}': {}", path.string(), reason));
}

// Creates a new file and returns its name. Permissions are the user's default.
fs::path create_beside(const fs::path& target, const fs::path& path) {
  constexpr int kAttempts = 1000;
  for (int number = 1; number <= kAttempts; ++number) {
    fs::path candidate = target.string() + "." + std::to_string(number) + ".tmp";
    errno = 0;
    std::FILE* const file = std::fopen(candidate.c_str(), "wbx");
    if (file != nullptr) {
      std::fclose(file);
      return candidate;
    }
    if (errno != EEXIST) throw write_error(path, errno);
  }
  throw write_error(path, EEXIST);
}

fs::path resolved(const fs::path& path) {
  std::error_code failure;
  const fs::path target = fs::weakly_canonical(path, failure);
  return failure ? path : target;
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : path_(path), target_(path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (path.empty() || !path.has_filename()) throw write_error(path, EINVAL);
  if (fs::is_directory(status)) throw write_error(path, EISDIR);
  const bool special = fs::exists(status) && !fs::is_regular_file(status);
  if (!special) {
    target_ = resolved(path);
    temporary_ = create_beside(target_, path);
  }
  errno = 0;
  stream_.open(special ? target_ : temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_) throw write_error(path, errno);
}

AtomicFile::~AtomicFile() {
  stream_.close();
  if (direct()) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void AtomicFile::close() {
  if (!stream_.is_open()) return;
  errno = 0;
  stream_.close();
  if (!stream_) throw write_error(path_, errno);
}

void AtomicFile::commit() {
  close();
  if (direct()) return;
  std::error_code failure;
  fs::rename(temporary_, target_, failure);
  if (failure) throw write_error(path_, failure.value());
  temporary_.clear();
}

}  // namespace proofmass
