// SPDX-License-Identifier: Apache-2.0
#include "core/plot/svg_picture.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "core/color/srgb.h"
#include "core/image/image_io.h"
#include "core/plot/polar_plot.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const auto no_text = [](std::string_view, int) { return TextPicture(); };

LinePlot two_levels() {
  LinePlot plot;
  plot.x = {"angle of incidence, degrees", 0, 90, {0, 45, 90}};
  plot.left = {"F, luminance", 0, 1, {0, 0.5, 1}};
  plot.curves.push_back({{0, 90}, {0.25, 0.25}, "c1 bold", "a", false, false});
  plot.curves.push_back({{0, 90}, {0.75, 0.75}, "c2 dashed", "b", false, false});
  plot.zones = {{0, 45, "barely changes"}, {45, 90, "changes"}};
  return plot;
}

std::string color_at(const Image8& picture, int x, int y) {
  const auto at = picture.at(x, y);
  return hex({at[0], at[1], at[2]});
}

bool edge_is_empty(const Image8& picture, std::string_view background) {
  for (int x = 0; x < picture.width; ++x)
    if (color_at(picture, x, 0) != background || color_at(picture, x, picture.height - 1) != background)
      return false;
  for (int y = 0; y < picture.height; ++y)
    if (color_at(picture, 0, y) != background || color_at(picture, picture.width - 1, y) != background)
      return false;
  return true;
}

}  // namespace

TEST_CASE("a plot as pixels has its lines where the SVG has them, in their colours and with their gaps") {
  for (const bool dark : {false, true}) {
    const PlotColors& colors = plot_colors(dark);
    const Image8 picture = svg_picture(svg_file(two_levels(), dark), no_text);
    CHECK(picture.width == 920);
    CHECK(picture.height == 540);
    // The frame is 30 to 222 units high, two pixels each: 0.25 stands at 174, 0.75 at 78.
    int dashes = 0, whole = 0;
    for (int x = 100; x < 840; ++x) {
      whole += color_at(picture, x, 348) == colors.series[0];
      dashes += color_at(picture, x, 156) == colors.series[1];
    }
    CHECK(whole == 740);
    CHECK(dashes > 370);
    CHECK(dashes < 660);
    CHECK(color_at(picture, 200, 240) == colors.background);
    CHECK(color_at(picture, 700, 240) != colors.background);  // the second zone is shaded
    CHECK(edge_is_empty(picture, colors.background));
  }
}

TEST_CASE("an arc of a polar plot goes over the top, from rim to rim") {
  PolarPlot plot;
  plot.radial = {"f_r", 0, 1, {0, 1}};
  const Image8 picture = svg_picture(svg_file(plot, false), no_text);
  const std::string_view line = plot_colors(false).line, background = plot_colors(false).background;
  int top = 0;
  while (top < picture.height && color_at(picture, 460, top) == background) ++top;
  CHECK(top > 20);
  CHECK(top < 100);
  // It is flat there: beside the middle it lies in the next rows.
  int flat = 0;
  for (int row = top; row < top + 4; ++row) flat += color_at(picture, 440, row) == line;
  CHECK(flat >= 1);
}

TEST_CASE("the text of a plot is drawn whole, and the same each time") {
  const std::string file = svg_file(two_levels(), false);
  const Image8 picture = svg_picture(file, text_picture);
  CHECK(edge_is_empty(picture, "#ffffff"));
  CHECK(picture != svg_picture(file, no_text));
  CHECK(picture == svg_picture(file, text_picture));
  const TextPicture one = text_picture("F", 24), two = text_picture("FF <&", 24);
  CHECK(one.coverage.height > 14);
  CHECK(one.coverage.height < 24);
  CHECK(std::abs(one.top + one.coverage.height) <= 1);  // F stands on the base line
  CHECK(two.coverage.width > 2 * one.coverage.width);
  const Image blank = text_picture(" ", 24).coverage;
  CHECK(std::ranges::all_of(blank.values, [](float part) { return part == 0; }));
  // A degree sign is a ring behind the digits, as high as they are and with nothing within it.
  const TextPicture bare = text_picture("30", 24), degrees = text_picture("30\u00b0", 24);
  CHECK(degrees.coverage.width > bare.coverage.width + 5);
  CHECK(degrees.coverage.width < bare.coverage.width + 14);
  CHECK(degrees.top <= bare.top);
  CHECK(contains(error_of([] { (void)text_picture("\u00c5", 24); }), "beyond ASCII"));
}
