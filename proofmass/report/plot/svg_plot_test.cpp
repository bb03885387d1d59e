// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/plot/svg_plot.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace proofmass {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(SvgPlot, PlacesTheCornersOfTheDataOnTheCornersOfTheAxes) {
  const std::string svg = render_svg(
      {.title = "a < b & c", .x_label = "x", .y_label = "y", .series = {{"line", {0.0, 10.0}, {-1.0, 1.0}}}});
  EXPECT_THAT(svg, HasSubstr("M84.0 364.0L700.0 40.0"));
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(svg, HasSubstr(">0.5</text>"));
}

TEST(SvgPlot, LeavesOutWhatHasNoPlaceAndBreaksTheLineThere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string svg =
      render_svg({.title = {},
                  .x_label = {},
                  .y_label = {},
                  .log_y = true,
                  .series = {{"s", {0.0, 1.0, 2.0, 3.0, 4.0}, {1.0, nan, 10.0, 0.0, 100.0}}}});
  EXPECT_THAT(svg, HasSubstr("M84.0 364.0M392.0 202.0M700.0 40.0"));
  EXPECT_THAT(svg, HasSubstr("1e2"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(SvgPlot, DrawsNothingAndConstantsWithoutDividingByZero) {
  EXPECT_THAT(render_svg({}), Not(HasSubstr("nan")));
  const std::string svg =
      render_svg({.title = {}, .x_label = {}, .y_label = {}, .series = {{"c", {5.0}, {5.0}}}});
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

}  // namespace
}  // namespace proofmass
