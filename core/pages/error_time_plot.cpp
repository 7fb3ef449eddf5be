// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/math/functions.h"
#include "core/pages/error_time_report.h"
#include "core/plot/plot_file.h"

namespace etak {
namespace {

constexpr double width = 640;
constexpr double left = 66, right = 612, top = 26, bottom = 350;
constexpr double letter_width = 6.3, line_height = 13, dot_radius = 7, label_gap = dot_radius + 3;
constexpr double nothing_shown = 1e-15;  // errors below it are drawn on the axis: rounding, not error

// A logarithmic axis over whole or half decades.
struct LogAxis {
  double least = 0, most = 1;  // log10 of the values at its ends
  double from = 0, to = 1;     // coordinates of its ends in the SVG

  LogAxis(double smallest, double largest, double from_, double to_) : from(from_), to(to_) {
    least = std::floor(math::log10(smallest) * 2 - 0.2) / 2;
    most = std::ceil(math::log10(largest) * 2 + 0.2) / 2;
    if (most - least < 1) least -= 0.5, most += 0.5;
  }
  double at(double value) const {
    const double log = std::clamp(math::log10(std::max(value, 1e-300)), least, most);
    return from + (log - least) / (most - least) * (to - from);
  }
};

std::string coordinate(double value) {
  return fixed(value, 1);
}

std::string tick_text(double value) {
  return value >= 1 && value < 1e7 ? fixed(value, 0) : number(value, 3);
}

struct Point {
  const ErrorTimeRow* row;
  std::size_t number;  // of the row in its table, from 1
  double x, y;
  double first, last;  // x of the quartiles
};

// The class of a point in the style sheet.
std::string_view kind_of(const ErrorTimeRow& row) {
  switch (row.verdict) {
    case Verdict::unbeaten:
      return "best";
    case Verdict::beaten:
      return "grey";
    case Verdict::not_settled:
      return "open";
    default:
      return "alone";
  }
}

struct Box {
  double x0, y0, x1, y1;
  bool meets(const Box& other) const {
    return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
  }
};

void append_grid(std::string& out, const LogAxis& x, const LogAxis& y) {
  std::string grid, texts;
  const auto ticks = [](const LogAxis& axis, auto tick) {
    for (double decade = std::floor(axis.least); decade <= axis.most; ++decade)
      for (const double mantissa : {1.0, 3.0}) {
        const double value = mantissa * math::pow(10, decade), log = math::log10(value);
        if (log < axis.least - 1e-9 || log > axis.most + 1e-9) continue;
        // With many decades only the powers of ten have room.
        if (mantissa == 3.0 && axis.most - axis.least > 3) continue;
        if (axis.most - axis.least > 8 && std::fmod(std::abs(decade), 2) > 0.5) continue;
        tick(value);
      }
  };
  ticks(x, [&](double value) {
    append(grid, "M", coordinate(x.at(value)), " ", coordinate(bottom), "V", coordinate(top));
    append(texts, "<text x=\"", coordinate(x.at(value)), "\" y=\"", coordinate(bottom + 16),
           "\" text-anchor=\"middle\">", tick_text(value), "</text>");
  });
  ticks(y, [&](double value) {
    append(grid, "M", coordinate(left), " ", coordinate(y.at(value)), "H", coordinate(right));
    append(texts, "<text x=\"", coordinate(left - 6), "\" y=\"", coordinate(y.at(value) + 4),
           "\" text-anchor=\"end\">", tick_text(value), "</text>");
  });
  append(out, "<path class=\"grid\" d=\"", grid, "\"/>", texts);
  append(out, "<path class=\"axis\" d=\"M", coordinate(left), " ", coordinate(top));
  append(out, "V", coordinate(bottom), "H", coordinate(right), "\"/>");
}

// The fronts: for each truth the points that nothing beats, from left to right. Fewer than two make no line.
std::vector<std::vector<const Point*>> fronts_of(const std::vector<Point>& points) {
  std::map<std::string_view, std::vector<const Point*>> by_truth;
  for (const Point& p : points)
    if (p.row->verdict == Verdict::unbeaten) by_truth[p.row->truth].push_back(&p);
  std::vector<std::vector<const Point*>> out;
  for (auto& [truth, front] : by_truth)
    if (front.size() > 1) out.push_back(std::move(front));
  return out;
}

// Adds a front to `taken`, as small boxes.
void take_front(const std::vector<const Point*>& front, std::vector<Box>& taken) {
  for (std::size_t i = 1; i < front.size(); ++i) {
    const Point &a = *front[i - 1], &b = *front[i];
    const int steps = 1 + static_cast<int>(math::hypot(b.x - a.x, b.y - a.y) / 4);
    for (int step = 0; step <= steps; ++step) {
      const double x = std::lerp(a.x, b.x, double(step) / steps),
                   y = std::lerp(a.y, b.y, double(step) / steps);
      taken.push_back({x - 1, y - 1, x + 1, y + 1});
    }
  }
}

// Writes the name of a point right beside its dot, where it covers no other name, dot or front. The other
// points have their number alone. Points that nothing beats choose their places first.
void append_names(std::string& out, const std::vector<Point>& points) {
  std::vector<Box> taken;
  for (const Point& p : points) {
    taken.push_back({p.x - dot_radius - 1, p.y - dot_radius - 1, p.x + dot_radius + 1, p.y + dot_radius + 1});
    taken.push_back({p.first, p.y - 1, p.last, p.y + 1});
  }
  for (const auto& front : fronts_of(points)) take_front(front, taken);
  std::vector<const Point*> order;
  for (const bool best : {true, false})
    for (const Point& p : points)
      if ((p.row->verdict == Verdict::unbeaten) == best) order.push_back(&p);
  for (const Point* p : order) {
    const double w = letter_width * static_cast<double>(display_width(p->row->title));
    const auto free = [&](const Box& box) {
      return box.x0 >= left + 2 && box.x1 <= width - 2 &&
             std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return other.meets(box); });
    };
    // At the height of the dot, else just above or below the bar of the quartiles.
    bool named = false;
    for (const double dy : {0.0, -line_height, line_height})
      for (const double x : {p->x + label_gap, p->x - label_gap - w}) {
        const Box box{x, p->y + dy - line_height / 2, x + w, p->y + dy + line_height / 2};
        if (named || !free(box)) continue;
        named = true;
        taken.push_back({box.x0 - 4, box.y0, box.x1 + 4, box.y1});
        append(out, "<text class=\"name ", kind_of(*p->row), "\" x=\"", coordinate(x), "\" y=\"",
               coordinate(p->y + dy + 4), "\">", escape_html(p->row->title), "</text>");
      }
  }
}

// The errors of single materials above and below a dot; doubtful data as crosses.
void append_materials(std::string& out, const Point& p, const LogAxis& y) {
  std::string sound, doubtful;
  for (const ErrorPoint& one : p.row->points) {
    const std::string at = "M" + coordinate(p.x) + " " + coordinate(y.at(one.error));
    if (one.doubtful)
      append(doubtful, at, "m-3 -3l6 6m-6 0l6 -6");
    else
      append(sound, at, "h0");  // round caps make a dot of a line without length
  }
  if (!sound.empty()) append(out, "<path class=\"one\" d=\"", sound, "\"/>");
  if (!doubtful.empty()) append(out, "<path class=\"doubtful\" d=\"", doubtful, "\"/>");
}

void append_dot(std::string& out, const Point& p, const ErrorTimeTable& table) {
  const ErrorMetric& metric = table.metrics[table.plotted];
  append(out, "<g class=\"dot ", kind_of(*p.row), "\"><circle cx=\"", coordinate(p.x), "\" cy=\"",
         coordinate(p.y), "\" r=\"", number(dot_radius, 2), "\"/><text x=\"", coordinate(p.x), "\" y=\"",
         coordinate(p.y + 3.2), "\">", std::to_string(p.number), "</text><title>");
  append(out, escape_html(p.row->title), ": ", number(p.row->errors[table.plotted], 3), " ",
         escape_html(metric.unit), ", ", number(p.row->time->median_ns, 3), " ", escape_html(table.time_unit),
         ", ", name(p.row->verdict), "</title></g>");
}

// The least and the largest of positive values.
struct PositiveRange {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  void add(double value) {
    if (!(value > nothing_shown) || !std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

// The parts of the plot between the tags of the element; empty where no row was timed.
std::string scatter(const ErrorTimeFamily& family, const ErrorTimeTable& table) {
  PositiveRange times, errors;
  bool exact_rows = false;
  for (const ErrorTimeRow& row : table.rows) {
    if (!row.time) continue;
    times.add(std::max(row.time->first_quartile_ns, 1e-6));
    times.add(row.time->third_quartile_ns);
    errors.add(row.errors[table.plotted]);
    for (const ErrorPoint& one : row.points) errors.add(one.error);
    exact_rows = exact_rows || !(row.errors[table.plotted] > nothing_shown);
  }
  if (!(times.most > 0)) return {};
  if (!(errors.most > 0)) errors = {0.1, 1};
  const LogAxis x(times.least, times.most, left, right);
  const LogAxis y(exact_rows ? errors.least / 10 : errors.least, errors.most, bottom, top);

  std::vector<Point> points;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (const ErrorTimeRow& row = table.rows[i]; row.time)
      points.push_back({&row, i + 1, x.at(row.time->median_ns), y.at(row.errors[table.plotted]),
                        x.at(row.time->first_quartile_ns), x.at(row.time->third_quartile_ns)});
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.row->id < b.row->id; });

  const ErrorMetric& metric = table.metrics[table.plotted];
  std::string out = "<title>" + escape_html(family.title + ": " + table.title) + "</title><desc>";
  append(
      out,
      "Run time across, error up; both logarithmic. Points to the same truth that nothing beats are joined.</desc>");
  append_grid(out, x, y);
  append(out, "<text class=\"label\" x=\"6\" y=\"14\">", escape_html(metric.title));
  append(out, metric.unit.empty() ? "" : ", ", escape_html(metric.unit),
         exact_rows ? " (none: on the axis)" : "", "</text>");
  append(out, "<text class=\"label\" x=\"", coordinate((left + right) / 2), "\" y=\"",
         coordinate(bottom + 36), "\" text-anchor=\"middle\">", escape_html(table.time_unit), "</text>");
  for (const Point& p : points) append_materials(out, p, y);
  for (const auto& front : fronts_of(points)) {
    out += "<path class=\"front\" d=\"";
    for (const Point* p : front)
      append(out, p == front.front() ? "M" : " ", coordinate(p->x), " ", coordinate(p->y));
    out += "\"/>";
  }
  for (const Point& p : points)
    append(out, "<path class=\"range ", kind_of(*p.row), "\" d=\"M", coordinate(p.first), " ",
           coordinate(p.y), "H", coordinate(p.last), "\"/>");
  append_names(out, points);
  // Where dots meet, those that nothing beats lie on top.
  for (const bool best : {false, true})
    for (const Point& p : points)
      if ((p.row->verdict == Verdict::unbeaten) == best) append_dot(out, p, table);
  return out;
}

constexpr std::string_view plot_rules = R"css(
.scatter text { fill: var(--ink-soft); font: 12px system-ui, "DejaVu Sans", sans-serif; font-variant-numeric: tabular-nums; }
.scatter .label, .scatter .name { fill: var(--ink); }
.scatter .name { font-size: 11px; }
.scatter .name.grey { fill: var(--ink-soft); }
.scatter .grid { stroke: var(--line); fill: none; stroke-width: 0.75; }
.scatter .axis { stroke: var(--ink-soft); fill: none; }
.scatter .front { stroke: var(--plot-1); fill: none; stroke-width: 1.5; }
.scatter .range { fill: none; stroke-width: 1.5; stroke: var(--ink-soft); }
.scatter .range.best { stroke: var(--plot-1); }
.scatter .one { stroke: var(--ink-soft); stroke-width: 3; stroke-linecap: round; opacity: 0.45; fill: none; }
.scatter .doubtful { stroke: var(--plot-2); stroke-width: 1.2; fill: none; }
.scatter .dot circle { fill: var(--card); stroke: var(--ink-soft); }
.scatter .dot.best circle { fill: var(--plot-1); stroke: var(--plot-1); }
.scatter .dot.open circle { fill: var(--plot-2); stroke: var(--plot-2); }
.scatter .dot.alone circle { stroke-dasharray: 2 2; }
.scatter .dot text { font-size: 9px; text-anchor: middle; fill: var(--ink); }
.scatter .dot.best text, .scatter .dot.open text { fill: var(--card); }
)css";

}  // namespace

std::string_view error_time_plot_css() {
  return plot_rules;
}

std::string error_time_svg(const ErrorTimeFamily& family, const ErrorTimeTable& table) {
  const std::string inside = scatter(family, table);
  if (inside.empty()) return {};
  return "<svg class=\"scatter\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 400\" "
         "role=\"img\">" +
         inside + "</svg>";
}

std::string error_time_svg_file(const ErrorTimeFamily& family, const ErrorTimeTable& table) {
  const std::string inside = scatter(family, table);
  if (inside.empty()) return {};
  // Programs that draw SVG do not all know custom properties.
  const PlotColors& colors = plot_colors(false);
  std::string style(plot_rules);
  for (const auto& [property, color] :
       {std::pair<std::string_view, std::string_view>{"var(--ink)", colors.ink},
        {"var(--ink-soft)", colors.ink_soft},
        {"var(--line)", colors.line},
        {"var(--card)", colors.background},
        {"var(--plot-1)", colors.series[0]},
        {"var(--plot-2)", colors.series[1]}})
    for (std::size_t at = 0; (at = style.find(property, at)) != style.npos;)
      style.replace(at, property.size(), color);
  // What the numbers mean, in two columns below the plot.
  std::string names;
  const std::size_t half = (table.rows.size() + 1) / 2;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    append(names, "<text class=\"name\" x=\"", coordinate(i < half ? 20 : 330), "\" y=\"",
           coordinate(410 + 15 * static_cast<double>(i % half)), "\">", std::to_string(i + 1), "  ",
           escape_html(table.rows[i].title), table.rows[i].time ? "" : " (not timed)", "</text>");
  const std::string height = std::to_string(410 + 15 * half);
  return "<svg class=\"scatter\" xmlns=\"http://www.w3.org/2000/svg\" width=\"1280\" viewBox=\"0 0 640 " +
         height + "\" role=\"img\"><style>" + style + "</style><rect width=\"640\" height=\"" + height +
         "\" fill=\"" + std::string(colors.background) + "\"/>" + inside + names + "</svg>\n";
}

}  // namespace etak
