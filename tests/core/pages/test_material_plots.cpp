// SPDX-License-Identifier: Apache-2.0
#include "core/pages/material_plots.h"

#include <catch2/catch.hpp>
#include <set>

#include "core/base/error.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::vector<ColorCurve> many(std::size_t count, const Vec3& color) {
  return std::vector<ColorCurve>(count, {"a", {0, 90}, {color, color}});
}

constexpr PlotChannel rgb[] = {PlotChannel::red, PlotChannel::green, PlotChannel::blue},
                      luminance[] = {PlotChannel::luminance};

std::set<std::string> styles(const LinePlot& plot) {
  std::set<std::string> out;
  for (const PlotCurve& each : plot.curves) out.insert(each.css_class);
  return out;
}

}  // namespace

TEST_CASE("curves of one plot can be told apart, and more than that are refused") {
  CHECK(styles(curves_plot(CurveKind::fresnel, many(24, {1, 0, 0}), luminance, 0)).size() == 24);
  CHECK(styles(curves_plot(CurveKind::fresnel, many(4, {1, 0, 0}), rgb, 0)).size() == 12);
  CHECK_THROWS_AS(curves_plot(CurveKind::fresnel, many(25, {1, 0, 0}), luminance, 0), Error);
  CHECK_THROWS_AS(curves_plot(CurveKind::fresnel, many(5, {1, 0, 0}), rgb, 0), Error);
}

TEST_CASE("a curve without colour is drawn once, as it is") {
  const LinePlot plot = curves_plot(CurveKind::distribution, many(1, {0.3, 0.3, 0.3}), rgb, 0);
  REQUIRE(plot.curves.size() == 1);
  CHECK(plot.curves[0].y[0] == 0.3);
  CHECK(plot.left.label == "D, 1/sr");
  CHECK(curves_plot(CurveKind::lobe, many(1, {0.3, 0.3, 0.3}), luminance, 0).curves[0].y[0] == 0.3);
}

TEST_CASE("plots of F alone have Hoffman's zones, which meet at 45 and 75 degrees") {
  const LinePlot plot = curves_plot(CurveKind::fresnel, many(1, {0.1, 0.2, 0.3}), luminance, 0);
  REQUIRE(plot.zones.size() == 3);
  CHECK(plot.zones[0].last == 45);
  CHECK(plot.zones[1].first == 45);
  CHECK(plot.zones[1].last == 75);
  CHECK(plot.zones[2].first == 75);
  CHECK(count_of(svg_file(plot, false), "fill-opacity") == 3);
  CHECK(plot.left.most == 1);
  CHECK(curves_plot(CurveKind::masking, many(1, {1, 1, 1}), luminance, 45).zones.empty());
}
