// SPDX-License-Identifier: Apache-2.0
// The only family of errors that the library throws. Failure of a computation (no convergence) is not an
// error: the result reports it, see Ending.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofmass/core/ending.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/message.hpp"

namespace proofmass {

enum class ErrorKind {
  internal,     // a defect of the library
  usage,        // an invalid option or argument
  bad_data,     // a file or record that cannot be used
  refused,      // the data cannot identify what was asked for
  interrupted,  // the caller asked to stop
};

// An option that may help, by its name in the tables of options ("on-rank-loss" with the value "drop"), or
// "terms". Programs say it in their own words: a flag, a keyword. An empty value leaves the value to the
// user.
struct Remedy {
  std::string option;
  std::string value;
  bool with_previous = false;  // helps together with the one before it only
};

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, Message message, std::vector<Remedy> remedies = {},
        std::vector<Finding> findings = {})
      : std::runtime_error(message.english()),
        kind_(kind),
        message_(std::move(message)),
        remedies_(std::move(remedies)),
        findings_(std::move(findings)) {}
  [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }
  // What what() says in English, as data; in the reader's language by report/text/messages.
  [[nodiscard]] const Message& message() const noexcept { return message_; }
  [[nodiscard]] const std::vector<Remedy>& remedies() const noexcept { return remedies_; }
  // What led to it, such as why each term is not identified; their sentences are in report/text.
  [[nodiscard]] const std::vector<Finding>& findings() const noexcept { return findings_; }
  // How the computation ended that is refused, if it was begun; its words are in report/text.
  [[nodiscard]] const std::vector<EndingPart>& ending() const noexcept { return ending_; }
  [[nodiscard]] Error with_ending(std::vector<EndingPart> ending) && {
    ending_ = std::move(ending);
    return std::move(*this);
  }

 private:
  ErrorKind kind_;
  Message message_;
  std::vector<Remedy> remedies_;
  std::vector<Finding> findings_;
  std::vector<EndingPart> ending_;
};

// The text for use in an error message: cut after `most` characters, unprintable bytes escaped.
[[nodiscard]] std::string excerpt(std::string_view text, std::size_t most = 60);

// The place of a fault in a file. Row 0 means the whole file. Rows count lines from 1 as an editor does,
// including header and comments. An empty column means the whole row. In a settings file the "column" is a
// key.
struct Place {
  std::string file;
  std::size_t row = 0;
  std::string column{};
  bool is_key = false;
};

// What stands where something else was expected: text of the file, shortened when it is longer than 60
// characters and its unprintable bytes escaped; or words about it, such as "no data rows".
struct FoundText {
  FoundText() = default;  // nothing to say of it
  // NOLINTBEGIN(google-explicit-constructor)
  FoundText(std::string_view text) : words(Message::verbatim(excerpt(text))) {}
  FoundText(const std::string& text) : FoundText(std::string_view(text)) {}
  FoundText(Message about) : words(std::move(about)) {}
  template <std::size_t size>
  // NOLINTNEXTLINE(cppcoreguidelines-avoid-c-arrays,modernize-avoid-c-arrays)
  FoundText(const char (&about)[size]) : words(about) {}
  // NOLINTEND(google-explicit-constructor)
  Message words{};
};

// "file:row: column 'Ai': found 'abc', expected a number". An empty `found` is left out.
[[nodiscard]] Error bad_data(const Place& place, const FoundText& found, const Message& expected,
                             std::vector<Remedy> remedies = {});

// Why the operating system refused, by its error number: "No such file or directory".
[[nodiscard]] Message system_reason(int error_number);

// "cannot open FILE: no such file or directory", by the operating system's error number.
[[nodiscard]] Error cannot_open(std::string_view file, int error_number);

[[nodiscard]] Error usage_error(const Message& message);
[[nodiscard]] Error refusal(const Message& message, std::vector<Remedy> remedies = {},
                            std::vector<Finding> findings = {});

// The process exit code: 1 internal, 2 usage, 3 bad data, 4 refused, 130 interrupted.
[[nodiscard]] int exit_code(ErrorKind kind) noexcept;

}  // namespace proofmass
