// SPDX-License-Identifier: Apache-2.0
#include "app/cli/inputs/colors.h"

#include <algorithm>

#include "app/cli/inputs/inputs.h"
#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/color/colorspace.h"
#include "core/color/srgb.h"
#include "core/material/catalogue.h"
#include "core/material/names.h"
#include "core/material/quality.h"
#include "core/render/typed.h"
#include "core/spectrum/integration.h"

namespace etak::cli {
namespace {

// The three numbers of "r,g,b". Throws Error where there are more or fewer.
std::array<double, 3> three_numbers(const std::string& text) {
  const std::vector<double> out = typed_numbers(text);
  if (out.size() != 3) throw Error::at(printable(text), "is no colour", color_forms);
  return {out[0], out[1], out[2]};
}

// Linear sRGB of three numbers in the space of the options.
LinearRgb in_srgb(const std::array<double, 3>& typed, const F0Options& options) {
  if (options.custom_space)
    throw Error::at("--space", "of a config, beside --linear", "srgb, acescg, rec2020, display-p3 or xyz");
  const Xyz white = to_xyz(make_quadrature(Method::nm1, Viewing{}).white());
  return to_rgb(xyz_to_rgb(RgbSpace::srgb, white, white) *
                (inverse(xyz_to_rgb(options.space, white, white)) * typed));
}

}  // namespace

LinearRgb linear_of(const TypedColor& color) {
  const auto* const linear = std::get_if<LinearRgb>(&color);
  return linear ? *linear : srgb_decode(std::get<Srgb8>(color));
}

bool is_color(const std::string& text, Library& library) {
  if (text.starts_with('#') || text.find(',') != text.npos) return true;
  const bool hex = (text.size() == 3 || text.size() == 6) &&
                   std::all_of(text.begin(), text.end(), [](char c) { return hex_digit(c) >= 0; });
  return hex && !library.get().look_up(text);
}

TypedColor typed_color(const std::string& text, bool linear, const F0Options& options) {
  if (linear) return in_srgb(three_numbers(text), options);
  if (text.find(',') == text.npos) return parse_hex(text);
  return codes_of(three_numbers(text), printable(text));
}

const std::string& one_color(const std::vector<std::string>& typed) {
  if (typed.size() > 1)
    throw Error::at(
        printable(joined(typed, " ")), std::to_string(typed.size()) + " arguments",
        "one: a colour with ',' between its numbers (" + joined(typed, ",") + "), or a name in quotes");
  return typed.front();
}

LinearRgb color_of(const std::string& name, const std::string& dataset, Library& library,
                   const F0Settings& compute, const F0Solver& solver, const OutputArguments& output) {
  InputNames names;
  names.names = {name};
  names.dataset = dataset;
  const std::vector<MaterialInput> inputs = find_inputs(names, library.when_asked(), 1);
  if (inputs.size() != 1)
    throw Error::at(printable(name), "stands for " + std::to_string(inputs.size()) + " of them",
                    "one colour, material or file");
  for (const std::string& each : alias_remarks(inputs)) remark(output, each);
  const Material material = read_material(inputs[0], TableOptions{});
  const Dataset& chosen = dataset_named(material, inputs[0].dataset, inputs[0].label());
  const F0Result result = solve_averaged(compute.axis_average, solver, material, chosen);
  if (result.refused()) throw Error::at(material.id + "/" + chosen.id, "refused: " + result.refusal);
  return result.srgb_linear;
}

}  // namespace etak::cli
