// SPDX-License-Identifier: Apache-2.0
#include "app/demo/start_page.h"

#include <catch2/catch.hpp>

#include "tests/core/pages/sample_rows.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

Finding found() {
  Finding out;
  out.rule = "ETK101";
  out.slug = "f0-forbidden-zone";
  out.severity = Severity::error;
  out.file = "scene/<wall>.png";
  out.message = "F0 0.3";
  out.fix = "Fix it.";
  return out;
}

std::string page_of_samples(bool element = false) {
  static const std::vector<MaterialReport> reports = sample_reports();
  StartPageData data;
  data.library = reports;
  data.library_page = "f0.html";
  data.materials = {
      {"testium",
       "Testium & <co>",
       {{"measured", "png 1", 0, 0}, {"Schlick", "png 2", 2.345, 9.87}, {"F82", "png 3", 0.12, 0.5}},
       {{"Unreal", "Base Color: (R=1)"}, {"Hex", "#ffe49c"}}}};
  data.points = {{"Schlick", 0.4, 1, 0.1, 4}, {"exact <n, k>", 10, 0.01, 0.001, 0.1}};
  data.costs = "some machine";
  data.films = {"Titania <on> titanium",
                "thickness",
                "angle",
                {{"The truth", "", "png 6"}, {"glTF, honest", "\u0394E 26.5", "png 7"}}};
  data.before = {{"png 4", "wall.png", 512, 256}};
  data.after = {{"png 5", "page0", 256, 256}};
  data.texels_before = 262144;
  data.texels_after = 65536;
  data.verdict = "FAILED: 1 error in 1 file (0 clean).";
  data.findings = {{found(), {}}};
  data.cards = {{"f0.html", "F0", "All of it.", ""}};
  data.element = element;
  return start_page(data);
}

}  // namespace

TEST_CASE("the start page computes materials where the element is beside it, else it loads nothing") {
  CHECK(!contains(page_of_samples(), " src=\"etak"));
  const std::string page = page_of_samples(true);
  CHECK(count_of(page, "<script defer src=\"etak-element.js\">") == 1);
  CHECK(count_of(page, "<etak-material") == 4);
}

TEST_CASE("the start page shows spheres with their errors, values to copy, texels, findings and cards") {
  const std::string page = page_of_samples();
  CHECK(count_of(page, "class=\"balls\"") == 1);
  CHECK(contains(page, "<b>ΔE 2.35</b><br>worst 9.9"));
  CHECK(contains(page, "<b>ΔE 0.12</b><br>worst 0.5"));
  CHECK(contains(page, "<pre data-target=\"Unreal\">Base Color: (R=1)</pre>"));
  CHECK(contains(page, "262,144 texels; the pages have 65,536 (25\u00a0%)"));
  CHECK(contains(page, "ETK101 f0-forbidden-zone"));
  CHECK(contains(page, "<a href=\"f0.html\">"));
  CHECK(contains(page, "<a href=\"f0.html#m-testium\">"));  // of the zone plot
  CHECK(contains(page, "prefers-color-scheme: dark"));
  CHECK(contains(page, "<figcaption>Titania &lt;on&gt; titanium</figcaption>"));
  CHECK(contains(page, "<span>glTF, honest<b>\u0394E 26.5</b></span>"));
}

TEST_CASE("F82 is said to keep the colour of metals, and what an eye can tell has its citation") {
  const std::string page = page_of_samples();
  CHECK(contains(page, "F82, which keeps the colour of metals near the rim"));
  CHECK(contains(page, "of clear materials is by the exact form from F0"));
  CHECK(contains(page, "href=\"https://doi.org/10.1111/jerd.12149\""));
}

TEST_CASE("only a difference that can be seen is marked") {
  const std::string page = page_of_samples();
  CHECK(count_of(page, "<figure class=\"seen\">") == 1);
}

TEST_CASE("the start page loads nothing, and foreign text cannot become markup in it") {
  const std::string page = page_of_samples();
  for (const char* loader : {"<link", "@import", "<iframe", "src=\"http", "url(", "fetch("})
    CHECK_FALSE(contains(page, loader));
  CHECK(count_of(page, "src=\"") == count_of(page, "src=\"data:image/png;base64,"));
  CHECK(contains(page, "Testium &amp; &lt;co&gt;"));
  CHECK_FALSE(contains(page, "<wall>"));
  CHECK(page_of_samples() == page);
}

TEST_CASE("the chart has a dot, a name and a line for each way, inside of its square") {
  const StartPoint points[] = {{"fast", 0.4, 2, 0.5, 6}, {"slow", 20, 1e-5, 0, 1e-4}};
  const std::string chart = start_chart(points);
  CHECK(count_of(chart, "<circle") == 2);
  CHECK(contains(chart, ">fast</text>"));
  CHECK(contains(chart, ">slow</text>"));
  CHECK_FALSE(contains(chart, "nan"));
  CHECK_FALSE(contains(chart, "inf"));
  CHECK(start_chart({}).empty());
}
