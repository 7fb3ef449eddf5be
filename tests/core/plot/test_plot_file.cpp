// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <cmath>

#include "core/material/library.h"
#include "core/pages/material_plots.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

LinePlot small() {
  LinePlot plot;
  plot.title = "a & b";
  plot.x = {"wavelength, nm", 0, 10, {0, 5, 10}};
  plot.left = {"n", 0, 2, {0, 1, 2}};
  plot.curves.push_back({{0, 1, 3}, {1, NAN, 2}, "c1 bold", "n", false, false});
  plot.curves.push_back({{1, 2}, {0.5, 0.25}, "c2 dashed", "k, \"x\"", false, false});
  plot.keys = {{"c1 bold", "n"}, {"c2 dashed", "k"}};
  return plot;
}

}  // namespace

TEST_CASE("a plot as CSV has a row per x and an empty field where a curve has no value") {
  CHECK(csv(small()) ==
        "\"wavelength, nm\",n,\"k, \"\"x\"\"\"\n"
        "0,1,\n"
        "1,,0.5\n"
        "2,,0.25\n"
        "3,2,\n");
}

TEST_CASE("values between points are linear, none outside or where a curve is broken") {
  const LinePlot plot = small();
  CHECK(value_at(plot.curves[1], 1.5) == Approx(0.375));
  CHECK(value_at(plot.curves[1], 1) == 0.5);
  CHECK(value_at(plot.curves[1], 2) == 0.25);
  CHECK(std::isnan(value_at(plot.curves[1], 2.1)));
  CHECK(std::isnan(value_at(plot.curves[0], 0.5)));
  CHECK(std::isnan(value_at(PlotCurve{}, 0)));
}

TEST_CASE("an SVG file stands by itself: namespace, colours written out, legend") {
  for (const bool dark : {false, true}) {
    const std::string text = svg_file(small(), dark);
    CHECK(text.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    CHECK(text.ends_with("</svg>\n"));
    CHECK(count_of(text, "<svg") == 1);
    CHECK(count_of(text, "<title>a &amp; b</title>") == 1);
    CHECK(!contains(text, "var(--"));
    CHECK(contains(text, plot_colors(dark).background));
    CHECK(count_of(text, "class=\"curve c2 dashed\"") == 2);  // curve and legend
  }
}

TEST_CASE("a long legend takes rows and moves the plot down") {
  LinePlot plot = small();
  const std::string one = svg_file(plot, false);
  for (int i = 0; i < 6; ++i) plot.keys.push_back({"c3", "a rather long entry of a legend"});
  const std::string more = svg_file(plot, false);
  CHECK(contains(one, "translate(0 25.0)"));
  CHECK(!contains(more, "translate(0 25.0)"));
}

TEST_CASE("the classes of a curve are its colour, width and dashes") {
  CHECK(plot_style("c3 bold").color == 2);
  CHECK(plot_style("c3 bold").bold);
  CHECK(plot_style("bold c9 dashdot").color == 8);
  CHECK(plot_style("bold c9 dashdot").dash == PlotStyle::Dash::dashdot);
  CHECK(plot_style("c2 dots").dots);
  CHECK(plot_style("").color == 0);
}

TEST_CASE("polar points: the normal is up, the viewer's side right, the rim is the axis's end") {
  PolarPlot plot;
  plot.radial = radial_axis("f_r", 3.7, RadialScale::linear);
  CHECK(plot.radial.most >= 3.7);
  const PolarPoint up = polar_point(plot, 0, plot.radial.most);
  CHECK(up.x == Approx(0).margin(1e-15));
  CHECK(up.y == Approx(1));
  const PolarPoint right = polar_point(plot, 90, plot.radial.most);
  CHECK(right.x == Approx(1));
  CHECK(polar_radius(plot, plot.radial.most / 2) == Approx(0.5));
  CHECK(polar_radius(plot, -1) == 0);
  CHECK(polar_radius(plot, 1e9) == 1);
  CHECK(polar_radius(plot, NAN) == 0);
  plot.scale = RadialScale::logarithmic;
  plot.radial = radial_axis("f_r", 730, plot.scale);
  CHECK(plot.radial.most == Approx(1000));
  CHECK(plot.radial.least == Approx(0.1));
  CHECK(polar_radius(plot, 10) == Approx(0.5));
  CHECK(radial_text(plot, 0.1) == "0.1");
  CHECK(radial_text(plot, 1000) == "1000");
  CHECK(polar_radius(plot, 0) == 0);
}

TEST_CASE("every material's plots are drawn, whatever its data are") {
  const MaterialLibrary library = MaterialLibrary::builtin();
  const F0Options options;
  for (std::size_t i = 0; i < library.ids().size(); i += 7) {
    const Material material = library.at(i);
    INFO(material.id);
    const Optics& optics = material.preferred_dataset().optics;
    const OpticsCurves curves = curves_of(optics, options);
    for (const LinePlot& plot :
         {index_plot(material.name, curves),
          reflectance_plot(material.name, curves, options.viewing.observer),
          angle_plot(material.name, angle_curves(optics, options, material.id, 5), PlotChannel::luminance)}) {
      CHECK(!plot.description.empty());
      for (const PlotCurve& curve : plot.curves) CHECK(curve.x.size() == curve.y.size());
      CHECK(contains(svg_file(plot, true), "</svg>"));
    }
  }
}

TEST_CASE("the plot over angle tells error and time of every form") {
  const Material gold = *MaterialLibrary::builtin().find("gold");
  AngleCurves curves = angle_curves(gold.preferred_dataset().optics, {}, "gold");
  for (AngleCurve& form : curves.forms) form.ns = 1.25;
  curves.exact_ns = 2500;
  const LinePlot plot = angle_plot("Gold", curves, PlotChannel::blue);
  REQUIRE(plot.keys.size() == 6);
  CHECK(plot.keys[0].text == "exact, 471 wavelengths, 2.5 µs");
  CHECK(contains(plot.keys[1].text, "Schlick: error 0.0"));
  CHECK(contains(plot.keys[1].text, "1.2 ns"));
  CHECK(contains(plot.left.label, "blue"));
}
