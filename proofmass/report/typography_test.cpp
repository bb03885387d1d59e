// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/typography.hpp"

#include <gtest/gtest.h>

#include "proofmass/report/base64.hpp"
#include "proofmass/report/shown_unit.hpp"
#include "proofmass/report/xml_text.hpp"

namespace proofmass {
namespace {

TEST(Typography, PrintsNumbersAndUnitsAsTheSiBrochureDoes) {
  EXPECT_EQ(typeset("-1.5e-06"), "−1.5 × 10⁻⁶");
  EXPECT_EQ(typeset("2e+16"), "2 × 10¹⁶");
  EXPECT_EQ(typeset("1 - 2.2e-14"), "1 − 2.2 × 10⁻¹⁴");
  EXPECT_EQ(typeset("leave-one-out of a 3-7-1 network, 2026-11-28"),
            "leave-one-out of a 3-7-1 network, 2026-11-28");
  EXPECT_EQ(typeset("(1.30617 ± 0.00022)e-05"), "(1.30617 ± 0.00022) × 10⁻⁵");
  EXPECT_EQ(typeset("0.25"), "0.25");
  EXPECT_EQ(typeset("[-1.5e-06, 2.e+08]"), "[−1.5 × 10⁻⁶, 2. × 10⁸]");
  EXPECT_EQ(typeset("trainlm"), "trainlm");  // an e that is no exponent
  EXPECT_EQ(typeset("infinite"), "infinite");
  EXPECT_EQ(typeset_unit("m/s^2"), "m/s²");
  EXPECT_EQ(typeset_unit("ug"), "µg");
  EXPECT_EQ(typeset_unit("mA/g^3"), "mA/g³");
  EXPECT_EQ(squared_unit("ug"), "µg²");
  EXPECT_EQ(squared_unit("m/s^2"), "(m/s²)²");
}

TEST(ShownUnit, LeavesNumbersThatPeopleRead) {
  const auto shown = [](const Unit& unit, double largest) {
    const ShownUnit made = shown_unit(unit, largest);
    return std::pair{made.symbol, made.factor};
  };
  const Unit g;
  EXPECT_EQ(shown(g, 3e-6), (std::pair{std::string("µg"), 1e6}));
  EXPECT_EQ(shown(g, 18.0), (std::pair{std::string("g"), 1.0}));
  EXPECT_EQ(shown(g, 0.0), (std::pair{std::string("g"), 1.0}));
  const Unit metric = *find_unit("m/s^2");
  EXPECT_EQ(shown_unit(metric, 1e-3 / 9.80665).symbol, "mm/s²");
  const Unit milliampere = *find_unit("mA");
  EXPECT_EQ(shown_unit(milliampere, 2e-4).symbol, "µA");
  EXPECT_EQ(shown_unit(*find_unit("count"), 2e-4).symbol, "10⁻⁶ counts");
}

TEST(XmlText, LeavesNothingThatAPageWouldTakeForMarkup) {
  EXPECT_EQ(xml_escaped("<b a=\"1\" c='2'>&"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
  EXPECT_EQ(xml_escaped(std::string_view("a\0b\x01\n\xff中", 9)), "a\uFFFDb\uFFFD\n\uFFFD中");
}

TEST(Base64, IsThatOfTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace proofmass
