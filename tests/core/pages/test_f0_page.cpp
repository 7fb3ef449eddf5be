// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <set>

#include "tests/core/pages/sample_rows.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

std::string page() {
  return f0_page(sample_reports(), {});
}

std::string without(std::string text, const std::string& first, const std::string& last) {
  for (std::size_t at; (at = text.find(first)) != std::string::npos;)
    text.erase(at, text.find(last, at) + last.size() - at);
  return text;
}

// Reads tags one after the other and matches those that close with those that opened; "" when all fit.
std::string unbalanced(const std::string& html) {
  static const std::set<std::string> open_only{"!DOCTYPE", "meta", "br"};
  std::vector<std::string> open;
  for (std::size_t at = 0; (at = html.find_first_of("<>", at)) != std::string::npos;) {
    if (html[at] == '>') return "stray > before " + html.substr(at, 40);
    std::size_t end = at + 1;
    for (bool quoted = false; end < html.size() && (quoted || html[end] != '>'); ++end) {
      if (html[end] == '"') quoted = !quoted;
      if (html[end] == '<') return "stray < in " + html.substr(at, 40);
    }
    const bool closes = html[at + 1] == '/';
    const std::size_t first = at + (closes ? 2 : 1);
    const std::string name = html.substr(first, html.find_first_of(" />\n", first) - first);
    if (closes) {
      if (open.empty() || open.back() != name)
        return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    } else if (html[end - 1] != '/' && !open_only.contains(name)) {
      open.push_back(name);
    }
    at = end + 1;
  }
  return open.empty() ? "" : open.back() + " is left open";
}

// What stands between every `first` and the next `last`.
std::multiset<std::string> all(const std::string& html, const std::string& first,
                               const std::string& last = "\"") {
  std::multiset<std::string> found;
  for (std::size_t at = 0; (at = html.find(first, at)) != std::string::npos;) {
    at += first.size();
    found.insert(html.substr(at, html.find(last, at) - at));
  }
  return found;
}

}  // namespace

TEST_CASE("the F0 page loads nothing from outside") {
  const std::string html = page();
  for (const char* loader :
       {"src=", "srcset", "<link", "@import", "<iframe", "<object", "<embed", "fetch(", "XMLHttpRequest"})
    CHECK_FALSE(contains(html, loader));
  for (const std::string& target : all(html, "url(", ")")) CHECK(target.starts_with("#"));
  // What is left of the web are links to read.
  const auto addresses = all(html, "=\"http");
  CHECK(addresses.size() == all(html, "<a href=\"http").size());
  CHECK(addresses.size() > 0);
}

TEST_CASE("the F0 page is well-formed") {
  CHECK(unbalanced(without(without(page(), "<style>", "</style>"), "<script>", "</script>")) == "");
  CHECK(unbalanced("<p><b></p></b>") != "");
}

TEST_CASE("every link inside the F0 page has its target, and every id is there once") {
  const std::string html = page();
  const auto ids = all(html, " id=\"");
  for (const std::string& id : ids) CHECK(ids.count(id) == 1);
  const auto links = all(html, "href=\"#");
  CHECK(links.size() > 10);
  for (const std::string& link : links) {
    INFO(link);
    CHECK(ids.count(link) == 1);
  }
  CHECK(ids.count("m-testium") == 1);
  CHECK(ids.count("class-metal") == 1);
}

TEST_CASE("foreign text cannot become markup in the F0 page") {
  const std::string html = page();
  CHECK(contains(html, "Testium &amp; &quot;friends&quot; &lt;β&gt;"));
  CHECK(contains(html, "evaporated &lt;film&gt;"));
  CHECK(contains(html, "no &lt;visible&gt; data"));
  CHECK_FALSE(contains(html, "<film>"));
}

TEST_CASE("the F0 page shows policy, swatches, spread, sources and the reason of every refusal") {
  const std::string html = page();
  CHECK(contains(html, "illuminant D65"));
  CHECK(contains(html, "background:" + hex(gold_result().srgb8)));
  CHECK(contains(html, "0.9000–1.0428"));
  CHECK(contains(html, "Spread over 2 datasets"));
  CHECK(contains(html, "<a href=\"https://doi.org/10.1000/x\">doi:10.1000/x</a>"));
  CHECK(contains(html, "293.15 K"));
  CHECK(contains(html, "one row"));
  CHECK(contains(html, "out-of-gamut r+0.0428"));
  CHECK(contains(html, "prefers-color-scheme: dark"));
}

TEST_CASE(
    "every F0 of the page has a ball and values that a click copies, and the script sorts over classes") {
  const std::string html = page();
  const auto balls = all(html, "class=\"ball\" style=\"background:");
  // In the table and on the card: the metal, whose F changes with the angle, and the surface, which is even.
  CHECK(balls.size() == 4);
  CHECK(all(html, "class=\"ball\" style=\"background:radial-gradient(closest-side").size() == 2);
  CHECK(balls.count(hex(surface_result({0.8, 0.79, 0.7}).srgb8)) == 2);
  CHECK(all(html, "data-copy=\"").count(hex(gold_result().srgb8)) >= 2);
  CHECK(all(html, "data-class=\"").size() == 3);
  CHECK(contains(html, "flat.append"));
}

TEST_CASE("every plot of the F0 page has a title for those who cannot see it") {
  const std::string html = page();
  const auto plots = all(html, "role=\"img\"><title>", "</title>");
  // The strip; n, k and R of the metal; R of the surface; nothing of the one without data.
  CHECK(plots.size() == 4);
  for (const std::string& title : plots) CHECK(title.size() > 10);
}

TEST_CASE("two runs give the same page, and no materials give a page too") {
  CHECK(page() == page());
  CHECK(unbalanced(without(without(f0_page({}, {}), "<style>", "</style>"), "<script>", "</script>")) == "");
}

TEST_CASE("the F0 page of every output space is well-formed") {
  for (const RgbSpace space : all_rgb_spaces) {
    F0Options options;
    options.space = space;
    CHECK(contains(f0_page(sample_reports(), options), "linear " + std::string(name(space))));
  }
}
