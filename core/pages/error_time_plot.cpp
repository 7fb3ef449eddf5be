// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/pages/error_time_report.h"

namespace etak {
namespace {

constexpr double width = 640;
constexpr double left = 66, right = 612, top = 26, bottom = 350;
constexpr double letter_width = 6.3, line_height = 13, label_gap = 8;
// With more points than this, only points that nothing beats may have their name far away at the end of a
// thin line; other names stand beside their points or are left out, because a web of thin lines says less
// than the table below the plot.
constexpr std::size_t most_named = 14;
constexpr double nothing_shown = 1e-15;  // errors below it are drawn on the axis: rounding, not error

// A logarithmic axis over whole or half decades.
struct LogAxis {
  double least = 0, most = 1;  // log10 of the values at its ends
  double from = 0, to = 1;     // coordinates of its ends in the SVG

  LogAxis(double smallest, double largest, double from_, double to_) : from(from_), to(to_) {
    least = std::floor(std::log10(smallest) * 2 - 0.2) / 2;
    most = std::ceil(std::log10(largest) * 2 + 0.2) / 2;
    if (most - least < 1) least -= 0.5, most += 0.5;
  }
  double at(double value) const {
    const double log = std::clamp(std::log10(std::max(value, 1e-300)), least, most);
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
  double x, y;
  double first, last;  // x of the quartiles
};

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
        const double value = mantissa * std::pow(10, decade), log = std::log10(value);
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

// Adds the line through the points that nothing beats to `taken`, as small boxes.
void take_front(const std::vector<Point>& points, std::vector<Box>& taken) {
  const Point* before = nullptr;
  for (const Point& p : points) {
    if (!p.row->pareto) continue;
    if (before != nullptr) {
      const int steps = 1 + static_cast<int>(std::hypot(p.x - before->x, p.y - before->y) / 4);
      for (int i = 0; i <= steps; ++i) {
        const double x = std::lerp(before->x, p.x, double(i) / steps),
                     y = std::lerp(before->y, p.y, double(i) / steps);
        taken.push_back({x - 1, y - 1, x + 1, y + 1});
      }
    }
    before = &p;
  }
}

// Writes the name of each point where it covers no other name, point or line: at the point's right or left,
// else above or below it in growing distance, with a thin line where it stands far off. Points that nothing
// beats choose their places first.
void append_labels(std::string& out, const std::vector<Point>& points) {
  std::vector<Box> taken;
  for (const Point& p : points) taken.push_back({p.x - 5, p.y - 5, p.x + 5, p.y + 5});
  for (const Point& p : points) taken.push_back({p.first - 2, p.y - 2, p.last + 2, p.y + 2});
  take_front(points, taken);
  std::vector<std::size_t> order;
  for (const bool best : {true, false})
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].row->pareto == best) order.push_back(i);
  for (const std::size_t i : order) {
    const Point& p = points[i];
    const int furthest = p.row->pareto || points.size() <= most_named ? 14 : 2;
    const double w = letter_width * static_cast<double>(display_width(p.row->title));
    const auto box = [&](double dx, double dy, int side) {
      const double x0 = side > 0 ? p.x + dx : side < 0 ? p.x - dx - w : p.x - w / 2;
      return Box{x0, p.y + dy - line_height / 2, x0 + w, p.y + dy + line_height / 2};
    };
    std::vector<Box> places;
    for (int step = 0; step < furthest; ++step) {
      const double off = line_height * step * 0.9;
      for (const double dy : {-off, off}) {
        places.push_back(box(label_gap, dy, 1));
        places.push_back(box(label_gap, dy, -1));
        if (step > 0) places.push_back(box(0, dy, 0));
      }
    }
    const auto free = [&](const Box& b) {
      if (b.x0 < left + 2 || b.x1 > width - 2 || b.y0 < top - 6 || b.y1 > bottom - 2) return false;
      return std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return other.meets(b); });
    };
    const auto found = std::find_if(places.begin(), places.end(), free);
    if (found == places.end()) continue;  // its name is in the table below the plot
    taken.push_back({found->x0 - 4, found->y0, found->x1 + 4, found->y1});
    const double middle = (found->y0 + found->y1) / 2;
    if (std::abs(middle - p.y) > line_height) {
      const double x = std::clamp(p.x, found->x0, found->x1);
      append(out, "<path class=\"leader\" d=\"M", coordinate(p.x), " ", coordinate(p.y));
      append(out, "L", coordinate(x), " ", coordinate(middle < p.y ? found->y1 : found->y0), "\"/>");
    }
    append(out, "<text class=\"", p.row->dominated ? "name grey" : "name", "\" x=\"", coordinate(found->x0));
    append(out, "\" y=\"", coordinate(middle + 4), "\">", escape_html(p.row->title), "</text>");
  }
}

}  // namespace

std::string error_time_svg(const ErrorTimeFamily& family, const ErrorTimeTable& table) {
  double least_time = std::numeric_limits<double>::infinity(), most_time = 0;
  double least_error = std::numeric_limits<double>::infinity(), most_error = 0;
  for (const ErrorTimeRow& row : table.rows) {
    if (!row.time) continue;
    least_time = std::min(least_time, std::max(row.time->first_quartile_ns, 1e-6));
    most_time = std::max(most_time, row.time->third_quartile_ns);
    if (row.errors[table.plotted] > nothing_shown && std::isfinite(row.errors[table.plotted])) {
      least_error = std::min(least_error, row.errors[table.plotted]);
      most_error = std::max(most_error, row.errors[table.plotted]);
    }
  }
  if (!(most_time > 0)) return {};
  if (!(most_error > 0)) least_error = 0.1, most_error = 1;
  const bool exact_rows = std::any_of(table.rows.begin(), table.rows.end(), [&](const ErrorTimeRow& row) {
    return row.time && !(row.errors[table.plotted] > nothing_shown);
  });
  const LogAxis x(least_time, most_time, left, right);
  const LogAxis y(exact_rows ? least_error / 10 : least_error, most_error, bottom, top);

  std::vector<Point> points;
  for (const ErrorTimeRow& row : table.rows)
    if (row.time)
      points.push_back({&row, x.at(row.time->median_ns), y.at(row.errors[table.plotted]),
                        x.at(row.time->first_quartile_ns), x.at(row.time->third_quartile_ns)});
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.row->id < b.row->id; });

  const ErrorMetric& metric = table.metrics[table.plotted];
  std::string out =
      "<svg class=\"scatter\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 400\" role=\"img\">";
  append(out, "<title>", escape_html(family.title + ": " + table.title), "</title><desc>");
  append(out, "Run time across, error up; both logarithmic. Points that nothing beats are joined.</desc>");
  append_grid(out, x, y);
  append(out, "<text class=\"label\" x=\"6\" y=\"14\">", escape_html(metric.title));
  append(out, metric.unit.empty() ? "" : ", ", escape_html(metric.unit),
         exact_rows ? " (none: on the axis)" : "", "</text>");
  append(out, "<text class=\"label\" x=\"", coordinate((left + right) / 2), "\" y=\"",
         coordinate(bottom + 36), "\" text-anchor=\"middle\">", escape_html(table.time_unit), "</text>");

  std::string front;
  for (const Point& p : points)
    if (p.row->pareto) append(front, front.empty() ? "M" : " ", coordinate(p.x), " ", coordinate(p.y));
  if (!front.empty()) append(out, "<path class=\"front\" d=\"", front, "\"/>");
  for (const Point& p : points) {
    const RunTime& time = *p.row->time;
    const std::string_view kind = p.row->pareto ? "best" : p.row->dominated ? "grey" : "other";
    append(out, "<path class=\"range ", kind, "\" d=\"M", coordinate(p.first), " ");
    append(out, coordinate(p.y), "H", coordinate(p.last), "\"/>");
    append(out, "<circle class=\"", kind, "\" cx=\"", coordinate(p.x), "\" cy=\"", coordinate(p.y),
           "\" r=\"4\"><title>");
    append(out, escape_html(p.row->title), ": ", number(p.row->errors[table.plotted], 3), " ",
           escape_html(metric.unit));
    append(out, ", ", number(time.median_ns, 3), " ", escape_html(table.time_unit), "</title></circle>");
  }
  append_labels(out, points);
  return out += "</svg>";
}

}  // namespace etak
