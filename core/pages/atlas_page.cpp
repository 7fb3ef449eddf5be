// SPDX-License-Identifier: Apache-2.0
#include "core/pages/atlas_page.h"

#include <string_view>

#include "core/base/bytes/base64.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/pages/page_style.h"

namespace etak {
namespace {

constexpr std::string_view atlas_css = R"css(
.sheets { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); gap: 1.25rem; }
.sheets figure { margin: 0; background: var(--card); border-radius: 8px; padding: 0.75rem; }
.sheets figcaption { font-size: 0.87rem; color: var(--ink-soft); padding-top: 0.4rem; }
.sheets img, .sheets svg { display: block; width: 100%; height: auto; image-rendering: auto; }
.parts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 32rem), 1fr)); gap: 1.25rem; margin-top: 0.75rem; }
.parts figure { margin: 0; background: var(--card); border-radius: 8px; padding: 0.75rem; }
.parts figcaption { font-size: 0.87rem; color: var(--ink-soft); padding-top: 0.4rem; }
.parts img { width: 32%; height: auto; image-rendering: pixelated; }
.data tbody.texture th { font-weight: 600; border-top: 1px solid var(--line); }
.verdict { font-weight: 600; }
.severity { display: inline-block; min-width: 4.6rem; text-align: center; padding: 0 0.45rem; border-radius: 4px;
  font-size: 0.8rem; font-weight: 700; }
.severity.error { background: #b3261e; color: #fff; }
.severity.warning { background: #ffc46b; color: #3b2500; }
.severity.info { background: #cfe0f5; color: #12314f; }
.data td.text { white-space: normal; min-width: 18rem; overflow-wrap: anywhere; }
.swatch { display: inline-block; width: 1.1rem; height: 1.1rem; border: 1px solid var(--line); vertical-align: -3px; }
)css";

std::string percent(std::uint64_t part, std::uint64_t whole) {
  return fixed(whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole), 1) + " %";
}

void append_figure(std::string& out, const std::string& png, const std::string& caption) {
  if (png.empty()) return;
  append(out, "<figure><img alt=\"", escape_html(caption), "\" src=\"data:image/png;base64,", base64(png),
         "\"><figcaption>", escape_html(caption), "</figcaption></figure>\n");
}

void append_pages(std::string& out, const AtlasPageData& data) {
  for (std::size_t p = 0; p < data.layout.pages.size(); ++p) {
    const AtlasPage& page = data.layout.pages[p];
    append(out, "<section><h2>Page ", std::to_string(p), ": ", std::to_string(page.width), " x ",
           std::to_string(page.height), "</h2>\n<div class=\"sheets\">\n");
    if (p < data.pictures.size()) {
      append_figure(out, data.pictures[p].diffuse,
                    "Texture A: diffuse, hidden by alpha where it is checkered");
      append_figure(out, data.pictures[p].specular, "Texture B: F0, the reflectance at normal incidence");
      append_figure(out, data.pictures[p].gloss, "Texture B: gloss, its fourth channel");
    }
    append(
        out, "<figure>", layout_svg(data.layout, static_cast<int>(p)),
        "<figcaption>Layout: regions with their gutters (darker); point at one for its size</figcaption></figure>\n</div></section>\n");
  }
}

void append_sources(std::string& out, const AtlasLayout& layout) {
  const std::vector<SourceMap> maps = source_maps(layout);
  if (maps.empty()) return;
  out +=
      "<section id=\"sources\"><h2>Where the regions come from</h2>\n<p>Each picture with the parts of it that are on a page; point at one for both of its places. What is dark was left out.</p>\n"
      "<div class=\"sheets\">\n";
  for (const SourceMap& map : maps)
    append(out, "<figure>", map.svg, "<figcaption>", escape_html(map.materials), "</figcaption></figure>\n");
  out += "</div></section>\n";
}

void append_left_out(std::string& out, const AtlasPageData& data) {
  out += "<section><h2>What was left out</h2>\n";
  append(out, "<p>Left of two full-size textures, gutters and page waste apart: <b>",
         percent(data.after.channel_texels, data.before.channel_texels), "</b> by channel, <b>",
         percent(data.after.texels, data.before.texels), "</b> as RGBA texels.</p>\n");
  if (!data.left_out.empty()) {
    out +=
        "<div class=\"scroll\"><table class=\"data summary\"><thead><tr><th>what</th><th>texels</th><th>channels' texels</th><th>bytes</th><th>error, codes</th><th>of</th></tr></thead><tbody>\n";
    for (const LeaveOutLine& line : data.left_out)
      append(out, "<tr><td>", escape_html(line.what), "</td><td class=\"num\">", grouped(line.texels),
             "</td><td class=\"num\">", grouped(line.channel_texels), "</td><td class=\"num\">",
             grouped(line.bytes), "</td><td class=\"num\">", number(line.error, 3),
             "</td><td class=\"text\">", escape_html(line.detail), "</td></tr>\n");
    out += "</tbody></table></div>\n";
  }
  out += "</section>\n";
}

void append_findings(std::string& out, const AtlasPageData& data) {
  out += "<section id=\"findings\"><h2>What the validator says</h2>\n";
  if (data.findings == nullptr) {
    out += "<p>The pages were not checked.</p></section>\n";
    return;
  }
  append(out, "<p class=\"verdict\">", escape_html(verdict_of(*data.findings)), "</p>\n");
  std::string rows;
  for (const CheckedFile& file : data.findings->files)
    for (const Finding& finding : file.findings) {
      if (!counts(finding)) continue;
      append(rows, "<tr><td><span class=\"severity ", name(finding.severity), "\">", name(finding.severity),
             "</span></td><td>", finding.rule, ' ', finding.slug, "</td><td class=\"text\">",
             escape_html(place_of(finding)), "</td><td class=\"text\">", escape_html(sentence_of(finding)),
             "</td><td class=\"text\">", escape_html(finding.fix), "</td></tr>\n");
    }
  if (!rows.empty())
    append(
        out,
        "<div class=\"scroll\"><table class=\"data summary\"><thead><tr><th></th><th>rule</th><th>where</th><th>what</th><th>fix</th></tr></thead><tbody>\n",
        rows, "</tbody></table></div>\n");
  out += "</section>\n";
}

// A colour that is the same in all texels of the material, as a swatch with its codes; "varies" for others.
std::string constant_text(const AtlasMaterialRow& row, std::size_t first) {
  for (std::size_t c = first; c < first + 3; ++c)
    if (!row.constant[c]) return "varies";
  std::string codes;
  for (std::size_t c = first; c < first + 3; ++c)
    codes += (c == first ? "" : " ") + std::to_string(*row.constant[c]);
  return "<span class=\"swatch\" style=\"background: rgb(" + codes + ")\"></span> " + codes;
}

std::string constant_number(const AtlasMaterialRow& row, std::size_t channel) {
  return row.constant[channel] ? std::to_string(*row.constant[channel]) : "varies";
}

void append_materials(std::string& out, const AtlasLayout& layout) {
  append(
      out, "<section><h2>Materials</h2>\n<p>Codes of 8 bits; gloss is ", name(layout.gloss),
      ". A shader needs what its defines name and nothing else: <code>etak shader --layout layout.json --material NAME</code>.</p>\n<div class=\"scroll\"><table class=\"data summary\"><thead><tr>"
      "<th>material</th><th>diffuse</th><th>alpha</th><th>F0</th><th>gloss</th><th>texels</th><th>defines</th></tr></thead><tbody>\n");
  for (const AtlasMaterialRow& row : layout.materials) {
    append(out, "<tr><th>", escape_html(row.name), "</th><td>", constant_text(row, 0), "</td><td>",
           constant_number(row, alpha_channel), "</td><td>", constant_text(row, specular_channel),
           "</td><td>", constant_number(row, gloss_channel), "</td><td>", row.texels ? "on pages" : "none",
           "</td><td class=\"text\"><code>", escape_html(joined(row.defines, " ")), "</code></td></tr>\n");
  }
  out += "</tbody></table></div></section>\n";
}

}  // namespace

std::string atlas_page(const AtlasPageData& data) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>";
  append(out, escape_html(data.title), "</title>\n<style>", page_css, atlas_css,
         "</style></head>\n<body>\n<header><h1>", escape_html(data.title), "</h1>\n<p class=\"lead\">",
         std::to_string(data.layout.materials.size()), " materials on ",
         std::to_string(data.layout.pages.size()), data.layout.pages.size() == 1 ? " page" : " pages",
         ": two textures that share one layout.</p>\n");
  if (!data.links.empty()) {
    out += "<nav>";
    for (const auto& [text, target] : data.links)
      append(out, "<a href=\"", escape_html(target), "\">", escape_html(text), "</a>");
    out += "</nav>\n";
  }
  out += "</header>\n<main>\n";
  append_pages(out, data);
  append_sources(out, data.layout);
  append_left_out(out, data);
  if (!data.blocks.empty()) out += blocks_section(data.blocks, data.block_pictures);
  append_findings(out, data);
  append_materials(out, data.layout);
  return out + "</main>\n</body></html>\n";
}

}  // namespace etak
