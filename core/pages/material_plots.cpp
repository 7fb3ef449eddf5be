// SPDX-License-Identifier: Apache-2.0
#include "core/pages/material_plots.h"

#include <algorithm>
#include <array>
#include <cmath>

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

double seen(const Vec3& rgb, PlotChannel channel) {
  return channel == PlotChannel::luminance ? luminance_of(rgb) : rgb[static_cast<std::size_t>(channel)];
}

std::vector<double> seen(const std::vector<Vec3>& all, PlotChannel channel) {
  std::vector<double> out;
  for (const Vec3& rgb : all) out.push_back(seen(rgb, channel));
  return out;
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
    plot.description = "reflectance data: no n and k";
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
  constexpr std::array<const char*, 4> channels{"red", "green", "blue", "luminance"};
  LinePlot plot;
  plot.title = name + ": F over the angle of incidence";
  plot.x = {"angle of incidence, degrees", 0, 90, {0, 15, 30, 45, 60, 75, 90}};
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
  plot.left = nice_axis(std::string("F, ") + channels[static_cast<std::size_t>(channel)], extent.least,
                        std::max(extent.most, 1.0));
  plot.description = curves.exact.empty() ? "no exact curve: the data are reflectance at normal incidence"
                                          : "errors are the largest over angles, red, green and blue";
  return plot;
}

PolarPlot lobe_plot(const std::string& name, const LobeCurve& lobe, RadialScale scale) {
  PolarPlot plot;
  plot.title = name + ": f_r in the plane of incidence";
  plot.scale = scale;
  plot.light_deg = lobe.light_deg;
  bool grey = true;
  double most = 0;
  for (const Vec3& rgb : lobe.rgb) {
    grey = grey && rgb[0] == rgb[1] && rgb[1] == rgb[2];
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
