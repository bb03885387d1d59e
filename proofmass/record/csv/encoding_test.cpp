// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/encoding.hpp"

#include <gtest/gtest.h>

#include <string>

namespace proofmass {
namespace {

TEST(Encoding, IsKnownByManyNames) {
  EXPECT_EQ(find_encoding("utf-8"), Encoding::utf8);
  EXPECT_EQ(find_encoding("GBK"), Encoding::gb18030);
  EXPECT_EQ(find_encoding("gb2312"), Encoding::gb18030);
  EXPECT_EQ(find_encoding("CP1252"), Encoding::windows1252);
  EXPECT_EQ(find_encoding("ISO_8859-1"), Encoding::windows1252);
  EXPECT_FALSE(find_encoding("klingon"));
  for (const Encoding encoding :
       {Encoding::utf8, Encoding::utf16le, Encoding::utf16be, Encoding::gb18030, Encoding::windows1252}) {
    EXPECT_EQ(find_encoding(to_string(encoding)), encoding);
  }
}

TEST(Encoding, IsToldByAMarkOrByZeros) {
  using namespace std::string_literals;
  EXPECT_EQ(encoding_by_mark("\xEF\xBB\xBF"
                             "Ai"),
            Encoding::utf8);
  EXPECT_EQ(encoding_by_mark("\xFF\xFE"
                             "A\0"s),
            Encoding::utf16le);
  EXPECT_EQ(encoding_by_mark("\xFE\xFF\0A"s), Encoding::utf16be);
  EXPECT_EQ(encoding_by_mark("A\0i\0,\0E\0"s), Encoding::utf16le);
  EXPECT_EQ(encoding_by_mark("\0A\0i\0,\0E"s), Encoding::utf16be);
  EXPECT_FALSE(encoding_by_mark("Ai,E\n1,2\n"));
  EXPECT_FALSE(encoding_by_mark("Ai,E\n1,\0\n"s));
  EXPECT_FALSE(encoding_by_mark(""));
}

TEST(Encoding, IsToldByTheBytesBeyondAscii) {
  EXPECT_EQ(encoding_by_content("Ai[m/s\xC2\xB2]"), Encoding::utf8);
  // In GB18030 "\xB2]" would be a character too, which swallows the bracket.
  EXPECT_EQ(encoding_by_content("Ai[m/s\xB2],Ao[m/s\xB2],T[\xB0"
                                "C]"),
            Encoding::windows1252);
  EXPECT_EQ(encoding_by_content("E[\xB5V] Pr\xFC"
                                "fstand M\xFC"
                                "nchen"),
            Encoding::windows1252);
  EXPECT_EQ(encoding_by_content("Gr\xF6\xDF"
                                "e,Stra\xDF"
                                "e"),
            Encoding::windows1252);
  EXPECT_EQ(encoding_by_content("\xCA\xE4\xC8\xEB\xD6\xE1[g],\xCA\xE4\xB3\xF6[V]"), Encoding::gb18030);
}

TEST(Encoding, IsConvertedInPiecesOfAnyLength) {
  const std::string bytes = "\xCA\xE4\xB3\xF6[V]";
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    Decoder decoder(Encoding::gb18030);
    std::string text = decoder.decode(bytes.substr(0, cut)).value();
    text += decoder.decode(bytes.substr(cut)).value();
    EXPECT_EQ(text, "\u8F93\u51FA[V]") << cut;
    EXPECT_FALSE(decoder.incomplete());
  }
}

TEST(Encoding, RefusesBytesThatAreNoText) {
  EXPECT_FALSE(Decoder(Encoding::gb18030)
                   .decode("a\xFF\xFF"
                           "b"));
  EXPECT_FALSE(Decoder(Encoding::utf16le)
                   .decode(std::string("\x00\xDC"
                                       "a\0",
                                       4)));  // half a pair
  EXPECT_FALSE(Decoder(Encoding::windows1252).decode("\x81"));
  Decoder half(Encoding::gb18030);
  EXPECT_EQ(half.decode("a\xCA"), "a");
  EXPECT_TRUE(half.incomplete());
}

}  // namespace
}  // namespace proofmass
