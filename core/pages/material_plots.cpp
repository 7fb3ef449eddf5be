// SPDX-License-Identifier: Apache-2.0
#include "core/pages/material_plots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/color/luminance.h"
#include "core/pages/plot_axes.h"

namespace etak {
namespace {

// Draws the rows of the published table as dots on a curve. Formulas have no rows and get no dots.
void add_samples(LinePlot& plot, const PlotCurve& curve, const std::vector<double>& sample_nm,
                 const char* css_class) {
  constexpr std::size_t too_many = 120;  // more dots than this would touch each other
  if (sample_nm.empty() || sample_nm.size() > too_many) return;
  PlotCurve dots;
  dots.css_class = css_class;
  dots.title = "samples";
  dots.dots = true;
  dots.on_right = curve.on_right;
  for (const double nm : sample_nm) {
    const double y = value_at(curve, nm);
    if (!std::isfinite(y)) continue;
    dots.x.push_back(nm);
    dots.y.push_back(y);
  }
  plot.keys.push_back({css_class, "samples"});
  plot.curves.push_back(std::move(dots));
}

bool is_grey(const Vec3& rgb) {
  return rgb[0] == rgb[1] && rgb[1] == rgb[2];
}

double seen(const Vec3& rgb, PlotChannel channel) {
  return channel == PlotChannel::luminance && !is_grey(rgb)
             ? luminance_of(rgb)
             : rgb[channel == PlotChannel::luminance ? 0 : static_cast<std::size_t>(channel)];
}

std::vector<double> seen(const std::vector<Vec3>& all, PlotChannel channel) {
  std::vector<double> out;
  for (const Vec3& rgb : all) out.push_back(seen(rgb, channel));
  return out;
}

std::string channel_name(PlotChannel channel) {
  return std::string(plot_channels[static_cast<std::size_t>(channel)]);
}

PlotAxis angle_axis(std::string label, double first_deg) {
  PlotAxis out{std::move(label), first_deg, 90, {}};
  for (double tick = first_deg; tick <= 90; tick += first_deg < 0 ? 30 : 15) out.ticks.push_back(tick);
  return out;
}

std::vector<PlotZone> fresnel_zones() {
  return {{0, 45, "barely changes"}, {45, 75, "changes"}, {75, 90, "to white"}};
}

// Two significant digits, because the clock is no more precise; empty where nothing was timed.
std::string time_text(double ns) {
  if (!(ns > 0)) return "";
  return ns < 1000 ? ", " + number(ns, 2) + " ns" : ", " + number(ns / 1000, 2) + " µs";
}

}  // namespace

LinePlot index_plot(const std::string& name, const OpticsCurves& curves) {
  LinePlot plot;
  plot.title = name + ": n and k over wavelength";
  plot.x = wavelength_axis();
  Extent n, k;
  n.add(curves.n);
  k.add(curves.k);
  plot.left = n.empty() ? nice_axis("n", 0, 1) : nice_axis("n", n.least, n.most);
  if (n.empty()) {
    plot.description = "no n and k: reflectance data, or layers of several media";
    return plot;
  }
  plot.description = "n " + number(n.least, 4) + " to " + number(n.most, 4) +
                     (k.empty() ? ", no k given" : ", k " + number(k.least, 4) + " to " + number(k.most, 4));
  const bool k_shown = !k.empty() && k.most > 0;
  plot.keys.push_back({"c1 bold", k_shown ? "n (left)" : "n"});
  plot.curves.push_back({curves.n_nm, curves.n, "c1 bold", "n", false, false});
  if (k_shown) {
    plot.right = nice_axis("k", k.least, k.most);
    plot.keys.push_back({"c2 bold dashed", "k (right)"});
    plot.curves.push_back({curves.k_nm, curves.k, "c2 bold dashed", "k", true, false});
  } else {
    plot.keys.push_back({"", k.empty() ? "k not given" : "k = 0"});
  }
  add_samples(plot, PlotCurve(plot.curves.front()), curves.sample_nm, "c1 dots");
  return plot;
}

LinePlot reflectance_plot(const std::string& name, const OpticsCurves& curves, Observer observer) {
  LinePlot plot;
  plot.title = name + ": reflectance over wavelength";
  plot.x = wavelength_axis();
  Extent r;
  r.add(curves.r0);
  r.add(curves.r82);
  plot.left = nice_axis("R", 0, r.empty() ? 1 : r.most);
  plot.right = nice_axis("x̄, ȳ, z̄", 0, 2);
  constexpr std::array<const char*, 3> names{"x̄", "ȳ", "z̄"};
  constexpr std::array<const char*, 3> classes{"c7 dotted", "c8 dotted", "c9 dotted"};
  const auto matching = matching_functions(observer);
  std::vector<double> nm;
  for (std::size_t i = 0; i < matching.size(); ++i) nm.push_back(grid_first_nm + static_cast<double>(i));
  for (std::size_t c = 0; c < 3; ++c) {
    PlotCurve curve{nm, {}, classes[c], names[c], true, false};
    for (const auto& row : matching) curve.y.push_back(row[c]);
    plot.curves.push_back(std::move(curve));
  }
  if (!curves.r82.empty()) {
    plot.curves.push_back({curves.r_nm, curves.r82, "c2 bold dashed", "R at 81.8°", false, false});
    plot.keys.push_back({"c2 bold dashed", "R at 81.8° (F82)"});
  }
  if (!curves.r0.empty()) {
    plot.curves.push_back({curves.r_nm, curves.r0, "c3 bold", "R at 0°", false, false});
    plot.keys.insert(plot.keys.begin(), {"c3 bold", "R at 0° (F0)"});
    add_samples(plot, PlotCurve(plot.curves.back()), curves.sample_nm, "c3 dots");
  }
  for (std::size_t c = 0; c < 3; ++c) plot.keys.push_back({classes[c], names[c]});
  if (!r.empty())
    plot.description = "reflectance " + number(r.least, 3) + " to " + number(r.most, 3) +
                       ", with the colour-matching functions of the " + std::string(etak::name(observer)) +
                       " observer";
  return plot;
}

LinePlot angle_plot(const std::string& name, const AngleCurves& curves, PlotChannel channel) {
  constexpr std::array<const char*, 5> classes{"c1 dashed", "c2 dashdot", "c4", "c5 dashed",
                                               "c6 dotted bold"};
  LinePlot plot;
  plot.title = name + ": F over the angle of incidence";
  plot.x = angle_axis("angle of incidence, degrees", 0);
  Extent extent;
  const auto add = [&](const std::vector<Vec3>& rgb, const char* css_class, std::string title,
                       std::string key) {
    PlotCurve curve{curves.angle_deg, seen(rgb, channel), css_class, std::move(title), false, false};
    extent.add(curve.y);
    plot.curves.push_back(std::move(curve));
    plot.keys.push_back({css_class, std::move(key), plot.curves.back().title});
  };
  if (!curves.exact.empty()) {
    const std::string time = time_text(curves.exact_ns);
    add(curves.exact, "c3 bold", "exact", "exact, 471 wavelengths" + time);
  }
  for (std::size_t i = 0; i < curves.forms.size(); ++i) {
    const AngleCurve& form = curves.forms[i];
    std::string key(form.title);
    if (!curves.exact.empty())
      key += ": error " + number(form.error.max_abs, 2) + " at " + number(form.error.at_deg, 3) + "°";
    add(form.rgb, classes[i % classes.size()], std::string(form.title), key + time_text(form.ns));
  }
  plot.left = nice_axis("F, " + channel_name(channel), extent.least, std::max(extent.most, 1.0));
  plot.zones = fresnel_zones();
  plot.description = curves.exact.empty() ? "no exact curve: the data are reflectance at normal incidence"
                                          : "errors are the largest over angles, red, green and blue";
  return plot;
}

LinePlot curves_plot(CurveKind kind, const std::vector<ColorCurve>& curves,
                     std::span<const PlotChannel> channels, double light_deg) {
  constexpr std::array<const char*, 4> dashes{"", " dashed", " dashdot", " dotted"};
  constexpr std::size_t colors = 6;  // c7 to c9 are red, green and blue
  struct Row {
    const char *title, *x, *y;
    double first_deg;
  };
  constexpr std::array<Row, 6> rows{
      Row{"F over the angle of incidence", "angle of incidence, degrees", "F", 0},
      Row{"D over the angle of the half vector", "angle between half vector and normal, degrees", "D, 1/sr",
          0},
      Row{"G in the plane of incidence", "angle of the viewer, degrees", "G", -90},
      Row{"V in the plane of incidence", "angle of the viewer, degrees", "V = G / (4 nl nv)", -90},
      Row{"f_r nl in the plane of incidence", "angle of the viewer, degrees", "f_r nl, 1/sr", -90},
      Row{"reflectance over wavelength", "", "R", 0}};
  const Row& row = rows[static_cast<std::size_t>(kind)];
  const bool by_color = channels.size() > 1;
  if (curves.size() > (by_color ? dashes.size() : colors * dashes.size()))
    throw Error::at("etak curve", std::to_string(curves.size()) + " curves in a plot",
                    by_color ? "at most 4 with all channels" : "at most 24");
  LinePlot plot;
  plot.title = row.title;
  plot.x = kind == CurveKind::reflectance ? wavelength_axis() : angle_axis(row.x, row.first_deg);
  Extent extent;
  bool grey = true;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const bool same = std::ranges::all_of(curves[i].rgb, is_grey);
    grey = grey && same;
    for (const PlotChannel channel : same ? channels.first(1) : channels) {
      const auto c = static_cast<std::size_t>(channel);
      std::string style =
          by_color && !same ? "c" + std::to_string(c + 7) : "c" + std::to_string(i % colors + 1);
      style += std::string(" bold") + dashes[by_color ? i : i / colors];
      std::string title = curves[i].title;
      if (by_color && !same) title += ", " + channel_name(channel);
      plot.curves.push_back({curves[i].x, seen(curves[i].rgb, channel), style, title, false, false});
      plot.keys.push_back({std::move(style), std::move(title)});
      extent.add(plot.curves.back().y);
    }
  }
  std::string label = row.y;
  if (!grey && !by_color) label += ", " + channel_name(channels[0]);
  const bool to_one = kind == CurveKind::fresnel || kind == CurveKind::masking;
  plot.left = nice_axis(std::move(label), std::min(0.0, extent.least),
                        to_one ? std::max(extent.most, 1.0) : extent.most);
  if (kind == CurveKind::fresnel) plot.zones = fresnel_zones();
  if (row.first_deg < 0) plot.x.label += ", light at " + number(-light_deg, 6);
  return plot;
}

PolarPlot polar_plot(const LinePlot& plot, double light_deg, RadialScale scale) {
  Extent extent;
  for (const PlotCurve& curve : plot.curves) extent.add(curve.y);
  return {plot.title, plot.description, radial_axis(plot.left.label, extent.most, scale), scale, plot.curves,
          plot.keys,  -light_deg};
}

std::string curves_json(const LinePlot& plot, std::string_view of) {
  const auto curve = [](const PlotCurve& each) {
    return json_object(
        {{"title", json(each.title)}, {"x", json_array_of(each.x)}, {"y", json_array_of(each.y)}}, 4);
  };
  const auto zone = [](const PlotZone& each) {
    return json_object({{"first", json(each.first)}, {"last", json(each.last)}, {"text", json(each.text)}},
                       -1);
  };
  return json_document("etak-curve/1", {{"of", json(of)},
                                        {"title", json(plot.title)},
                                        {"x", json(plot.x.label)},
                                        {"y", json(plot.left.label)},
                                        {"zones", '[' + joined(plot.zones, ", ", zone) + ']'},
                                        {"curves", json_lines_of(plot.curves, 2, curve)}});
}

PolarPlot lobe_plot(const std::string& name, const LobeCurve& lobe, RadialScale scale) {
  PolarPlot plot;
  plot.title = name + ": f_r in the plane of incidence";
  plot.scale = scale;
  plot.light_deg = lobe.light_deg;
  bool grey = true;
  double most = 0;
  for (const Vec3& rgb : lobe.rgb) {
    grey = grey && is_grey(rgb);
    for (const double value : rgb)
      if (std::isfinite(value)) most = std::max(most, value);
  }
  plot.radial = radial_axis("f_r, 1/sr", most, scale);
  plot.description = "light at " + number(std::abs(lobe.light_deg), 4) + " degrees; largest value " +
                     number(most, 4) + " per steradian";
  constexpr std::array<const char*, 3> classes{"c7", "c8 dashed", "c9 dashdot"},
      names{"red", "green", "blue"};
  for (std::size_t c = 0; c < (grey ? 1u : 3u); ++c) {
    PlotCurve curve{lobe.angle_deg,          {},    grey ? "c3 bold" : std::string(classes[c]) + " bold",
                    grey ? "f_r" : names[c], false, false};
    for (const Vec3& rgb : lobe.rgb) curve.y.push_back(rgb[c]);
    plot.keys.push_back({curve.css_class, curve.title});
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace etak
