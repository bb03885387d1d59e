// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/plot/svg.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "proofmass/report/plot/interactive.hpp"
#include "proofmass/report/plot/scale.hpp"
#include "support/text.hpp"

namespace proofmass {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Chart chart_of(Series series, bool log = false) {
  return {.id = "c",
          .title = {"a < b", "甲 < 乙"},
          .x = {},
          .y = {.label = {}, .log = log},
          .series = {std::move(series)}};
}

TEST(Scale, HasRoundTicksThatPeopleRead) {
  Scale plain(0.0, 100.0);
  plain.include(-1.0);
  plain.include(1.0);
  plain.finish(0.0);
  EXPECT_THAT(tick_texts(plain, plain.ticks()), ElementsAre("−1.0", "−0.5", "0.0", "0.5", "1.0"));
  EXPECT_DOUBLE_EQ(plain.place(0.0), 50.0);
  Scale log(0.0, 100.0, true);
  log.include(2e-6);
  log.include(-5.0);  // is not shown
  log.include(1e-3);
  log.finish();
  EXPECT_THAT(tick_texts(log, log.ticks()), ElementsAre("10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³"));
}

TEST(Scale, OfOneValueOrNoneIsFinite) {
  for (const double value : {kNan, 0.0, -3.0, 1e-300}) {
    Scale scale(0.0, 100.0);
    scale.include(value);
    scale.finish();
    EXPECT_TRUE(std::isfinite(scale.place(scale.shows(value) ? value : 0.0)));
    EXPECT_LT(scale.ticks().size(), 20U);
  }
}

TEST(Svg, DrawsOnePointForAllThatFallOnOnePlace) {
  Series dots{.name = {}, .x = {}, .y = {}, .mark = Mark::points};
  for (int k = 0; k < 1000; ++k) {
    dots.x.push_back(k % 10 + 1e-9 * k);
    dots.y.push_back(k % 10);
  }
  EXPECT_EQ(test::occurrences(render_svg(chart_of(dots)), "h0"), 10U);
}

TEST(Svg, BreaksALineWhereAValueHasNoPlace) {
  const std::string svg = render_svg(
      chart_of({.name = {}, .x = {0.0, 1.0, 2.0, 3.0, 4.0}, .y = {1.0, kNan, 10.0, 0.0, 100.0}}, true));
  const std::size_t at = svg.find("class=\"line s0\"");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(test::occurrences(svg.substr(at, svg.find("/>", at) - at), "M"), 3U);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Svg, KeepsThePeaksOfALongLine) {
  Series line{.name = {}, .x = {}, .y = {}};
  for (int k = 0; k < 100'000; ++k) {
    line.x.push_back(k);
    line.y.push_back(k == 54'321 ? 5.0 : k % 2 * 1.0);
  }
  const std::string svg = render_svg(chart_of(line));
  EXPECT_LT(svg.size(), 80'000U);
  Series lower = line;
  lower.y[54'321] = 1.0;
  lower.y.back() = 5.0;  // the same range
  EXPECT_NE(svg, render_svg(chart_of(lower)));
}

TEST(Svg, HasBothLanguagesInAPageAndOneInAFile) {
  const std::string page = render_svg(chart_of({.name = {"s", "系列"}, .x = {0.0, 1.0}, .y = {0.0, 1.0}}));
  EXPECT_THAT(page, HasSubstr("class=\"title en\">a &lt; b</text>"));
  EXPECT_THAT(page, HasSubstr("class=\"title zh\">甲 &lt; 乙</text>"));
  const std::string file =
      render_svg(chart_of({.name = {"s", "系列"}, .x = {0.0, 1.0}, .y = {0.0, 1.0}}), {.file = Language::zh});
  EXPECT_THAT(file, HasSubstr("甲"));
  EXPECT_THAT(file, Not(HasSubstr("a &lt; b")));
  EXPECT_THAT(file, HasSubstr("xmlns=\"http://www.w3.org/2000/svg\""));
}

TEST(Svg, DrawsEveryKindWithoutDividingByZero) {
  const std::vector<Drawing> drawings{
      Chart{.id = "c", .title = {}, .x = {}, .y = {}, .series = {}},
      HeatMap{.id = "h", .title = {}, .labels = {}, .values = {}},
      HeatMap{.id = "h", .title = {}, .labels = {"K0"}, .values = {1.0}},
      BoxPlot{.id = "b", .title = {}, .y = {}, .boxes = {}},
      BoxPlot{.id = "b", .title = {}, .y = {}, .boxes = {{.name = {}}}},
      SpacePlot{.id = "s", .title = {}, .axes = {}, .x = {}, .y = {}, .z = {}},
      SpacePlot{.id = "s", .title = {}, .axes = {}, .x = {0.0}, .y = {0.0}, .z = {0.0}},
      chart_of({.name = {}, .x = {0.0}, .y = {0.0}, .mark = Mark::steps}),
      chart_of({.name = {}, .x = {1.0, 2.0}, .y = {0.0, 1.0}, .mark = Mark::band, .high = {1.0, 2.0}})};
  for (const Drawing& drawing : drawings) {
    const std::string svg = render_svg(drawing);
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
    EXPECT_EQ(test::occurrences(svg, "<g "), test::occurrences(svg, "</g>"));
  }
}

TEST(InteractiveFigures, StoreAColumnOnceAndHoldNoMarkup) {
  InteractiveFigures figures;
  EXPECT_TRUE(figures.empty());
  figures.add(chart_of({.name = {"</script>", "甲"}, .x = {1.0, 2.0}, .y = {1.0, 2.0}}));
  figures.add(HeatMap{.id = "h", .title = {}, .labels = {}, .values = {}});  // stays a drawing
  const std::string json = figures.json();
  EXPECT_EQ(test::occurrences(json, "fAACAPwAAAEA="), 1U);  // 1.0f and 2.0f
  EXPECT_THAT(json, HasSubstr(R"("x":0,"y":0)"));
  EXPECT_THAT(json, Not(HasSubstr("<")));
  EXPECT_EQ(test::occurrences(json, "\"id\""), 1U);
}

}  // namespace
}  // namespace proofmass
