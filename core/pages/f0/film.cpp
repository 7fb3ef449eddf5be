// SPDX-License-Identifier: Apache-2.0
// The colours of a stack over the thickness of one of its layers.
#include "core/pages/f0/film.h"

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/sweep.h"
#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/exchange/f0_worker.h"
#include "core/material/seen_stack.h"
#include "core/material/stack.h"
#include "core/material/stack_text.h"
#include "core/math/functions.h"
#include "core/pages/f0/report.h"

namespace etak {
namespace {

constexpr int last_angle = 85, angle_step = 5;  // degrees

// Sizes in the picture.
constexpr double picture_left = 60, picture_top = 40, picture_width = 800, cell_height = 14;

std::string rect(double x, double y, double width, double height, std::string_view fill) {
  return "<rect x=\"" + fixed(x, 2) + "\" y=\"" + fixed(y, 2) + "\" width=\"" + fixed(width, 2) +
         "\" height=\"" + fixed(height, 2) + "\" fill=\"" + std::string(fill) + "\"/>\n";
}

std::string label(double x, double y, std::string_view anchor, std::string_view text) {
  return "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) + "\" text-anchor=\"" + std::string(anchor) +
         "\">" + escape_html(text) + "</text>\n";
}

}  // namespace

FilmSweep film_sweep(const Stack& stack, const std::string& text) {
  SweepForm form;
  form.expected =
      "LAYER=FIRST:LAST:COUNT or LAYER=VALUE,VALUE,..., 2 to 1000 thicknesses, such as 1=0nm:400nm:81";
  form.most = 1000;
  form.unit = "nm";
  form.read = [](std::string_view part, double& nm) { return read_thickness(part, nm); };
  const Sweep sweep = parse_sweep(text, form);
  FilmSweep out{stack, 0, {}};
  if (const auto layer = whole_number<std::size_t>(sweep.name))
    out.layer = *layer;
  else
    throw Error::at(setting("sweep"), printable(sweep.name), "the number of a layer, the outermost being 1");
  for (const std::string& value : sweep.values)
    if (double nm = 0; read_thickness(value, nm))
      out.thickness_nm.push_back(nm);
    else
      throw Error::at(setting("sweep"), printable(value), form.expected);
  (void)with_thickness(stack, out.layer, 0);  // which refuses a layer that is not there
  return out;
}

std::vector<F0Row> film_rows(const FilmSweep& sweep, const F0Solver& solver, const Material& material,
                             const Dataset& dataset) {
  std::vector<F0Row> out;
  for (const double nm : sweep.thickness_nm) {
    Dataset one = dataset;
    one.optics = with_thickness(sweep.stack, sweep.layer, nm);
    F0Row& row = out.emplace_back();
    set_record(row, material, one);
    row.path = std::get<Stack>(one.optics).text;
    row.result = solver.solve(one.optics, one.flags);
  }
  return out;
}

std::string film_csv(const FilmSweep& sweep, std::span<const F0Row> rows) {
  std::string out = "thickness_nm," + f0_csv_header();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    append(out, number(sweep.thickness_nm[i], 9), ',');
    append_f0_csv(out, rows[i]);
  }
  return out;
}

std::string film_strip(const FilmSweep& sweep, const F0Options& options) {
  SeenStack seen(sweep.stack, options);
  const std::size_t count = sweep.thickness_nm.size();
  const double cell = picture_width / static_cast<double>(count);
  const int rows = last_angle / angle_step + 1;
  const double bottom = picture_top + rows * cell_height;
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"" +
                    fixed(bottom + 50, 0) + "\" font-family=\"sans-serif\" font-size=\"12\">\n" +
                    rect(0, 0, 900, bottom + 50, "#ffffff") +
                    label(picture_left, 22, "start", sweep.stack.text);
  for (std::size_t i = 0; i < count; ++i) {
    seen.set_thickness(sweep.layer - 1, sweep.thickness_nm[i]);
    for (int row = 0; row < rows; ++row) {
      const LinearRgb color = to_rgb(seen(math::cos(row * angle_step * std::numbers::pi / 180)));
      // A little wider than it is, so that no background shows between neighbours.
      out += rect(picture_left + static_cast<double>(i) * cell, picture_top + row * cell_height, cell + 0.3,
                  cell_height + 0.3, hex(srgb_u8(color)));
    }
  }
  for (int row = 0; row < rows; row += 3)
    out += label(picture_left - 6, picture_top + (row + 0.8) * cell_height, "end",
                 std::to_string(row * angle_step) + "\u00b0");
  for (std::size_t i = 0; i < count; i += std::max<std::size_t>(1, (count - 1) / 8))
    out += label(picture_left + (static_cast<double>(i) + 0.5) * cell, bottom + 18, "middle",
                 number(sweep.thickness_nm[i], 4));
  out +=
      label(picture_left + picture_width / 2, bottom + 38, "middle",
            "thickness of layer " + std::to_string(sweep.layer) + " in nm; downwards the angle of incidence");
  return out + "</svg>\n";
}

}  // namespace etak
