// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/form.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/system.h"
#include "core/base/text/ascii.h"
#include "core/base/text/edit_distance.h"
#include "core/exchange/export_input.h"
#include "core/exchange/export_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"

namespace etak::cli {
namespace {

struct ExportArguments {
  InputNames inputs;
  F0Settings compute;
  TableSettings tables;
  OutputArguments output;
  Library library;
  std::vector<std::string> wanted;  // of --to, as typed
  std::string to, fit = "clamp", gltf_form = "specular-ior";
  std::vector<std::string> targets;
  std::string diffuse, emission;  // colours as typed
  std::string coat;
  RoughnessArguments rough;
  double opacity = 1;
  unsigned threads = 0;
};

// The words that --to takes: mtlx, gltf, values, then the targets. "gltf" is the file format; its values are asked for
// by --to values --target gltf.
std::vector<std::string> forms_and_targets() {
  std::vector<std::string> out{"mtlx", "gltf", "values"};
  for (const EngineTarget& each : engine_targets())
    if (each.id != "gltf") out.emplace_back(each.id);
  return out;
}

struct Found {
  std::vector<ExportSurface> surfaces;
  std::vector<std::string> datasets;
  std::set<std::string> told;  // remarks on names
  bool refused = false, failed = false;
};

// The result for one input: a surface, or the reason why there is none.
struct Answer : ExportAnswer {
  std::string failure;
};

Answer answer(const MaterialInput& input, const ExportWishes& wishes, const TableOptions& tables,
              const F0Solver& solver) {
  Answer out;
  try {
    static_cast<ExportAnswer&>(out) = export_answer(input, tables, solver, wishes);
  } catch (const Error& error) {
    out.failure = error.what();
  }
  return out;
}

// The surfaces of the inputs. An input that fails is reported, and the others are still exported.
Found find_surfaces(ExportArguments& arguments, const F0Solver& solver) {
  const TableOptions tables = table_options(arguments.tables);
  const unsigned threads = thread_count(arguments.threads);
  Found out;
  const std::vector<MaterialInput> inputs =
      find_tables(arguments.inputs, arguments.library, threads, arguments.output);
  for (const std::string& each : alias_remarks(inputs)) {
    remark(arguments.output, each);
    out.told.insert(each);
  }
  ExportWishes wishes{
      std::nullopt, given_gloss(arguments.rough), arguments.opacity, arguments.compute.axis_average, {}};
  if (!arguments.diffuse.empty()) wishes.diffuse = typed_share("--diffuse", arguments.diffuse);
  if (!arguments.emission.empty()) wishes.emission = typed_emission(arguments.emission);
  wishes.coat = coat_option(arguments.coat, arguments.library.when_asked(), solver.options(),
                            arguments.compute.axis_average);
  validate(wishes, solver.options());
  std::vector<Answer> answers(inputs.size());
  parallel_chunks(inputs.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) answers[i] = answer(inputs[i], wishes, tables, solver);
  });
  std::vector<std::string> left_out;  // of the whole library: nobody asked for them by name
  for (std::size_t i = 0; i < answers.size(); ++i) {
    Answer& each = answers[i];
    if (!each.failure.empty())
      complain(each.failure);
    else if (arguments.inputs.all && !each.surface)
      left_out.push_back(each.refusal);
    else if (!each.refusal.empty())
      complain(each.refusal);
    if (!each.remark.empty()) remark(arguments.output, each.remark);
    // In a folder or the whole library, a refused material does not change the exit status, because nobody asked for
    // it by name.
    out.refused |= !each.refusal.empty() && !inputs[i].from_folder;
    out.failed |= !each.failure.empty();
    if (!each.surface) continue;
    out.surfaces.push_back(std::move(*each.surface));
    out.datasets.push_back(std::move(each.dataset));
  }
  if (!left_out.empty())
    remark(arguments.output, std::to_string(left_out.size()) + " of " + std::to_string(answers.size()) +
                                 " left out; " + joined(left_out, "; "));
  return out;
}

// Writes to standard error what was assumed for each surface.
void tell_notes(const ExportArguments& arguments, const Found& found, const ExportSurface& surface) {
  for (const std::string& note : surface.notes)
    if (!found.told.contains(note)) remark(arguments.output, surface.id + ": " + note);
}

// Whether the user sees the notes with the values: in a table on the terminal, and in a table or JSON of the
// whole library, whose notes nobody reads one by one.
bool shows_notes(const ExportArguments& arguments) {
  const OutputArguments& output = arguments.output;
  const bool table = output.format == "table";
  return (table || output.format == "json") &&
         (arguments.inputs.all ||
          (table && is_standard_output(output) && sys::is_terminal(sys::standard_output)));
}

// Writes to standard error what a target does not hold, where the form of the output has no place for it.
void tell_changes(const ExportArguments& arguments, const ExportSurface& surface, const Changes& changes) {
  for (const Change& change : changes) remark(arguments.output, surface.id + ": " + one_line(change));
}

std::string values(const ExportArguments& arguments, Found& found, Fit fit, const std::string& policy) {
  if (!shows_notes(arguments))
    for (const ExportSurface& each : found.surfaces) tell_notes(arguments, found, each);
  const std::vector<ExportedValues> all =
      exported_values(std::move(found.surfaces), found.datasets, engine_targets_named(arguments.targets), fit,
                      thread_count(arguments.threads));
  const std::string& format = arguments.output.format;
  if (format == "text")
    for (const ExportedValues& each : all) {
      std::set<std::string> told;  // a cause that several targets share is told once
      for (const EngineValues& values : each.targets) {
        Changes fresh;
        for (const Change& change : values.changes) {
          const std::string line = one_line(change);  // "field from -> to (how, by how much): reason"
          if (told.insert(line.substr(change.field.size(), line.find("): ") - change.field.size())).second)
            fresh.push_back(change);
        }
        tell_changes(arguments, each.surface, fresh);
        for (const std::string& note : values.notes)
          if (told.insert(note).second)
            remark(arguments.output, each.surface.id + ", " + std::string(values.target) + ": " + note);
        const std::string error = error_line(values);
        if (!error.empty() && told.insert(error).second)
          remark(arguments.output, each.surface.id + ", " + std::string(values.target) + ": " + error);
      }
    }
  return format == "csv"    ? export_csv(all)
         : format == "json" ? export_json(all, fit, policy)
         : format == "text" ? export_text(all)
                            : export_table(all);
}

// Settles the form of the output: --format, or the usual form of --to. Throws Error where they do not match.
void choose_format(ExportArguments& arguments) {
  std::string& format = arguments.output.format;
  const bool values = arguments.to == "values";
  const EngineTarget* const only =
      arguments.targets.size() == 1 ? engine_target(arguments.targets.front()) : nullptr;
  const bool document = only != nullptr && only->is_document();
  // The targets that are nodes of MaterialX are files of that ending.
  if (format == "mtlx" && document && only->opens.starts_with("<?xml")) format = "text";
  if (format == "auto") {
    format = document ? "text" : values ? "table" : arguments.to;
    return;
  }
  const std::vector<std::string> fitting = values ? std::vector<std::string>{"table", "text", "csv", "json"}
                                           : arguments.to == "gltf" ? std::vector<std::string>{"gltf", "glb"}
                                                                    : std::vector<std::string>{"mtlx"};
  if (std::find(fitting.begin(), fitting.end(), format) == fitting.end())
    refuse_form(arguments.output, "etak export", "with --to " + arguments.to, fitting);
}

// Expands --to TARGET,..., which is short for --to values --target TARGET,...
void take_targets(ExportArguments& arguments) {
  for (std::string& to : arguments.wanted) {
    to = lower_case(to);
    const bool form = to == "mtlx" || to == "gltf" || to == "values";
    if (!form && engine_target(to) == nullptr) {
      const std::vector<std::string> all = forms_and_targets();
      throw Error::at("--to", printable(to),
                      "a file: mtlx or gltf; values: of all targets; or targets with ',' between: " +
                          joined(std::vector<std::string>(all.begin() + 3, all.end())) +
                          did_you_mean(to, all));
    }
    if (form && arguments.wanted.size() > 1)
      throw Error::at("--to", to + " beside others", to + " alone, or targets with ',' between");
  }
  const std::string first = arguments.wanted.front();
  arguments.to = first == "mtlx" || first == "gltf" ? first : "values";
  if (arguments.to == first) return;
  if (!arguments.targets.empty()) throw Error::at("--target", "given beside --to " + first, "--to values");
  arguments.targets = arguments.wanted;
}

int export_materials(ExportArguments& arguments) {
  take_targets(arguments);
  if (arguments.inputs.names.empty() && !arguments.inputs.all)
    throw Error::at("etak export", "no input", "a material or file, - for standard input, or --all");
  choose_format(arguments);
  const auto in_range = [](const char* option, double value) {
    if (!(value >= 0 && value <= 1)) throw Error::at(option, number(value, 6), "0 to 1");
  };
  (void)given_gloss(arguments.rough);
  in_range("--opacity", arguments.opacity);
  if (!arguments.diffuse.empty()) (void)typed_share("--diffuse", arguments.diffuse);
  if (!arguments.emission.empty()) (void)typed_emission(arguments.emission);
  if (!arguments.targets.empty() && arguments.to != "values")
    throw Error::at("--target", "--to " + arguments.to + " is one target", "--to values");
  const F0Options options = f0_options(arguments.compute, arguments.library);
  require_export_space(arguments.to, options);
  (void)engine_targets_named(arguments.targets);  // before the work
  const F0Solver solver(options);
  const Fit fit = *fit_named(arguments.fit);
  Found found = find_surfaces(arguments, solver);
  if (!found.surfaces.empty()) {
    std::vector<Changes> changes;
    if (arguments.to == "values") {
      write_output(arguments.output, values(arguments, found, fit, policy(options)));
    } else {
      const GltfMaterialForm form = *gltf_material_form_named(arguments.gltf_form);
      if (arguments.gltf_form == "metal-rough")
        remark(arguments.output, "--gltf-form " + std::string(gltf_form_renamed));
      const auto container = arguments.output.format == "glb" ? GltfContainer::glb : GltfContainer::gltf;
      write_output(arguments.output, arguments.to == "mtlx"
                                         ? material_x(found.surfaces, fit, changes)
                                         : gltf_document(found.surfaces, form, container, fit, changes));
      for (std::size_t i = 0; i < changes.size(); ++i) {
        tell_notes(arguments, found, found.surfaces[i]);
        tell_changes(arguments, found.surfaces[i], changes[i]);
      }
    }
  }
  return found.failed ? exit_failure : found.refused ? exit_findings : exit_ok;
}

}  // namespace

void add_export(CommandLine& line) {
  const auto arguments = std::make_shared<ExportArguments>();
  Command verb = line.verb("export", "materials as MaterialX, glTF or the values of an engine");
  add_input_options(verb, arguments->inputs);
  verb.option(
          "--to", arguments->wanted,
          "mtlx (MaterialX 1.39, OpenPBR), gltf (spheres with the material), values (what to type or paste), or the values of targets, with ',' between")
      .required()
      .separated_by(',')
      .one_at_a_time()
      .words(forms_and_targets());
  verb.flag("--all", arguments->inputs.all, "every material of the library");
  add_all_datasets_option(verb, arguments->inputs);
  verb.option("--dataset", arguments->inputs.dataset, "dataset to take instead of the preferred one")
      .value_name("ID");
  add_roughness_options(verb, arguments->rough, "of the surface");
  add_color_option(verb, "--diffuse", arguments->diffuse,
                   "diffuse colour of dielectrics, linear (default black, and clear where the data say so)");
  verb.option("--opacity", arguments->opacity, "0 to 1").show_default();
  verb.option(
          "--coat", arguments->coat,
          "a smooth clear layer over the material: an index, or a clear material, which absorbs through a thickness (1.5, pmma, water:2mm); targets without a coat get F0 of the whole")
      .value_name("N|MATERIAL[:THICKNESS]");
  add_color_option(verb, "--emission", arguments->emission,
                   "radiance that the surface sends out by itself, linear; default black");
  verb.option(
          "--fit", arguments->fit,
          "what becomes of a colour above 1 or below 0: clamp (each channel) or preserve-hue (the whole colour)")
      .one_of({"clamp", "preserve-hue"})
      .show_default();
  verb.option("--target", arguments->targets,
              "of --to values: only these, with ',' between (" +
                  joined(engine_targets(), ", ", [](const EngineTarget& each) { return each.id; }) + ")")
      .separated_by(',')
      .value_name("TARGET,...");
  verb.option(
          "--gltf-form", arguments->gltf_form,
          "as in pack: specular-ior (metal-rough, and dielectrics with KHR_materials_ior and _specular; metal-rough is its older name here) or specular-glossiness")
      .one_of({"specular-ior", "specular-glossiness", "metal-rough"})
      .show_default();
  add_compute_options(verb, arguments->compute);
  add_table_options(verb, arguments->tables);
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output,
                     {"auto", "table", "text", "csv", "json", "gltf", "glb", "mtlx"});
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "--format auto is table for values, mtlx, and gltf (glb where -o ends in it); text is what to paste.\n"
      "What a target cannot hold is changed by --fit or a rule of the target and told beside the value.\n"
      "Exit status: 0 done, 1 an input named by itself was refused by the rules, 2 an input failed.\n"
      "Example:\n  etak export gold diamond --to values --target unreal,filament");
  verb.runs([arguments] { return export_materials(*arguments); });
}

}  // namespace etak::cli
