// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/pages/f0/page_parts.h"

namespace etak {
namespace {

struct SummaryColumn {
  std::string_view title, hint;
};

constexpr std::size_t column_count = 13;

std::array<SummaryColumn, column_count> columns_of(const F0Options& options) {
  const bool is_xyz = !options.custom_space && options.space == RgbSpace::xyz;
  return {{{"Material", ""},
           {"sRGB", "F0 in 8-bit sRGB, hexadecimal"},
           {"8 bit", "F0 in 8-bit sRGB"},
           {is_xyz ? "X" : "r", "F0, linear, not clipped"},
           {is_xyz ? "Y" : "g", "F0, linear, not clipped"},
           {is_xyz ? "Z" : "b", "F0, linear, not clipped"},
           {"Lum. Y", "luminance of F0"},
           {"Zone", "luminance against the forbidden zone 0.20 to 0.45; a surface's diffuse colour is no F0"},
           {"F82", "reflectance at cosine 1/7, 8-bit sRGB"},
           {"Spread ΔE",
            "largest difference between published datasets, CIEDE2000; number of datasets in brackets"},
           {"Coverage", "share of the visible weight that the data cover, the least of X, Y, Z"},
           {"Kind", "of the preferred dataset: measured, a model's fit, or computed from theory"},
           {"Flags", ""}}};
}

void append_swatch(std::string& out, const Srgb8& codes, std::string_view css_class) {
  append(out, "<i class=\"", css_class, "\" style=\"background:", hex(codes), "\"></i>");
}

void append_number_cell(std::string& out, double value) {
  append(out, "<td class=\"num\">", fixed(value, 4), "</td>");
}

void append_row(std::string& out, const MaterialReport& report, const F0PageContext& context) {
  const F0Result& r = preferred_result(report);
  const std::string& id = report.material.id;
  const auto edge = context.edge_codes(r);
  append(out, "<tr id=\"", anchor("t-", id), "\" data-class=\"", report.material.material_class,
         "\"><th scope=\"row\"><span class=\"who\">");
  if (r.refused()) {
    out += "<span class=\"ball\"></span><span class=\"pair\">";
  } else {
    append(out, "<span class=\"ball\" style=\"background:",
           ball_paint(report.material, report.material.preferred_dataset(), r, context.options()),
           "\"></span><span class=\"pair\" data-copy=\"", hex(r.srgb8), "\">");
    append_swatch(out, r.srgb8, "f0");
    if (edge) append_swatch(out, *edge, "f82");
  }
  append(out, "</span><a href=\"#", anchor("m-", id), "\">", escape_html(report.material.name),
         "</a></span></th>");
  if (r.refused()) {
    append(out, "<td class=\"refused\" colspan=\"", std::to_string(column_count - 1), "\">no F0: ");
    append(out, escape_html(r.refusal), "</td></tr>\n");
    return;
  }
  append(out, "<td data-copy=\"", hex(r.srgb8), "\"><code>", hex(r.srgb8),
         "</code></td><td class=\"num\" data-copy=\"", codes_text(r.srgb8), "\">", codes_text(r.srgb8),
         "</td>");
  for (const double value : vec(r.linear)) append_number_cell(out, value);
  append_number_cell(out, r.luminance);
  const std::string_view zone = r.zone ? name(*r.zone) : "";
  append(out, "<td class=\"", zone, "\">", r.zone ? zone : "–", "</td><td>");
  if (edge) append(out, "<code data-copy=\"", hex(*edge), "\">", hex(*edge), "</code>");
  append(out, edge ? "" : "–", "</td><td class=\"num\">");
  const std::size_t count = spread(report).count;
  if (count > 1) append(out, fixed(largest_difference(report), 1), " (", std::to_string(count), ")");
  append(out, count > 1 ? "" : "–", "</td>");
  append_number_cell(out, r.coverage.least());
  append(out, "<td>", name(report.material.preferred_dataset().origin), "</td><td class=\"wide\">");
  append_flags(out, r);
  out += "</td></tr>\n";
}

}  // namespace

void append_summary_table(std::string& out, std::span<const F0PageGroup> groups,
                          const F0PageContext& context) {
  out += "<div class=\"scroll\" id=\"summary\"><table class=\"data summary\"><thead><tr>";
  for (const SummaryColumn& column : columns_of(context.options())) {
    out += "<th scope=\"col\"";
    if (!column.hint.empty()) append(out, " title=\"", column.hint, "\"");
    append(out, ">", column.title, "</th>");
  }
  out += "</tr></thead>\n";
  for (const F0PageGroup& group : groups) {
    append(out, "<tbody><tr class=\"group\" id=\"", anchor("class-", group.material_class),
           "\"><th scope=\"rowgroup\" colspan=\"");
    append(out, std::to_string(column_count), "\"><a href=\"#", anchor("cards-", group.material_class),
           "\">");
    append(out, escape_html(group.title), "</a></th></tr>\n");
    for (const MaterialReport* report : group.members) append_row(out, *report, context);
    out += "</tbody>\n";
  }
  out += "</table></div>\n";
}

}  // namespace etak
