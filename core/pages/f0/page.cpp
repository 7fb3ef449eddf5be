// SPDX-License-Identifier: Apache-2.0
// The F0 page: head, summary table, cards, explanations. Nothing in it depends on the time or the machine, so
// that two runs give the same bytes.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/pages/f0/page_parts.h"
#include "core/pages/page_style.h"
#include "core/plot/svg_plot.h"

namespace etak {
namespace {

struct ClassTitle {
  std::string_view material_class, title;
};

// The classes in the order of the page.
constexpr std::array<ClassTitle, material_classes.size()> class_titles{{{"metal", "Metals"},
                                                                        {"alloy", "Alloys"},
                                                                        {"conductor", "Other conductors"},
                                                                        {"semiconductor", "Semiconductors"},
                                                                        {"gem", "Gems"},
                                                                        {"mineral", "Minerals"},
                                                                        {"crystal", "Crystals"},
                                                                        {"salt", "Salts"},
                                                                        {"glass", "Glasses"},
                                                                        {"plastic", "Plastics"},
                                                                        {"organic", "Organic materials"},
                                                                        {"liquid", "Liquids"},
                                                                        {"solid", "Other solids"},
                                                                        {"gas", "Gases"},
                                                                        {"surface", "Measured surfaces"}}};

// The visible spectrum as a gradient for the bars below wavelength axes. Each wavelength has its chromaticity
// with the largest channel scaled to one; the gradient fades towards the ends, where the eye sees little.
void append_spectrum_gradient(std::string& out) {
  const auto observer = matching_functions(Observer::cie1931_2deg);
  const Xyz white = to_xyz(make_quadrature(Method::nm1, Viewing{}).white());
  const Mat3 to_rgb_matrix = xyz_to_rgb(RgbSpace::srgb, white, white);
  out +=
      "<svg width=\"0\" height=\"0\" aria-hidden=\"true\" class=\"hidden\"><defs><linearGradient id=\"spectrum\">";
  for (int nm = grid_first_nm; nm <= grid_last_nm; nm += 10) {
    const auto& xyz = observer[static_cast<std::size_t>(nm - grid_first_nm)];
    Vec3 rgb = to_rgb_matrix * xyz;
    for (double& channel : rgb) channel = std::max(channel, 0.0);
    const double largest = std::max({rgb[0], rgb[1], rgb[2], 1e-12});
    const double strength = std::min(1.0, (xyz[0] + xyz[1] + xyz[2]) / 0.35);
    for (double& channel : rgb) channel /= largest;
    append(out, "<stop offset=\"", number((nm - grid_first_nm) / double(grid_last_nm - grid_first_nm), 4));
    append(out, "\" stop-color=\"", hex(srgb_u8(to_rgb(rgb))), "\" stop-opacity=\"");
    append(out, number(strength, 2), "\"/>");
  }
  out += "</linearGradient></defs></svg>\n";
}

void append_head(std::string& out, std::span<const MaterialReport> materials,
                 std::span<const F0PageGroup> groups, const F0Options& options) {
  std::size_t datasets = 0, refused = 0, inside = 0, surfaces = 0;
  for (const MaterialReport& report : materials) {
    datasets += report.material.datasets.size();
    const F0Result& result = preferred_result(report);
    if (!gives_f0(report.material.material_class)) ++surfaces;
    if (result.refused())
      ++refused;
    else if (result.zone == Zone::inside)  // surfaces have no zone
      ++inside;
  }
  out += "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">";
  out +=
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>F0 of real materials</title>\n<style>";
  append(out, page_css, plot_css(), "</style></head>\n<body>\n");
  append_spectrum_gradient(out);
  out +=
      "<header><h1>F0 of real materials</h1>\n<p class=\"lead\">Reflectance at normal incidence (F0) and at 81.8° (F82, cosine 1/7) of ";
  append(out, std::to_string(materials.size() - surfaces), " materials");
  if (surfaces > 0)
    append(out, ", and the diffuse colour of ", std::to_string(surfaces), " measured surfaces");
  append(out, ", from ", std::to_string(datasets), " published datasets. ", std::to_string(inside),
         " lie in the forbidden zone; ");
  append(out, std::to_string(refused), refused == 1 ? " is" : " are",
         " listed without F0, with the reason.</p>\n");
  append(out, "<p class=\"policy\"><b>Policy.</b> ", escape_html(policy(options)),
         ".</p>\n<nav aria-label=\"Classes\">");
  for (const F0PageGroup& group : groups)
    append(out, "<a href=\"#", anchor("class-", group.material_class), "\">", escape_html(group.title),
           " <span>", std::to_string(group.members.size()), "</span></a>");
  out += "<a href=\"#flags\">Flags</a></nav></header>\n<main>\n";
}

void append_flag_meanings(std::string& out, std::span<const MaterialReport> materials) {
  // Every flag that occurs is explained, so that every link to a flag has its target.
  Flags seen;
  for (const MaterialReport& report : materials)
    for (const F0Result& result : report.results) seen |= result.flags;
  out += "<section id=\"flags\"><h2>Flags</h2>\n";
  if (seen.none()) out += "<p>None occurs.</p>\n";
  if (!seen.none()) out += "<dl>";
  seen.for_each([&](Flag flag) {
    append(out, "<dt id=\"", anchor("flag-", name(flag)), "\"><span class=\"flag\">", name(flag),
           "</span></dt><dd>");
    append(out, escape_html(meaning(flag)), "</dd>\n");
  });
  if (!seen.none()) out += "</dl>\n";
  out += "</section>\n";
}

}  // namespace

// ---- shared by the parts

std::vector<F0PageGroup> page_groups(std::span<const MaterialReport> materials) {
  std::vector<F0PageGroup> groups;
  for (const ClassTitle& row : class_titles)
    groups.push_back({std::string(row.material_class), std::string(row.title), {}});
  for (const MaterialReport& report : materials) {
    const std::string& wanted = report.material.material_class;
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.material_class == wanted; });
    if (group == groups.end()) group = groups.insert(group, {wanted, wanted, {}});
    group->members.push_back(&report);
  }
  std::erase_if(groups, [](const F0PageGroup& group) { return group.members.empty(); });
  for (F0PageGroup& group : groups)
    std::sort(group.members.begin(), group.members.end(), [](const auto* a, const auto* b) {
      return std::tie(a->material.name, a->material.id) < std::tie(b->material.name, b->material.id);
    });
  return groups;
}

MaterialBand band_of(const MaterialReport& report) {
  const Material& material = report.material;
  MaterialBand out;
  if (report.averaged) {
    out.reason = "a mean over the axes of a crystal";
    return out;
  }
  const auto f0_of = [&](const Dataset& each) {
    return report.results[static_cast<std::size_t>(&each - material.datasets.data())];
  };
  return material_band(f0_of, material, material.preferred_dataset(), report.results[material.preferred]);
}

F0PageContext::F0PageContext(const F0Options& options) : options_(options) {
  if (options.custom_space) return;
  const auto white_of = [&](Illuminant illuminant) {
    return to_xyz(make_quadrature(Method::nm1, {options.viewing.observer, illuminant}).white());
  };
  const Xyz white = white_of(options.viewing.illuminant), d65 = white_of(Illuminant::d65);
  if (options.space == RgbSpace::srgb)
    to_srgb_ = identity3;
  else
    to_srgb_ = xyz_to_rgb(RgbSpace::srgb, white, d65) * inverse(xyz_to_rgb(options.space, white, d65));
}

std::optional<Srgb8> F0PageContext::edge_codes(const F0Result& result) const {
  if (!result.f82 || !to_srgb_) return std::nullopt;
  const LinearRgb linear = to_rgb(*to_srgb_ * vec(*result.f82));
  return options_.method == Method::legacy_schueler ? power22_u8(linear) : srgb_u8(linear);
}

std::string anchor(std::string_view prefix, std::string_view text) {
  std::string out(prefix);
  for (const char c : text) {
    out += is_letter(c) || is_digit(c) || c == '_' ? c : '-';
  }
  return out;
}

const F0Result& preferred_result(const MaterialReport& report) {
  assert(report.results.size() == report.material.datasets.size());
  return report.results[report.material.preferred];
}

std::string codes_text(const Srgb8& codes) {
  return std::to_string(codes.r) + " " + std::to_string(codes.g) + " " + std::to_string(codes.b);
}

double largest_difference(const MaterialReport& report) {
  const F0Result& reference = preferred_result(report);
  double most = 0;
  if (reference.refused()) return most;
  for (const F0Result& result : report.results)
    if (!result.refused())
      most = std::max(most, delta_e2000(to_lab(reference.srgb_linear), to_lab(result.srgb_linear)));
  return most;
}

void append_flags(std::string& out, const F0Result& result) {
  bool first = true;
  result.flags.for_each([&](Flag flag) {
    if (!first) out += ' ';
    first = false;
    append(out, "<a class=\"flag\" href=\"#", anchor("flag-", name(flag)), "\" title=\"");
    append(out, escape_html(meaning(flag)), "\">", name(flag));
    if (flag == Flag::out_of_gamut)
      for (std::size_t c = 0; c < 3; ++c)
        if (result.gamut_excess[c] != 0)
          append(out, ' ', "rgb"[c], result.gamut_excess[c] > 0 ? "+" : "",
                 number(result.gamut_excess[c], 3));
    out += "</a>";
  });
  if (result.refused())
    append(out, first ? "" : " ", "<span class=\"refused\">", escape_html(result.refusal), "</span>");
}

std::string f0_page(std::span<const MaterialReport> materials, const F0Options& options) {
  const F0PageContext context(options);
  const std::vector<F0PageGroup> groups = page_groups(materials);
  std::string out;
  append_head(out, materials, groups, options);
  out +=
      "<section id=\"luminance\"><h2>Luminance and the forbidden zone</h2>\n<p>Few real materials have an F0 with a luminance ";
  out +=
      "between 0.20 and 0.45 (semiconductors do); an authored value in there is most often a mistake. The verdict is on the ";
  out +=
      "linear luminance Y, never on one channel. Measured surfaces are diffuse colours and no F0: they have no verdict.</p>\n";
  append_luminance_strip(out, groups);
  out +=
      "</section>\n<section id=\"table\"><h2>All materials</h2>\n<p>Preferred dataset of each. The ball is a smooth sphere of it under light that is the same from all sides: F0 in the middle, the reflectance of each angle "
      "around it. Of the swatch beside it the narrow part is F82. ";
  out += "Spread is the largest ΔE<sub>2000</sub> between the preferred and another published dataset.</p>\n";
  append_summary_table(out, groups, context);
  out +=
      "</section>\n<section id=\"materials\"><h2>Materials and their datasets</h2>\n<p>Each swatch is F0 of one dataset, with F82 at its ";
  out +=
      "right. In the plots the preferred dataset is bold and its samples are dotted; the others are thin. Curves end where the data end.</p>\n";
  for (const F0PageGroup& group : groups) {
    append(out, "<h3 id=\"", anchor("cards-", group.material_class), "\">", escape_html(group.title),
           "</h3>\n");
    for (const MaterialReport* report : group.members) append_card(out, *report, context);
  }
  out += "</section>\n";
  append_flag_meanings(out, materials);
  append(out, "</main>\n<script>", copy_script, page_script, "</script>\n</body></html>\n");
  return out;
}

}  // namespace etak
