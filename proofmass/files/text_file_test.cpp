// SPDX-License-Identifier: Apache-2.0
#include "proofmass/files/text_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "proofmass/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace proofmass {
namespace {

std::string refusal_of(const std::filesystem::path& path, std::size_t most) {
  try {
    (void)read_text_file(path, "a plan", most);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    return error.what();
  }
  return "read without an error";
}

TEST(TextFile, ReadsEveryByte) {
  const test::TemporaryFolder folder;
  const std::string bytes = std::string(200'000, 'x') + '\0' + "end";
  std::ofstream(folder.path() / "a", std::ios::binary) << bytes;
  EXPECT_EQ(read_text_file(folder.path() / "a", "a plan", 1U << 20U), bytes);
}

TEST(TextFile, RefusesWhatItCannotRead) {
  using testing::HasSubstr;
  const test::TemporaryFolder folder;
  EXPECT_THAT(refusal_of(folder.path() / "none", 100),
              HasSubstr("cannot open " + (folder.path() / "none").string() + ": no such file"));
  EXPECT_THAT(refusal_of(folder.path(), 100), HasSubstr("a directory"));
  EXPECT_THAT(refusal_of("/dev/zero", 1U << 20U), HasSubstr("more than 1 MiB"));
}

}  // namespace
}  // namespace proofmass
