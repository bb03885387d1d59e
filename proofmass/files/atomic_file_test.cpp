// SPDX-License-Identifier: Apache-2.0
#include "proofmass/files/atomic_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "proofmass/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace proofmass {
namespace {

using test::read_file;
using test::TemporaryFolder;
using Names = std::vector<std::string>;

TEST(AtomicFile, AppearsOnCommitAlone) {
  const TemporaryFolder folder;
  AtomicFile file(folder.path() / "result.json");
  file.stream() << "content";
  file.stream().flush();
  ASSERT_EQ(folder.names().size(), 1U);
  EXPECT_TRUE(folder.names()[0].ends_with(".tmp")) << folder.names()[0];
  file.commit();
  EXPECT_EQ(folder.names(), Names{"result.json"});
  EXPECT_EQ(read_file(folder.path() / "result.json"), "content");
}

TEST(AtomicFile, WithoutCommitLeavesWhatWasThere) {
  const TemporaryFolder folder;
  const auto path = folder.write("result.json", "old");
  { AtomicFile(path).stream() << "half"; }
  EXPECT_EQ(folder.names(), Names{"result.json"});
  EXPECT_EQ(read_file(path), "old");
  {
    AtomicFile file(path);
    file.stream() << "new";
    file.commit();
  }
  EXPECT_EQ(read_file(path), "new");
}

TEST(AtomicFile, TwoWritersDoNotMeet) {
  const TemporaryFolder folder;
  AtomicFile first(folder.path() / "a");
  AtomicFile second(folder.path() / "a");
  first.stream() << "first";
  second.stream() << "second";
  second.commit();
  first.commit();
  EXPECT_EQ(folder.names(), Names{"a"});
  EXPECT_EQ(read_file(folder.path() / "a"), "first");
}

TEST(AtomicFile, WritesThroughALink) {
  const TemporaryFolder folder;
  const auto target = folder.write("target", "old");
  std::filesystem::create_symlink("target", folder.path() / "link");
  AtomicFile file(folder.path() / "link");
  file.stream() << "new";
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
  EXPECT_EQ(read_file(target), "new");
}

TEST(AtomicFile, LeavesDevicesInPlace) {
  AtomicFile file("/dev/null");
  file.stream() << "gone";
  file.commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

void expect_unwritable(const std::filesystem::path& path, const std::string& reason) {
  try {
    AtomicFile file(path);
    file.stream() << "content";
    file.commit();
    FAIL() << "wrote " << path;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    const std::string message = error.what();
    EXPECT_NE(message.find("'" + path.string() + "'"), std::string::npos) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
  }
}

TEST(AtomicFile, ErrorsNameTheFileAndTheReason) {
  const TemporaryFolder folder;
  expect_unwritable(folder.path() / "missing" / "result.json", "No such file or directory");
  expect_unwritable(folder.path(), "Is a directory");
  expect_unwritable(folder.write("file", "") / "below", "Not a directory");
  if (std::filesystem::exists("/dev/full")) expect_unwritable("/dev/full", "No space left on device");
  EXPECT_EQ(folder.names(), Names{"file"});
}

}  // namespace
}  // namespace proofmass
