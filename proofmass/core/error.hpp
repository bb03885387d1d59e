// SPDX-License-Identifier: Apache-2.0
// The one family of errors that the library throws. Numerical failure is not among them: it is data, see
// Ending.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace proofmass {

enum class ErrorKind {
  internal,     // a defect of ours
  usage,        // an option or argument that makes no sense
  bad_data,     // a file or record that cannot be used
  refused,      // the data cannot identify what was asked
  interrupted,  // the caller asked to stop
};

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

// Where in a file something was found. A row of 0 means the file as a whole; rows count lines from 1 as an
// editor does, header and comments included. An empty column means the whole row. What a file of settings
// calls a column is a key: `what` says the word.
struct Place {
  std::string file;
  std::size_t row = 0;
  std::string column;
  std::string_view what = "column";
};

// "file:row: column 'Ai': found 'abc', expected a number"; `found` longer than 60 characters is shortened and
// its unprintable bytes are shown escaped. An empty `found` is left out.
[[nodiscard]] Error bad_data(const Place& place, std::string_view found, std::string_view expected);

// The text as an error may quote it: cut after `most` characters, unprintable bytes escaped.
[[nodiscard]] std::string excerpt(std::string_view text, std::size_t most = 60);

[[nodiscard]] Error usage_error(const std::string& message);
[[nodiscard]] Error refusal(const std::string& message);

// The process exit code of the contract: 1 internal, 2 usage, 3 bad data, 4 refused, 130 interrupted.
[[nodiscard]] int exit_code(ErrorKind kind) noexcept;

}  // namespace proofmass
