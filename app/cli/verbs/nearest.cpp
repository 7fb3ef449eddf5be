// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/inputs/colors.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/text/text.h"
#include "core/pages/lists/lists.h"

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
  const std::string& typed = one_color(arguments.color);
  const bool named = !arguments.linear && !is_color(typed, arguments.library);
  if (!named && !arguments.dataset.empty()) throw Error::at("--dataset", "beside a colour", "a material");
  const TypedColor color = named ? TypedColor(color_of(typed, arguments.dataset, arguments.library,
                                                       arguments.compute, solver, arguments.output))
                                 : typed_color(typed, arguments.linear, solver.options());
  const std::vector<CatalogueEntry> all = catalogue(
      arguments.library.get(), solver, thread_count(arguments.threads), arguments.compute.axis_average);
  const std::vector<NearMaterial> found = nearest_materials(all, color, arguments.classes, arguments.count);
  const std::vector<BandOfF0> bands = bands_of(found, solver, arguments.compute.axis_average);
  const std::string& format = arguments.output.format;
  write_output(arguments.output, format == "csv" ? nearest_csv(found, bands)
                                 : format == "json"
                                     ? nearest_json(found, bands, typed, arguments.linear || named)
                                     : nearest_table(found, bands, use_color(arguments.output)));
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
      "The distance is CIEDE2000 between the colours under D65; \"of band\" is the distance over that within which nine of\n"
      "ten new publications of the material would lie.\nExample:\n  etak nearest '#ffe29b' -n 3");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
