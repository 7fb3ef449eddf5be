// SPDX-License-Identifier: Apache-2.0
#include "core/base/sweep.h"

#include <variant>

#include "app/cli/pictures/sheet.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/material/stack.h"
#include "core/material/stack_text.h"
#include "core/render/sheet.h"

namespace etak::cli {
namespace {

double number_of(const Sweep& sweep, const std::string& value) {
  double out = 0;
  if (!parse_number(value, out)) throw Error::at("--sweep", sweep.name + "=" + printable(value), "a number");
  return out;
}

// The subject with another thickness of one of its layers, as text.
std::string with_layer(SceneArguments scene, const Sweep& sweep, const std::string& value) {
  if (is_typed(scene)) throw Error::at("--sweep", sweep.name + ", a layer of numbers", "a stack of layers");
  SceneNotes ignored;
  const SubjectMaterial found = subject_material(scene, ignored);
  const auto* stack = std::get_if<Stack>(&found.dataset().optics);
  if (stack == nullptr)
    throw Error::at("--sweep", sweep.name + ", a layer of " + found.material.id, "a stack of layers");
  double nm = 0;
  if (!read_thickness(value, nm))
    throw Error::at("--sweep", sweep.name + "=" + printable(value), "a thickness, such as 40nm");
  return with_thickness(*stack, *whole_number<std::size_t>(sweep.name), nm).text;
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
  } else if (whole_number<std::size_t>(sweep.name)) {
    scene.subject = {with_layer(scene, sweep, value)};
    scene.dataset.clear();
  } else {
    scene.set.push_back(sweep.name + "=" + value);
  }
  return out;
}

}  // namespace

Image draw_sweep(const RenderArguments& arguments, const std::function<Image(RenderArguments&)>& drawn) {
  SweepForm form{"NAME=FIRST:LAST:COUNT or NAME=VALUE,VALUE,..., 2 to 64 values, such as gloss=0:1:7"};
  // The number of a layer sweeps its thickness.
  if (whole_number<std::size_t>(std::string_view(arguments.sweep).substr(0, arguments.sweep.find('=')))) {
    form.expected =
        "LAYER=FIRST:LAST:COUNT or LAYER=VALUE,VALUE,..., 2 to 64 thicknesses, such as 1=0nm:400nm:9";
    form.unit = "nm";
    form.read = [](std::string_view part, double& nm) { return read_thickness(part, nm); };
  }
  const Sweep sweep = parse_sweep(arguments.sweep, form);
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
