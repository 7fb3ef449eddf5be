// SPDX-License-Identifier: Apache-2.0
#include "core/plot/svg_plot.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

LinePlot plot_of(PlotCurve curve) {
  LinePlot plot;
  plot.title = "a & b";
  plot.x = {"wavelength, nm", 360, 830, {400, 600, 800}};
  plot.left = {"n", 0, 2, {0, 1, 2}};
  plot.curves.push_back(std::move(curve));
  return plot;
}

std::string path_of(const std::string& text, const std::string& css_class) {
  const auto at = text.find("class=\"curve " + css_class + "\" d=\"");
  if (at == std::string::npos) return "";
  const auto first = text.find(" d=\"", at) + 4;
  return text.substr(first, text.find('"', first) - first);
}

std::ptrdiff_t points(const std::string& path) {
  return std::count(path.begin(), path.end(), ' ') / 2 + 1;
}

}  // namespace

TEST_CASE("axes end at round numbers and hold all values") {
  for (const auto& [least, most] :
       {std::pair{0.13, 1.66}, {1.4512, 1.4689}, {2e-9, 7e-8}, {0.0, 0.0}, {3.0, 3.0}, {-0.2, 5e4}}) {
    const PlotAxis axis = nice_axis("n", least, most);
    INFO(least << " " << most);
    CHECK(axis.least <= least);
    CHECK(axis.most >= most);
    CHECK(axis.most > axis.least);
    CHECK(axis.ticks.size() >= 2);
    CHECK(axis.ticks.size() <= 12);
  }
  CHECK(nice_axis("n", 0.13, 1.66).least == 0);
  CHECK(nice_axis("n", 1.4512, 1.4689).least > 1.4);
  CHECK(nice_axis("n", NAN, INFINITY).ticks.size() >= 2);
}

TEST_CASE("a straight line keeps two points, a noisy one at most 120") {
  PlotCurve straight{{}, {}, "s", "", false, false}, noisy{{}, {}, "z", "", false, false};
  for (int nm = 360; nm <= 830; ++nm) {
    straight.x.push_back(nm);
    straight.y.push_back((nm - 360) / 470.0);
    noisy.x.push_back(nm);
    noisy.y.push_back(1 + std::sin(nm * 1.7) * 0.9);
  }
  CHECK(points(path_of(svg(plot_of(straight)), "s")) == 2);
  const auto kept = points(path_of(svg(plot_of(noisy)), "z"));
  CHECK(kept > 20);
  CHECK(kept <= 120);
}

TEST_CASE("a peak one nanometre wide survives the thinning") {
  PlotCurve curve{{}, {}, "p", "", false, false};
  for (int nm = 360; nm <= 830; ++nm) {
    curve.x.push_back(nm);
    curve.y.push_back(nm == 600 ? 2 : 0.5);
  }
  CHECK(contains(path_of(svg(plot_of(curve)), "p"), " 30 "));  // the top of the plot
}

TEST_CASE("NaN breaks a line and one point alone is a dot") {
  const std::string broken =
      path_of(svg(plot_of({{400, 410, 420, 430, 440}, {1, 1.5, NAN, 1, 1.5}, "b", "", false, false})), "b");
  CHECK(std::count(broken.begin(), broken.end(), 'M') == 2);
  CHECK(contains(path_of(svg(plot_of({{550}, {1}, "one", "", false, false})), "one"), "h0"));
  CHECK(path_of(svg(plot_of({{550}, {NAN}, "none", "", false, false})), "none").empty());
}

TEST_CASE("a plot carries title, labels and ticks, escaped") {
  const std::string text = svg(plot_of({{400, 700}, {1, 1}, "c", "x < y", false, false}));
  CHECK(contains(text, "<title>a &amp; b</title>"));
  CHECK(contains(text, "<title>x &lt; y</title>"));
  CHECK(contains(text, "wavelength, nm"));
  CHECK(contains(text, ">600</text>"));
}

TEST_CASE("tick numbers show what tells them apart") {
  const auto text_of = [](double least, double most) {
    LinePlot plot = plot_of({{400, 700}, {least, most}, "c", "", false, false});
    plot.left = nice_axis("n", least, most);
    return svg(plot);
  };
  CHECK(contains(text_of(1.000276, 1.000284), ">1.000278</text>"));
  CHECK(contains(text_of(0, 1e-7), ">2e-8</text>"));
  CHECK(contains(text_of(0, 3e6), ">1.0e6</text>"));
  CHECK(contains(text_of(0.1, 0.5), ">0.1</text>"));
}
