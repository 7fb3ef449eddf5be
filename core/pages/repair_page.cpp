// SPDX-License-Identifier: Apache-2.0
#include "core/pages/repair_page.h"

#include <algorithm>
#include <tuple>

#include "core/base/bytes/base64.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"
#include "core/image/files/png.h"
#include "core/pages/page_style.h"
#include "core/pages/validation_pictures.h"

namespace etak {
namespace {

constexpr int thumbnail_most = 256;
constexpr std::size_t most_files_shown = 200;

constexpr std::string_view repair_css = R"css(
.shots { display: flex; flex-wrap: wrap; gap: 1.25rem; margin: 0.75rem 0; align-items: flex-start; }
.shots figure { margin: 0; }
.shots figcaption { font-size: 0.83rem; color: var(--ink-soft); }
.stack { position: relative; display: inline-block; line-height: 0; background: #777; }
.stack img { display: block; width: 100%; height: 100%; image-rendering: auto; }
.stack .over { position: absolute; inset: 0; }
article h3 { margin: 0; overflow-wrap: anywhere; }
td { overflow-wrap: anywhere; }
)css";

// 2 where a texel was changed, else 0.
Image8 changes(const Image8& before, const Image8& after) {
  Image8 out(before.width, before.height, 1);
  for (int y = 0; y < before.height; ++y)
    for (int x = 0; x < before.width; ++x)
      out.at(x, y)[0] = std::ranges::equal(before.at(x, y), after.at(x, y)) ? 0 : 2;
  return out;
}

void append_image(std::string& out, std::string_view alt, const std::string& png, bool over) {
  append(out, "<img", over ? " class=\"over\"" : "", " alt=\"", alt, "\" src=\"data:image/png;base64,",
         base64(png), "\">");
}

void append_left(std::string& out, const RepairReport& report) {
  if (report.left.empty()) return;
  out +=
      "<section id=\"left\"><h2>Left</h2>\n<div class=\"scroll\"><table class=\"data\"><thead><tr><th scope=\"col\">Rule</th><th scope=\"col\">File</th><th scope=\"col\">Why</th></tr></thead><tbody>\n";
  for (const LeftFinding& left : report.left)
    append(out, "<tr><th scope=\"row\">", left.rule, ' ', escape_html(left.slug), "</th><td>",
           escape_html(left.file), "</td><td>", escape_html(left.why), "</td></tr>\n");
  out += "</tbody></table></div></section>\n";
}

}  // namespace

void RepairPage::add(const RepairedFile& file, const Image8& before, const Image8& after) {
  if (shown_.size() == most_files_shown) return;
  const Image8 small = thumbnail(before, thumbnail_most);
  Shown& shown = shown_.emplace_back();
  shown.copy = file.copy;
  shown.width = small.width;
  shown.height = small.height;
  shown.before = png_bytes(small, {});
  shown.after = png_bytes(thumbnail(after, thumbnail_most), {});
  shown.changed = png_bytes(heat_map(changes(before, after), small.width, small.height), {});
}

std::string RepairPage::html(const RepairReport& report, const std::string& version) const {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>etak validate: repaired copies</title>\n<style>";
  append(out, page_css, repair_css, "</style></head>\n<body>\n<header><h1>Repaired copies</h1>\n");
  const auto repaired = static_cast<std::size_t>(
      std::ranges::count_if(report.files, [](const RepairedFile& file) { return !file.steps.empty(); }));
  append(out, "<p class=\"lead\">", grouped(repaired), repaired == 1 ? " file was" : " files were",
         " repaired. The originals are as they were. Fourth channels (alpha, gloss) are not shown.</p>\n",
         "<p class=\"policy\">etak ", escape_html(version), ".</p></header>\n<main>\n");
  for (const RepairedFile& file : report.files) {
    if (file.steps.empty()) continue;
    append(out, "<article><h3>", escape_html(file.copy), "</h3><p class=\"policy\">from ",
           escape_html(file.file), "; ", grouped(file.of - file.texels), " of ", grouped(file.of),
           " texels are as they were</p>\n");
    if (const auto shown = std::ranges::find(shown_, file.copy, &Shown::copy); shown != shown_.end()) {
      // Small pictures are enlarged to a side that can be seen.
      const int scale = std::max(1, 160 / std::max({1, shown->width, shown->height}));
      out += "<div class=\"shots\">\n";
      for (const auto& [caption, png, over] :
           {std::tuple<std::string_view, const std::string*, const std::string*>{"before", &shown->before,
                                                                                 nullptr},
            {"after", &shown->after, nullptr},
            {"changed texels", &shown->after, &shown->changed}}) {
        append(out, "<figure><div class=\"stack\" style=\"width: ", std::to_string(scale * shown->width),
               "px; height: ", std::to_string(scale * shown->height), "px\">");
        append_image(out, caption, *png, false);
        if (over != nullptr) append_image(out, "in red", *over, true);
        append(out, "</div><figcaption>", caption, "</figcaption></figure>\n");
      }
      out += "</div>\n";
    }
    out += "<ul>\n";
    for (const RepairStep& step : file.steps) {
      append(out, "<li>", step.rule, ' ', escape_html(step.slug));
      for (const std::string& rule : step.also) append(out, " and ", rule);
      append(out, ": ", escape_html(step.what), " (", grouped(step.texels), " texels)</li>\n");
    }
    for (const std::string& lost : file.not_kept) append(out, "<li>Not kept: ", escape_html(lost), "</li>\n");
    out += "</ul></article>\n";
  }
  append_left(out, report);
  return out + "</main>\n</body></html>\n";
}

}  // namespace etak
