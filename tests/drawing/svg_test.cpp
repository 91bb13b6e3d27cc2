// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "drawing/svg.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "support/markup.hpp"

namespace lanefuse {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(EscapeXml, LeavesNothingThatXmlWouldRead) {
  EXPECT_EQ(escape_xml(R"(<a href="x">Tom & 'Jerry'</a>)"),
            "&lt;a href=&quot;x&quot;&gt;Tom &amp; &#39;Jerry&#39;&lt;/a&gt;");
  EXPECT_EQ(escape_xml("one\ntwo\x01"), "one two ");
  EXPECT_EQ(escape_xml("Stra\xc3\x9f"
                       "e"),
            "Stra\xc3\x9f"
            "e");
}

TEST(SvgWriter, WritesNumbersShortly) {
  SvgWriter svg;
  svg.line({1, -0.01}, {2.25, 1e6}, "pen");
  EXPECT_EQ(svg.elements(), "<line x1=\"1\" y1=\"0\" x2=\"2.2\" y2=\"1000000\" class=\"pen\"/>\n");
}

TEST(SvgWriter, LeavesOutWhatHasNoPlace) {
  SvgWriter svg;
  svg.line({0, 0}, {kNan, 0}, "a");
  svg.circle({kInfinity, 0}, 2, "a");
  svg.text({0, kNan}, "lost", "a");
  svg.polygon(std::array{Pixel(0, 0), Pixel(1, kNan), Pixel(2, 2)}, "a");
  svg.polyline(std::array{Pixel(0, 0)}, "a");
  EXPECT_EQ(svg.elements(), "");
}

TEST(SvgWriter, BreaksAPolylineWhereItHasNoPlace) {
  SvgWriter svg;
  svg.polyline(std::array{Pixel(0, 0), Pixel(1, 0), Pixel(kNan, 0), Pixel(3, 0), Pixel(kNan, 1), Pixel(4, 0),
                          Pixel(5, 0)},
               "a");
  EXPECT_EQ(testing::occurrences(svg.elements(), "<polyline"), 2);
  EXPECT_FALSE(testing::prints_nan(svg.elements()));
}

TEST(Figure, StandsAloneWithItsStylesAndInlineWithout) {
  SvgWriter svg;
  svg.text({10, 10}, "a < b", "tick");
  const Figure figure{100, 50, "\"quoted\" & more", svg.elements()};
  const std::string alone = standalone_svg(figure);
  EXPECT_EQ(testing::malformed(alone), "");
  EXPECT_NE(alone.find("<style>"), std::string::npos);
  EXPECT_NE(alone.find("prefers-color-scheme:dark"), std::string::npos);
  EXPECT_TRUE(testing::addresses(alone).empty());
  EXPECT_EQ(testing::malformed(inline_svg(figure)), "");
  EXPECT_EQ(inline_svg(figure).find("<style>"), std::string::npos);
}

TEST(Malformed, FindsWhatItIsThereFor) {
  EXPECT_NE(testing::malformed("<a><b></a></b>"), "");
  EXPECT_NE(testing::malformed("<a>"), "");
  EXPECT_NE(testing::malformed("<a>1 < 2</a>"), "");
  EXPECT_NE(testing::malformed("<a>this & that</a>"), "");
  EXPECT_NE(testing::malformed("<a b=c></a>"), "");
  EXPECT_EQ(testing::malformed("<!DOCTYPE html>\n<a b=\"c\"><d/>&amp;</a>"), "");
}

}  // namespace
}  // namespace lanefuse
