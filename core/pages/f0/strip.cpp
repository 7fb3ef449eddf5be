// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/math/functions.h"
#include "core/pages/f0/page_parts.h"

namespace etak {
namespace {

constexpr double strip_width = 1120, first_x = 130, last_x = 1090;  // x of luminance 0 and 1
constexpr double radius = 5, spacing = 10.6;  // of dots; least distance between their centres
constexpr double lane_gap = 14, top = 34;

struct Dot {
  double x = 0, offset = 0;  // the offset is vertical, from the middle of the lane
  const MaterialReport* report = nullptr;
};

struct Lane {
  std::string_view kind, title;
  std::vector<Dot> dots;
  double reach = radius;  // largest distance of a dot's rim from the middle
};

double x_of(double luminance) {
  return first_x + std::clamp(luminance, 0.0, 1.0) * (last_x - first_x);
}

// Moves each dot, from left to right, as near to the middle of its lane as the dots before it allow.
void spread_out(Lane& lane) {
  std::stable_sort(lane.dots.begin(), lane.dots.end(), [](const Dot& a, const Dot& b) { return a.x < b.x; });
  for (std::size_t i = 0; i < lane.dots.size(); ++i) {
    Dot& dot = lane.dots[i];
    const auto is_free = [&](double offset) {
      for (std::size_t j = i; j-- > 0 && dot.x - lane.dots[j].x < spacing;)
        if (math::hypot(dot.x - lane.dots[j].x, offset - lane.dots[j].offset) < spacing - 1e-6) return false;
      return true;
    };
    for (int step = 0;; ++step) {
      const double distance = step * spacing / 4;
      dot.offset = -distance;
      if (is_free(dot.offset)) break;
      dot.offset = distance;
      if (is_free(dot.offset)) break;
    }
    lane.reach = std::max(lane.reach, std::abs(dot.offset) + radius);
  }
}

// The luminances that nine of ten new publications of a dot's material would have.
void append_bar(std::string& out, const Dot& dot, double middle) {
  const auto band = band_of(*dot.report).band;
  if (!band) return;
  append(out, "<path class=\"bar\" d=\"M", fixed(x_of(band->y90[0]), 1), " ", fixed(middle + dot.offset, 1));
  append(out, "H", fixed(x_of(band->y90[1]), 1), "\"/>");
}

void append_dot(std::string& out, const Dot& dot, double middle, std::string_view page) {
  const F0Result& result = preferred_result(*dot.report);
  append(out, "<a href=\"", page, "#", anchor("m-", dot.report->material.id), "\"><circle cx=\"");
  append(out, fixed(dot.x, 1), "\" cy=\"", fixed(middle + dot.offset, 1), "\" r=\"");
  append(out, fixed(radius, 0), "\" fill=\"", hex(result.srgb8), "\"><title>");
  append(out, escape_html(dot.report->material.name), ", Y ", fixed(result.luminance, 4));
  out.append("</title></circle></a>");
}

}  // namespace

void append_luminance_strip(std::string& out, std::span<const F0PageGroup> groups, std::string_view page) {
  std::array<Lane, 3> lanes{{{"conductor", "Conductors", {}},
                             {"semiconductor", "Semiconductors", {}},
                             {"dielectric", "Dielectrics", {}}}};
  for (const F0PageGroup& group : groups)
    for (const MaterialReport* report : group.members) {
      if (preferred_result(*report).refused()) continue;
      const auto kind = optical_kind(report->material.material_class);
      for (Lane& lane : lanes)
        if (lane.kind == kind) lane.dots.push_back({x_of(preferred_result(*report).luminance), 0, report});
    }
  double bottom = top;
  for (Lane& lane : lanes) {
    spread_out(lane);
    if (!lane.dots.empty()) bottom += 2 * lane.reach + lane_gap;
  }

  const double zone_x = x_of(forbidden_zone_first), zone_width = x_of(forbidden_zone_last) - zone_x;
  const std::string height = fixed(bottom + 48, 0);
  append(out, "<div class=\"scroll\"><svg class=\"strip\" viewBox=\"0 0 ", fixed(strip_width, 0), " ");
  append(out, height,
         "\" role=\"img\"><title>Luminance of F0 of all materials</title><desc>One dot per material in ");
  out.append(
      "its own colour, by luminance Y from 0 to 1; nine of ten new publications of it would lie on its bar; the forbidden zone from 0.20 to 0.45 is shaded.</desc>");
  append(out, "<rect class=\"zone\" x=\"", fixed(zone_x, 1), "\" y=\"", fixed(top - 10, 1));
  append(out, "\" width=\"", fixed(zone_width, 1), "\" height=\"", fixed(bottom - top + 10, 1), "\"/>");
  append(out, "<text x=\"", fixed(zone_x + zone_width / 2, 1));
  out.append("\" y=\"16\" text-anchor=\"middle\">forbidden zone 0.20 &lt; Y &lt; 0.45</text>");
  for (int i = 0; i <= 20; ++i) {
    const std::string x = fixed(x_of(i / 20.0), 1);
    append(out, "<path class=\"", i % 2 ? "minor" : "grid", "\" d=\"M", x, " ");
    append(out, fixed(i % 2 ? bottom : top - 10, 1), "V", fixed(bottom + 5, 1), "\"/>");
    if (i % 2 == 0)
      append(out, "<text x=\"", x, "\" y=\"", fixed(bottom + 20, 1), "\" text-anchor=\"middle\">",
             fixed(i / 20.0, 1), "</text>");
  }
  append(out, "<text class=\"label\" x=\"", fixed((first_x + last_x) / 2, 1), "\" y=\"",
         fixed(bottom + 40, 1));
  out.append("\" text-anchor=\"middle\">luminance Y of F0 (linear; 1 = perfect reflector)</text>");

  double y = top;
  for (const Lane& lane : lanes) {
    if (lane.dots.empty()) continue;
    const double middle = y + lane.reach;
    append(out, "<text class=\"label\" x=\"", fixed(first_x - 14, 0), "\" y=\"", fixed(middle + 4, 1));
    append(out, "\" text-anchor=\"end\">", lane.title, "</text>");
    for (const Dot& dot : lane.dots) append_bar(out, dot, middle);
    for (const Dot& dot : lane.dots) append_dot(out, dot, middle, page);
    y += 2 * lane.reach + lane_gap;
  }
  out += "</svg></div>\n";
}

}  // namespace etak
