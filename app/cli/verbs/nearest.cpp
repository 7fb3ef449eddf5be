// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/color/colorspace.h"
#include "core/color/srgb.h"
#include "core/material/names.h"
#include "core/material/quality.h"
#include "core/pages/lists/lists.h"
#include "core/spectrum/integration.h"

namespace etak::cli {
namespace {

struct NearestArguments {
  std::vector<std::string> color;
  std::string dataset;
  bool linear = false;
  F0Settings compute;

  std::size_t count = 5;
  std::vector<std::string> classes;
  OutputArguments output;
  Library library;
  unsigned threads = 0;
};

constexpr const char* color_forms =
    "a hex colour (#ffe29b), 8-bit codes (255,226,155), linear values with --linear (1.0,0.76,0.33), or a material or file (gold)";

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

bool is_color(const std::string& text, Library& library) {
  if (text.starts_with('#') || text.find(',') != text.npos) return true;
  const bool hex = (text.size() == 3 || text.size() == 6) &&
                   std::all_of(text.begin(), text.end(), [](char c) { return hex_digit(c) >= 0; });
  return hex && !library.get().look_up(text);
}

// The unclipped F0 of a material or file.
LinearRgb color_of(const std::string& name, NearestArguments& arguments, const F0Solver& solver) {
  InputNames names;
  names.names = {name};
  names.dataset = arguments.dataset;
  const std::vector<MaterialInput> inputs = find_inputs(names, arguments.library.when_asked(), 1);
  if (inputs.size() != 1)
    throw Error::at(printable(name), "stands for " + std::to_string(inputs.size()) + " of them",
                    "one colour, material or file");
  for (const std::string& each : alias_remarks(inputs)) remark(arguments.output, each);
  const Material material = read_material(inputs[0], TableOptions{});
  const Dataset& dataset = dataset_named(material, inputs[0].dataset, inputs[0].label());
  const F0Result result = solve_averaged(arguments.compute.axis_average, solver, material, dataset);
  if (result.refused()) throw Error::at(material.id + "/" + dataset.id, "refused: " + result.refusal);
  return result.srgb_linear;
}

// Remarks on materials of class surface, whose colour is diffuse and no F0.
void tell_surfaces(const std::vector<NearMaterial>& found, const OutputArguments& output) {
  std::vector<std::string> ids;
  for (const NearMaterial& match : found)
    if (match.entry->material.material_class == "surface") ids.push_back(match.entry->material.id);
  if (!ids.empty()) remark(output, joined(ids) + ": of class surface, whose colour is diffuse: no F0");
}

int run(NearestArguments& arguments) {
  check_classes(arguments.classes);
  const F0Solver solver{f0_options(arguments.compute, arguments.library)};
  if (arguments.color.size() > 1)
    throw Error::at(printable(joined(arguments.color, " ")),
                    std::to_string(arguments.color.size()) + " arguments",
                    "one: a colour with ',' between its numbers (" + joined(arguments.color, ",") +
                        "), or a name in quotes");
  const std::string& typed = arguments.color.front();
  using Color = std::variant<LinearRgb, Srgb8>;
  const bool named = !arguments.linear && !is_color(typed, arguments.library);
  if (!named && !arguments.dataset.empty()) throw Error::at("--dataset", "beside a colour", "a material");
  const Color color = named              ? Color(color_of(typed, arguments, solver))
                      : arguments.linear ? Color(in_srgb(three_numbers(typed), solver.options()))
                      : typed.find(',') == typed.npos
                          ? Color(parse_hex(typed))
                          : Color(codes_of(three_numbers(typed), printable(typed)));
  const std::vector<CatalogueEntry> all = catalogue(
      arguments.library.get(), solver, thread_count(arguments.threads), arguments.compute.axis_average);
  const std::vector<NearMaterial> found = nearest_materials(all, color, arguments.classes, arguments.count);
  const std::string& format = arguments.output.format;
  write_output(arguments.output, format == "csv"    ? nearest_csv(found)
                                 : format == "json" ? nearest_json(found, typed, arguments.linear || named)
                                                    : nearest_table(found, use_color(arguments.output)));
  tell_surfaces(found, arguments.output);
  return exit_ok;
}

}  // namespace

void add_nearest(CommandLine& line) {
  const auto arguments = std::make_shared<NearestArguments>();
  Command verb = line.verb("nearest", "library materials whose F0 is nearest to a colour");
  verb.option("COLOUR", arguments->color, color_forms).required().value_name("");
  verb.flag("--linear", arguments->linear, "COLOUR is linear, in --space");
  verb.option("--dataset", arguments->dataset, "dataset of the material instead of the preferred one")
      .value_name("ID");
  verb.option("-n,--count", arguments->count, "how many to show").range(1, 10000).show_default();
  add_class_option(
      verb, arguments->classes,
      "only this class; may be repeated. Without it every class but surface, whose diffuse colours are no F0");
  add_compute_options(verb, arguments->compute);
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"table", "csv", "json"});
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "The distance is CIEDE2000 between the colours under D65.\nExample:\n  etak nearest '#ffe29b' -n 3");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
