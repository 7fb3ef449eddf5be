// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "app/cli/pictures/sheet.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/render/sheet.h"

namespace etak::cli {
namespace {

constexpr std::size_t most_objects = 64;

[[noreturn]] void refuse(const std::string& found) {
  throw Error::at("--sweep", printable(found),
                  "NAME=FIRST:LAST:COUNT or NAME=VALUE,VALUE,..., 2 to 64 values, such as gloss=0:1:7");
}

std::vector<std::string> even_steps(const std::string& text, const std::vector<std::string>& parts) {
  double first = 0, last = 0, count = 0;
  if (parts.size() != 3 || !parse_number(parts[0], first) || !parse_number(parts[1], last) ||
      !parse_number(parts[2], count) || !(count >= 2 && count <= most_objects && count == std::floor(count)))
    refuse(text);
  std::vector<std::string> out;
  for (double i = 0; i < count; ++i) out.push_back(number(std::lerp(first, last, i / (count - 1)), 6));
  return out;
}

// The values of --sweep.
struct Sweep {
  std::string name;
  std::vector<std::string> values;
};

double number_of(const Sweep& sweep, const std::string& value) {
  double out = 0;
  if (!parse_number(value, out)) throw Error::at("--sweep", sweep.name + "=" + printable(value), "a number");
  return out;
}

Sweep parse_sweep(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0) refuse(text);
  Sweep out{text.substr(0, equals), {}};
  const std::string values = text.substr(equals + 1);
  out.values =
      values.find(':') == values.npos ? parts_of(values, ',') : even_steps(text, parts_of(values, ':'));
  if (out.values.size() < 2 || out.values.size() > most_objects) refuse(text);
  return out;
}

// The options with one value of the sweep in their place.
RenderArguments with_value(const RenderArguments& arguments, const Sweep& sweep, const std::string& value) {
  RenderArguments out = arguments;
  SceneArguments& scene = out.scene;
  if (sweep.name == "material") {
    scene.subject = {value};
  } else if (sweep.name == "model") {
    scene.model = value;
  } else if (sweep.name == "diffuse-model") {
    scene.diffuse_model = value;
  } else if (sweep.name == "gloss" || sweep.name == "roughness") {
    scene.rough = {};
    (sweep.name == "gloss" ? scene.rough.gloss : scene.rough.roughness) = number_of(sweep, value);
  } else if (sweep.name == "orbit" || sweep.name == "tilt") {
    (sweep.name == "orbit" ? scene.orbit : scene.tilt) = number_of(sweep, value);
  } else {
    scene.set.push_back(sweep.name + "=" + value);
  }
  return out;
}

}  // namespace

Image draw_sweep(const RenderArguments& arguments, const std::function<Image(RenderArguments&)>& drawn) {
  const Sweep sweep = parse_sweep(arguments.sweep);
  Sheet sheet;
  sheet.rows.emplace_back();
  for (const std::string& value : sweep.values) {
    RenderArguments one = with_value(arguments, sweep, value);
    sheet.pictures.push_back(drawn(one));
    double numeric = 0;
    sheet.columns.push_back(parse_number(value, numeric) ? sweep.name + " " + number(numeric, 3) : value);
  }
  return laid_out(sheet);
}

}  // namespace etak::cli
