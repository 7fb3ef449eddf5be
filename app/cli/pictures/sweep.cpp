// SPDX-License-Identifier: Apache-2.0
#include "core/base/sweep.h"
#include "app/cli/pictures/sheet.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/render/sheet.h"

namespace etak::cli {
namespace {

double number_of(const Sweep& sweep, const std::string& value) {
  double out = 0;
  if (!parse_number(value, out)) throw Error::at("--sweep", sweep.name + "=" + printable(value), "a number");
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
  const Sweep sweep =
      parse_sweep(arguments.sweep,
                  {"NAME=FIRST:LAST:COUNT or NAME=VALUE,VALUE,..., 2 to 64 values, such as gloss=0:1:7"});
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
