// SPDX-License-Identifier: Apache-2.0
// Every error that the sources make in Chinese, with the same values.
#include "proofmass/report/text/messages/message_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/core/nearest.hpp"
#include "proofmass/report/text/messages/zh_internal.hpp"
#include "support/message_patterns.hpp"

namespace proofmass {
namespace {

std::vector<ChineseMessage> all_entries() {
  std::vector<ChineseMessage> all;
  for (const auto& some : {chinese_core_messages(), chinese_record_messages(), chinese_stand_messages(),
                           chinese_identify_messages(), chinese_pipeline_messages(),
                           chinese_report_messages(), chinese_program_messages()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::size_t places_in(std::string_view words) {
  std::size_t count = 0;
  for (MessagePlace place = next_place(words, 0); place.found(); place = next_place(words, place.end))
    ++count;
  return count;
}

TEST(ChineseMessages, AreThereForAllThatTheSourcesSay) {
  const std::set<std::string> patterns = test::message_patterns();
  EXPECT_GT(patterns.size(), 200U);
  for (const std::string& pattern : patterns)
    EXPECT_FALSE(chinese_words(pattern).empty()) << "no Chinese for: " << pattern;
}

TEST(ChineseMessages, AreLookedForWhereverASourceMakesOne) {
  const std::vector<std::string> arguments = test::literal_arguments(R"({.file = "f"}, "a {}"
 "\"b", f("c"), x ? "d" : "e", ')', "g"); h("i"))");
  const std::vector<std::string> expected{"", "a {}\"b", "", "", "", "g"};
  EXPECT_EQ(arguments, expected);
  const test::MessageTakers takers = test::message_takers(
      {"Error bad(const Place& place, const FoundText& found, const Message& expected,\n  int k = 0);",
       "const auto fail = [&](const Message& what) {"});
  EXPECT_EQ(takers.at("bad"), (std::set<std::size_t>{1, 2}));
  EXPECT_EQ(takers.at("fail"), std::set<std::size_t>{0});
}

TEST(ChineseMessages, AreSaidSomewhereAndOnce) {
  const std::set<std::string> patterns = test::message_patterns();
  std::set<std::string_view> seen;
  for (const ChineseMessage& entry : all_entries()) {
    EXPECT_TRUE(patterns.contains(std::string(entry.english))) << "nothing says: " << entry.english;
    EXPECT_TRUE(seen.insert(entry.english).second) << "twice: " << entry.english;
  }
}

TEST(ChineseMessages, HaveEachValueInItsPlace) {
  for (const ChineseMessage& entry : all_entries()) {
    SCOPED_TRACE(entry.english);
    std::vector<std::string> values;
    for (std::size_t k = 0; k < places_in(entry.english); ++k)
      values.push_back("<" + std::to_string(k) + ">");
    const std::string said = with_values(entry.chinese, values);
    for (const std::string& value : values) EXPECT_NE(said.find(value), std::string::npos) << value;
    EXPECT_EQ(said.find_first_of("{}"), std::string::npos) << said;
    EXPECT_EQ(places_in(entry.chinese), values.size());
    EXPECT_EQ(said.find("  "), std::string::npos) << said;
    const bool symbolic = entry.english.find_first_of("abcdefghijklmnopqrstuvwxyz") == std::string_view::npos;
    const auto has_chinese = [](std::string_view text) {
      return std::any_of(text.begin(), text.end(), [](char c) { return c < 0; });
    };
    EXPECT_TRUE(symbolic || has_chinese(entry.chinese)) << entry.chinese;
  }
}

TEST(ChineseMessages, SayWhyTheSystemRefused) {
  for (const int number : {ENOENT, EACCES, EISDIR, ENOTDIR, ENAMETOOLONG, EIO, EPERM, EMFILE, ELOOP, ENXIO}) {
    EXPECT_FALSE(chinese_words(system_reason(number).words()).empty()) << system_reason(number).words();
    const Error error = cannot_open("a.csv", number);
    EXPECT_FALSE(chinese_words(error.message().values().back().words()).empty()) << error.what();
  }
  for (const int number : {EEXIST, ENOSPC, EDQUOT, EFBIG, EROFS, EINVAL, EBUSY, ETXTBSY, EPIPE, EBADF})
    EXPECT_FALSE(chinese_words(system_reason(number).words()).empty()) << system_reason(number).words();
  for (const ChineseMessage& entry : chinese_system_messages()) {
    EXPECT_FALSE(entry.chinese.empty());
    EXPECT_EQ(places_in(entry.english), 0U);
  }
}

TEST(ChineseMessages, HaveThePlaceFirstAndFilesAsTheyAre) {
  const Error number =
      bad_data({.file = "a{0}.csv", .row = 7, .column = "Ai"}, std::string("x{}\x01"), "a number");
  EXPECT_STREQ(number.what(), "a{0}.csv:7: column 'Ai': found 'x{}\\x01', expected a number");
  EXPECT_EQ(message_text(number.message(), Language::en), number.what());
  EXPECT_EQ(message_text(number.message(), Language::zh),
            "a{0}.csv 第 7 行：列 'Ai'：实为 'x{}\\x01'，应为数值");
  EXPECT_EQ(message_text(cannot_open("b.csv", ENOENT).message(), Language::zh),
            "不能打开 b.csv：没有该文件或文件夹");
  constexpr std::array<std::string_view, 2> kNames{"ols", "tls"};
  EXPECT_EQ(message_text(message("unknown verb '{}', expected one of {}{}", "olz", "ols, tls",
                                 did_you_mean("olz", kNames)),
                         Language::zh),
            "未知的命令 'olz'，应为下列之一：ols, tls；是否想写 ols？");
}

TEST(ChineseMessages, AreInEnglishWhereThereAreNone) {
  EXPECT_EQ(message_text(Message::foreign("no entry of this"), Language::zh), "no entry of this");
  EXPECT_EQ(message_text({}, Language::zh), "");
}

}  // namespace
}  // namespace proofmass
