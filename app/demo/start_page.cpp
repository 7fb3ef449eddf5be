// SPDX-License-Identifier: Apache-2.0
#include "app/demo/start_page.h"

#include <algorithm>
#include <string_view>

#include "app/demo/start_page_style.h"
#include "core/base/bytes/base64.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/pages/error_time_report.h"
#include "core/pages/f0/page_parts.h"
#include "core/pages/page_style.h"

namespace etak {
namespace {

// Half of 175 observers told pairs of ceramic samples apart at a CIEDE2000 of 0.8 (Paravina et al. 2015,
// "Color difference thresholds in dentistry").
constexpr double seen_difference = 1;

std::string png_address(const std::string& png) {
  return "data:image/png;base64," + base64(png);
}

void append_start_head(std::string& out, const StartPageData& data) {
  std::size_t datasets = 0, surfaces = 0;
  for (const MaterialReport& report : data.library) {
    datasets += report.material.datasets.size();
    surfaces += !gives_f0(report.material.material_class);
  }
  append(
      out,
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>etak: measured optics into materials</title>\n"
      "<style>",
      page_css, start_css, strips_css(), "</style></head>\n<body>\n<header><h1>etak</h1>\n<p class=\"lead\">",
      "From η and k, the complex index of refraction: etak turns measured optics into materials a renderer can trust, says what every shortcut costs in colour, packs the result and finds what cannot be real.</p>\n<ul class=\"facts\">");
  append(out, "<li><b>", std::to_string(data.library.size() - surfaces),
         "</b> materials with an F0</li><li><b>", std::to_string(surfaces),
         "</b> everyday surfaces</li><li><b>", std::to_string(datasets),
         "</b> published datasets, each with its source</li></ul>\n</header>\n<main>\n");
}

void append_material(std::string& out, const StartMaterial& material) {
  append(out, "<article><h3>", escape_html(material.name), "</h3><div class=\"balls\">");
  for (const StartSphere& sphere : material.spheres) {
    const bool exact = &sphere == &material.spheres.front();
    append(out, !exact && sphere.mean_de >= seen_difference ? "<figure class=\"seen\">" : "<figure>",
           "<img width=\"160\" height=\"160\" alt=\"", escape_html(material.name), ", ",
           escape_html(sphere.title), "\" src=\"", png_address(sphere.png), "\"><figcaption>",
           escape_html(sphere.title), "<br>");
    append(out,
           exact ? std::string("the truth")
                 : "<b>ΔE " + fixed(sphere.mean_de, 2) + "</b><br>worst " + fixed(sphere.worst_de, 1),
           "</figcaption></figure>");
  }
  out += "</div><details><summary>Values</summary>";
  for (const auto& [target, text] : material.values)
    append(out, "<h4>", escape_html(target), "</h4><pre data-target=\"", escape_html(target), "\">",
           escape_html(text), "</pre>");
  out += "</details></article>\n";
}

void append_wall(std::string& out, const StartPageData& data) {
  append(
      out, "<section id=\"spheres\"><h2>Measured, and as programs compute it</h2>\n<p>",
      std::to_string(data.materials.size()),
      " materials in the same studio. The first sphere reflects by the measured spectrum at every angle, the second by Schlick's curve from F0. The third of metals and semiconductors is by F82, which keeps the "
      "colour of metals near the rim; the third of clear materials is by the exact form from F0, all that it needs. A clear ball shows the studio through itself. Below: the mean colour difference from the "
      "first, CIEDE2000, and its worst pixel; 1 is about what an eye can tell: half of 175 observers told ceramic samples apart at 0.8 (<a href=\"https://doi.org/10.1111/jerd.12149\">Paravina et al. "
      "2015</a>). Tone curve: Khronos PBR Neutral.</p>\n<div class=\"wall\">\n");
  for (const StartMaterial& material : data.materials) append_material(out, material);
  out += "</div></section>\n";
}

void append_live(std::string& out, const StartPageData& data) {
  if (!data.element) return;
  append(
      out,
      "<section id=\"live\"><h2>Any material, computed in this page</h2>\n<p>The program itself, as WebAssembly: ",
      std::to_string(data.library.size()),
      " materials by id, name, alias or formula, drawn by etak's own shaders.</p>\n<form class=\"engine\">",
      "<label>Material <input name=\"id\" value=\"titanium\" spellcheck=\"false\" autocomplete=\"off\"></label> ",
      "<label>Titania on it <input name=\"film\" type=\"range\" min=\"0\" max=\"300\" step=\"5\" value=\"0\"> <output>none</output></label> ",
      "<label>Roughness <input name=\"roughness\" type=\"range\" min=\"0\" max=\"1\" step=\"0.05\" value=\"0.25\"> <output>0.25</output></label></form>\n");
  out +=
      "<div class=\"live\"><etak-material id=\"titanium\" roughness=\"0.25\">titanium</etak-material>"
      "<etak-material id=\"gold\" illuminant=\"A\">gold under illuminant A</etak-material>"
      "<etak-material id=\"copper\" film=\"water:2mm\">copper under 2 mm of water</etak-material>"
      "<etak-material id=\"apple\">apple</etak-material></div>\n"
      "<script defer src=\"etak-element.js\"></script></section>\n";
}

void append_zone(std::string& out, const StartPageData& data) {
  append(
      out,
      "<section id=\"zone\"><h2>Where materials are, and where none is</h2>\n<p>Every material of the library by the luminance of its F0. Between 0.20 and 0.45 lie semiconductors and a few compounds: a texture "
      "with such values is most often a mistake, and the validator says so. A dot leads to its material.</p>\n");
  append_luminance_strip(out, page_groups(data.library), data.library_page);
  out += "</section>\n";
}

void append_chart(std::string& out, const StartPageData& data) {
  const std::string chart = start_chart(data.points);
  if (chart.empty()) return;
  append(
      out,
      "<section id=\"chart\"><h2>What exactness costs</h2>\n<p>Ways to compute F, by the time of one evaluation and by the error over the spheres above: the dot is the mean over the materials, the line "
      "goes from the best material to the worst. Times: ",
      escape_html(data.costs), ".</p>\n<div class=\"beside\"><div class=\"panel wide\">", chart,
      "</div><div class=\"panel wide\"><table class=\"data\"><thead><tr><th scope=\"col\">F by</th><th scope=\"col\">ns</th><th scope=\"col\">mean ΔE</th><th scope=\"col\">best</th><th scope=\"col\">worst</th></tr></thead><tbody>\n");
  for (const StartPoint& point : data.points)
    append(out, "<tr><th scope=\"row\">", escape_html(point.title), "</th><td class=\"num\">",
           number(point.ns, 3), "</td><td class=\"num\">", fixed(point.mean_de, 2), "</td><td class=\"num\">",
           fixed(point.least_de, 2), "</td><td class=\"num\">", fixed(point.most_de, 2), "</td></tr>\n");
  out += "</tbody></table></div></div></section>\n";
}

void append_films(std::string& out, const StartPageData& data) {
  if (data.films.ways.empty()) return;
  append(
      out,
      "<section id=\"films\"><h2>An oxide, as renderers are told of it</h2>\n<p>Titanium under titania of growing thickness, from every angle. With the index and thickness as they are measured, glTF's and OpenPBR's films "
      "show other colours; with numbers that etak fits to the exact stack the same fields show nearly the true ones. Below each name the mean colour difference, CIEDE2000.</p>\n",
      strips_html(data.films), "</section>\n");
}

void append_textures(std::string& out, std::string_view title, const std::vector<StartPicture>& pictures) {
  append(out, "<div class=\"panel\"><h3>", title, "</h3><div class=\"textures\">");
  for (const StartPicture& picture : pictures)
    append(out, "<figure style=\"--wide: ", std::to_string(picture.width), "\"><img alt=\"",
           escape_html(picture.label), "\" src=\"", png_address(picture.png), "\"><figcaption>",
           escape_html(picture.label), "<br>", std::to_string(picture.width), " x ",
           std::to_string(picture.height), "</figcaption></figure>");
  out += "</div></div>\n";
}

void append_atlas(std::string& out, const StartPageData& data) {
  if (data.after.empty()) return;
  append(
      out,
      "<section id=\"atlas\"><h2>An atlas, before and after</h2>\n<p>The pictures of a small scene, and the texture pairs that etak pack made of it, all at one scale. As two full-size textures for each material they were ",
      grouped(data.texels_before), " texels; the pages have ", grouped(data.texels_after), " (");
  append(
      out,
      fixed(100.0 * static_cast<double>(data.texels_after) /
                static_cast<double>(std::max<std::uint64_t>(data.texels_before, 1)),
            0),
      "\u00a0%), gutters and empty places counted: what is constant is a number, what is equal is stored once, what nothing reads is left out.</p>\n<div class=\"beside\">");
  append_textures(out, "Before", data.before);
  append_textures(out, "After", data.after);
  out += "</div></section>\n";
}

void append_start_findings(std::string& out, const StartPageData& data) {
  append(
      out,
      "<section id=\"findings\"><h2>What cannot be real</h2>\n<p>The validator over materials that were made with a mistake each: ",
      escape_html(data.verdict), "</p>\n<div class=\"found\">\n");
  for (const StartFinding& each : data.findings) {
    const Finding& finding = each.finding;
    out += "<article>";
    if (!each.picture.png.empty())
      append(out, "<img width=\"96\" height=\"96\" alt=\"", escape_html(each.picture.label), "\" src=\"",
             png_address(each.picture.png), "\">");
    append(out, "<div><p><span class=\"severity ", name(finding.severity), "\">", name(finding.severity),
           "</span> <b>", finding.rule, ' ', escape_html(finding.slug), "</b></p><p class=\"place\">",
           escape_html(place_of(finding)), "</p><p>", escape_html(sentence_of(finding)),
           ".</p><p><b>Fix.</b> ", escape_html(finding.fix), "</p></div></article>\n");
  }
  out += "</div></section>\n";
}

void append_cards(std::string& out, const StartPageData& data) {
  out += "<section id=\"pages\"><h2>Go on</h2>\n<div class=\"cards\">\n";
  for (const StartCard& card : data.cards) {
    append(out, "<a href=\"", escape_html(card.target), "\">");
    if (!card.picture.empty()) append(out, "<img alt=\"\" src=\"", png_address(card.picture), "\">");
    append(out, "<h3>", escape_html(card.title), "</h3><p>", escape_html(card.text), "</p></a>\n");
  }
  out += "</div></section>\n";
}

}  // namespace

std::string start_page(const StartPageData& data) {
  std::string out;
  append_start_head(out, data);
  append_wall(out, data);
  append_live(out, data);
  append_zone(out, data);
  append_chart(out, data);
  append_films(out, data);
  append_atlas(out, data);
  append_start_findings(out, data);
  append_cards(out, data);
  append(out, "</main>\n");
  if (!data.materials.empty()) append(out, "<script>", copy_script, start_script, "</script>\n");
  if (data.element) append(out, "<script>", live_script, "</script>\n");
  return out += "</body></html>\n";
}

}  // namespace etak
