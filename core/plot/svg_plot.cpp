// SPDX-License-Identifier: Apache-2.0
// Based on:
//   Ramer 1972, "An iterative procedure for the polygonal approximation of plane curves"
//   Douglas and Peucker 1973, "Algorithms for the reduction of the number of points ..."
#include "core/plot/svg_plot.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/math/functions.h"
#include "core/plot/plot_file.h"

namespace etak {
namespace {

constexpr double plot_top = 30, plot_bottom = 222;
constexpr double digit_width = 8;  // of the numbers at ticks; enough for every usual font
constexpr double strip_height = 5;
constexpr std::size_t most_points = 120;
constexpr double line_tolerance = 0.2;

struct Point {
  double x, y;
};

// ---- fewer points

double distance(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = math::hypot(dx, dy);
  if (length == 0) return math::hypot(p.x - a.x, p.y - a.y);
  return std::abs(dx * (a.y - p.y) - (a.x - p.x) * dy) / length;
}

std::vector<Point> simplified(const std::vector<Point>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<char> keep(points.size(), 0);
  keep.front() = keep.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double most = tolerance;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance(points[i], points[first], points[last]);
      if (d > most) most = d, at = i;
    }
    if (at == 0) continue;
    keep[at] = 1;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<Point> out;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (keep[i]) out.push_back(points[i]);
  return out;
}

std::vector<Point> few(const std::vector<Point>& points) {
  std::vector<Point> out = simplified(points, line_tolerance);
  for (double t = 2 * line_tolerance; out.size() > most_points; t *= 1.5) out = simplified(points, t);
  return out;
}

// ---- numbers

std::string coordinate(double value) {
  std::string text = fixed(value, 1);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

// Ticks are multiples of a round step. They are written with as many decimals as the step needs, or with a
// power of ten where that would be long.
std::string tick_text(double value, double step) {
  if (value == 0) return "0";
  const int digits_after_point = std::max(0, -static_cast<int>(std::floor(math::log10(step) + 1e-9)));
  if (std::abs(value) < 1e5 && digits_after_point <= (std::abs(value) < 0.1 ? 4 : 8))
    return fixed(value, digits_after_point);
  const double decades =
      std::floor(math::log10(std::abs(value)) + 1e-9) - std::floor(math::log10(step) + 1e-9);
  std::array<char, 64> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific,
                                 std::clamp(static_cast<int>(decades), 0, 17))
                       .ptr;
  std::string out(text.data(), end);  // "2e-08" becomes "2e-8", and "2e+06" becomes "2e6"
  const auto exponent = out.find_last_of("+-") + 1;
  if (out[exponent] == '0') out.erase(exponent, 1);
  if (out[exponent - 1] == '+') out.erase(exponent - 1, 1);
  return out;
}

double step_of(const PlotAxis& axis) {
  return axis.ticks.size() > 1 ? axis.ticks[1] - axis.ticks[0] : axis.most - axis.least;
}

// Width of the margin beside an axis: the widest number at a tick, the tick and a gap.
double margin(const PlotAxis& axis) {
  std::size_t longest = 3;
  for (const double tick : axis.ticks) longest = std::max(longest, tick_text(tick, step_of(axis)).size());
  return 14 + digit_width * static_cast<double>(longest);
}

// ---- drawing

struct Frame {
  const LinePlot& plot;
  double left_edge, right_edge;

  double x(double value) const {
    return left_edge + (value - plot.x.least) / (plot.x.most - plot.x.least) * (right_edge - left_edge);
  }
  static double y(double value, const PlotAxis& axis) {
    return plot_bottom - (value - axis.least) / (axis.most - axis.least) * (plot_bottom - plot_top);
  }
};

void append_text(std::string& out, double x, double y, std::string_view anchor, std::string_view text,
                 std::string_view more = {}) {
  append(out, "<text x=\"", coordinate(x), "\" y=\"", coordinate(y));
  append(out, "\" text-anchor=\"", anchor, "\"", more, ">");
  append(out, escape_html(text), "</text>");
}

void append_axes(std::string& out, const Frame& frame) {
  const LinePlot& plot = frame.plot;
  std::string grid;
  for (const double tick : plot.left.ticks)
    grid += "M" + coordinate(frame.left_edge) + " " + coordinate(Frame::y(tick, plot.left)) + "H" +
            coordinate(frame.right_edge);
  for (const double tick : plot.x.ticks)
    grid += "M" + coordinate(frame.x(tick)) + " " + coordinate(plot_bottom) + "V" + coordinate(plot_top);
  append(out, "<path class=\"grid\" d=\"", grid, "\"/>");
  double shade = 0;
  for (const PlotZone& zone : plot.zones) {
    const double left = frame.x(zone.first), right = frame.x(zone.last);
    append(out, "<rect x=\"", coordinate(left), "\" y=\"", coordinate(plot_top), "\" width=\"",
           coordinate(right - left), "\" height=\"", coordinate(plot_bottom - plot_top),
           "\" fill=\"#808080\" fill-opacity=\"", fixed(shade, 2), "\"/>");
    append_text(out, (left + right) / 2, plot_top - 4, "middle", zone.text);
    shade += 0.12;
  }
  for (const double tick : plot.left.ticks)
    append_text(out, frame.left_edge - 6, Frame::y(tick, plot.left) + 4, "end",
                tick_text(tick, step_of(plot.left)));
  const double below = plot_bottom + (plot.strip.empty() ? 0 : strip_height);
  for (const double tick : plot.x.ticks)
    append_text(out, frame.x(tick), below + 15, "middle", tick_text(tick, step_of(plot.x)));
  append_text(out, (frame.left_edge + frame.right_edge) / 2, below + 33, "middle", plot.x.label,
              " class=\"label\"");
  append_text(out, 6, 16, "start", plot.left.label, " class=\"label\"");
  if (plot.right) {
    std::string marks;
    for (const double tick : plot.right->ticks) {
      const double y = Frame::y(tick, *plot.right);
      marks += "M" + coordinate(frame.right_edge) + " " + coordinate(y) + "h4";
      append_text(out, frame.right_edge + 7, y + 4, "start", tick_text(tick, step_of(*plot.right)));
    }
    append(out, "<path class=\"axis\" d=\"", marks, "\"/>");
    append_text(out, plot_width - 6, 16, "end", plot.right->label, " class=\"label\"");
  }
  if (!plot.strip.empty())
    append(out, "<rect x=\"", coordinate(frame.left_edge), "\" y=\"", coordinate(plot_bottom), "\" width=\"",
           coordinate(frame.right_edge - frame.left_edge), "\" height=\"", coordinate(strip_height),
           "\" fill=\"", plot.strip, "\"/>");
  append(out, "<path class=\"axis\" d=\"M", coordinate(frame.left_edge), " ", coordinate(plot_top));
  append(out, "V", coordinate(plot_bottom), "H", coordinate(frame.right_edge), "\"/>");
}

void append_run(std::string& path, const std::vector<Point>& run) {
  if (run.empty()) return;
  bool first = true;
  for (const Point& p : few(run)) {
    append(path, first ? "M" : " ", coordinate(p.x), " ", coordinate(p.y));
    first = false;
  }
  if (run.size() == 1) path += "h0";  // round caps make a dot of a line without length
}

void append_curve(std::string& out, const PlotCurve& curve, const Frame& frame) {
  const PlotAxis& axis = curve.on_right && frame.plot.right ? *frame.plot.right : frame.plot.left;
  std::string path;
  std::vector<Point> run;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (std::isfinite(curve.y[i])) run.push_back({frame.x(curve.x[i]), Frame::y(curve.y[i], axis)});
    if (curve.dots || !std::isfinite(curve.y[i])) {
      append_run(path, run);
      run.clear();
    }
  }
  append_run(path, run);
  if (path.empty()) return;
  append(out, "<path class=\"curve ", escape_html(curve.css_class), "\" d=\"", path, "\"");
  if (curve.title.empty())
    out += "/>";
  else
    append(out, "><title>", escape_html(curve.title), "</title></path>");
}

// The legend stands in the middle above the plot, because the labels of the axes take the corners.
void append_keys(std::string& out, const LinePlot& plot) {
  constexpr double sample = 22, sample_gap = 5, key_gap = 14, per_letter = 7.4;
  const auto sample_width = [](const PlotKey& key) {
    return key.css_class.empty() ? 0 : sample + sample_gap;
  };
  const auto key_width = [&](const PlotKey& key) {
    return sample_width(key) + per_letter * static_cast<double>(display_width(key.text)) + key_gap;
  };
  double x = (plot_width + key_gap) / 2;
  for (const PlotKey& key : plot.keys) x -= key_width(key) / 2;
  for (const PlotKey& key : plot.keys) {
    if (!key.css_class.empty())
      append(out, "<path class=\"curve ", escape_html(key.css_class), "\" d=\"M", coordinate(x), " 12h",
             coordinate(sample), "\"/>");
    append_text(out, x + sample_width(key), 16, "start", key.text);
    x += key_width(key);
  }
}

}  // namespace

PlotAxis nice_axis(std::string label, double least, double most, int count) {
  PlotAxis axis;
  axis.label = std::move(label);
  if (!std::isfinite(least) || !std::isfinite(most)) least = 0, most = 1;
  if (least > 0 && least < most / 2) least = 0;
  if (!(most - least > 1e-6 * std::max(std::abs(most), std::abs(least)))) {
    const double half = most == 0 ? 0.5 : std::abs(most) / 20;
    least -= half;
    most += half;
  }
  const double rough = (most - least) / count;
  const double power = math::pow(10, std::floor(math::log10(rough)));
  const double mantissa = rough / power;
  const double step = power * (mantissa < 1.5 ? 1 : mantissa < 3.5 ? 2 : mantissa < 7.5 ? 5 : 10);
  const double first = std::floor(least / step + 1e-9), last = std::ceil(most / step - 1e-9);
  for (double i = first; i <= last; ++i) axis.ticks.push_back(i * step);
  axis.least = axis.ticks.front();
  axis.most = axis.ticks.back();
  return axis;
}

std::string tick_text(const PlotAxis& axis, double tick) {
  return tick_text(tick, step_of(axis));
}

std::string svg(const LinePlot& plot) {
  const Frame frame{plot, margin(plot.left), plot_width - (plot.right ? margin(*plot.right) : 14)};
  std::string out = "<svg class=\"plot\" viewBox=\"0 0 460 270\" role=\"img\"><title>";
  append(out, escape_html(plot.title), "</title>");
  if (!plot.description.empty()) append(out, "<desc>", escape_html(plot.description), "</desc>");
  append_axes(out, frame);
  for (const PlotCurve& curve : plot.curves) append_curve(out, curve, frame);
  append_keys(out, plot);
  return out += "</svg>";
}

std::string_view plot_css() {
  return R"css(
.plot { display: block; width: 100%; max-width: 560px; height: auto; }
.plot text { fill: var(--ink-soft); font-size: 12px; font-variant-numeric: tabular-nums; }
.plot .label { fill: var(--ink); }
.plot .grid { stroke: var(--line); fill: none; stroke-width: 0.75; }
.plot .axis { stroke: var(--ink-soft); fill: none; }
.plot .curve { fill: none; stroke-width: 1; stroke-linejoin: round; stroke-linecap: round; opacity: 0.55; }
.plot .curve.bold { stroke-width: 2.2; opacity: 1; }
.plot .curve.dots { stroke-width: 4.4; opacity: 1; }
.plot .curve.dashed { stroke-dasharray: 6 4; }
.plot .c1 { stroke: var(--plot-1); }
.plot .c2 { stroke: var(--plot-2); }
.plot .c3 { stroke: var(--plot-3); }
@media (max-width: 600px) { .plot text { font-size: 14px; } }
)css";
}

}  // namespace etak
