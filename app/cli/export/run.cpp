// SPDX-License-Identifier: Apache-2.0
#include "app/cli/export/run.h"

#include <algorithm>
#include <optional>

#include "app/cli/options/shard.h"
#include "app/cli/output/form.h"
#include "core/base/error.h"
#include "core/base/hash/content_hash.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/shards/shard_document.h"
#include "core/base/text/edit_distance.h"
#include "core/exchange/export_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_x.h"
#include "core/material/names.h"
#include "core/material/quality.h"

namespace etak::cli {
namespace {

struct Found {
  std::vector<ExportSurface> surfaces;
  std::vector<std::string> datasets;
  bool refused = false, failed = false;
  std::size_t inputs = 0;  // of the whole run
  ShardOutput says;        // of a shard
};

// The result for one input: a surface, or the reason why there is none.
struct Answer {
  std::optional<ExportSurface> surface;
  std::string dataset, remark, complaint;
  bool refused = false, failed = false;
};

Answer answer(const MaterialInput& input, const ExportArguments& arguments, const TableOptions& tables,
              const F0Solver& solver) {
  LinearRgb diffuse{0, 0, 0};
  if (!arguments.diffuse.empty())
    diffuse = {arguments.diffuse[0], arguments.diffuse[1], arguments.diffuse[2]};
  Answer out;
  try {
    const Material material = read_material(input, tables);
    const Dataset& dataset = dataset_named(material, input.dataset, input.label());
    const F0Result result = solve(solver, material, dataset);
    if (result.refused()) {
      out.complaint = material.id + "/" + dataset.id + ": refused: " + result.refusal;
      // In a folder or the whole library, a refused material does not change the exit status, because nobody
      // asked for it by name.
      out.refused = !input.from_folder;
      return out;
    }
    ExportSurface surface =
        export_surface(material, dataset, solver.options(), result, diffuse, given_gloss(arguments.rough));
    surface.opacity = arguments.opacity;
    validate(surface);
    if (!input.alias_note.empty()) surface.notes.push_back(input.alias_note);
    if (!arguments.diffuse.empty() && surface.diffuse != diffuse)
      out.remark = material.id + " is no dielectric: --diffuse is not used";
    out.dataset = dataset.id;
    out.surface = std::move(surface);
  } catch (const Error& error) {
    out.complaint = error.what();
    out.failed = true;
  }
  return out;
}

// The surfaces of the inputs. An input that fails is reported, and the others are still exported.
Found find_surfaces(ExportArguments& arguments, const F0Solver& solver) {
  const TableOptions tables = table_options(arguments.tables);
  const unsigned threads = thread_count(arguments.threads);
  Found out;
  std::vector<MaterialInput> inputs =
      find_tables(arguments.inputs, arguments.library, threads, arguments.output);
  out.inputs = inputs.size();
  if (const auto shard = asked_shard(arguments.shard)) out.says = keep_inputs(inputs, *shard);
  for (const std::string& each : alias_remarks(inputs)) remark(arguments.output, each);
  std::vector<Answer> answers(inputs.size());
  parallel_chunks(inputs.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) answers[i] = answer(inputs[i], arguments, tables, solver);
  });
  std::vector<std::string> left_out;  // of the whole library: nobody asked for them by name
  for (Answer& each : answers) {
    const bool counted = arguments.inputs.all && !each.surface && !each.failed;
    if (counted)
      left_out.push_back(each.complaint);
    else if (!each.complaint.empty())
      complain(each.complaint);
    if (!each.remark.empty()) remark(arguments.output, each.remark);
    out.refused |= each.refused;
    out.failed |= each.failed;
    if (!each.surface) continue;
    out.surfaces.push_back(std::move(*each.surface));
    out.datasets.push_back(std::move(each.dataset));
  }
  if (!left_out.empty())
    remark(arguments.output, std::to_string(left_out.size()) + " of " + std::to_string(answers.size()) +
                                 " left out; " + joined(left_out, "; "));
  return out;
}

// The values of a shard, as JSON and in the other form that is made of rows.
std::string shard_values(const ExportArguments& a, const Found& found, const std::vector<ExportedValues>& all,
                         Fit fit, const std::string& policy) {
  ContentHash options;
  const auto typed = [](const std::optional<double>& value) { return value ? number(*value, 17) : ""; };
  for (const std::string& text :
       {policy, a.fit, a.tables.unit, a.tables.columns, a.tables.duplicates, a.inputs.dataset,
        joined(a.targets), number(a.opacity, 17), typed(a.rough.gloss), typed(a.rough.roughness)})
    options.add_part(text);
  for (const double value : a.diffuse) options.add_part(number(value, 17));
  for (const bool flag : {a.inputs.all, a.inputs.all_datasets}) options.add_part(flag ? "1" : "0");
  ShardMember member;
  member.says = found.says;
  member.says.options = options.hex();
  member.counts = {{"inputs", found.inputs},
                   {"rows", all.size()},
                   {"failed", found.failed ? 1 : 0},
                   {"refused", found.refused ? 1 : 0},
                   {"allowEmpty", 1}};
  ShardForm& lines = member.forms["csv"];
  lines.head = export_csv({});
  lines.rows = export_csv(all).substr(lines.head.size());
  remark(a.output, "shard " + member.says.shard.text() + ": " + std::to_string(all.size()) +
                       " materials of " + std::to_string(found.inputs) + " inputs");
  return shard_document(export_json(all, fit, policy), "materials", member);
}

std::string values(const ExportArguments& arguments, Found& found, Fit fit, const std::string& policy) {
  std::vector<const EngineTarget*> targets;
  for (const std::string& id : arguments.targets) {
    const EngineTarget* const target = engine_target(id);
    if (target == nullptr) {
      std::vector<std::string> ids;
      for (const EngineTarget& each : engine_targets()) ids.emplace_back(each.id);
      throw Error::at("--target", printable(id), joined(ids) + did_you_mean(id, ids));
    }
    targets.push_back(target);
  }
  if (targets.empty())
    for (const EngineTarget& each : engine_targets()) targets.push_back(&each);
  const std::vector<ExportedValues> all = exported_values(std::move(found.surfaces), found.datasets, targets,
                                                          fit, thread_count(arguments.threads));
  const std::string& format = arguments.output.format;
  if (!arguments.shard.empty()) return shard_values(arguments, found, all, fit, policy);
  return format == "csv"    ? export_csv(all)
         : format == "json" ? export_json(all, fit, policy)
         : format == "text" ? export_text(all)
                            : export_table(all);
}

// Settles the form of the output: --format, or the usual form of --to. Throws Error where they do not match.
void choose_format(ExportArguments& arguments) {
  std::string& format = arguments.output.format;
  const bool values = arguments.to == "values";
  if (format == "auto") {
    format = values ? "table" : arguments.to;
    return;
  }
  const std::vector<std::string> fitting = values ? std::vector<std::string>{"table", "text", "csv", "json"}
                                           : arguments.to == "gltf" ? std::vector<std::string>{"gltf", "glb"}
                                                                    : std::vector<std::string>{"mtlx"};
  if (std::find(fitting.begin(), fitting.end(), format) == fitting.end())
    refuse_form(arguments.output, "etak export", "with --to " + arguments.to, fitting);
}

// Writes to standard error what was assumed and changed for each surface, because the formats have no place
// for it.
void tell_notes_and_changes(const ExportArguments& arguments, const std::vector<ExportSurface>& surfaces,
                            const std::vector<Changes>& changes) {
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (const std::string& note : surfaces[i].notes) remark(arguments.output, surfaces[i].id + ": " + note);
    for (const Change& change : changes[i])
      remark(arguments.output, surfaces[i].id + ": " + one_line(change));
  }
}

// Expands --to TARGET, which is short for --to values --target TARGET.
void take_target(ExportArguments& arguments) {
  const std::string& to = arguments.to;
  if (to == "mtlx" || to == "gltf" || to == "values") return;
  if (!arguments.targets.empty()) throw Error::at("--target", "given beside --to " + to, "--to values");
  arguments.targets = {to};
  arguments.to = "values";
}

}  // namespace

int export_materials(ExportArguments& arguments) {
  take_target(arguments);
  if (arguments.inputs.names.empty() && !arguments.inputs.all)
    throw Error::at("etak export", "no input", "a material or file, - for standard input, or --all");
  choose_format(arguments);
  if (asked_shard(arguments.shard)) {
    refuse_pipes_of_shard(arguments.inputs.names);
    if (arguments.to != "values")
      throw Error::at("--shard", "--to " + arguments.to + ", which is one document of all materials",
                      "--to values");
    if (arguments.output.format != "json")
      throw Error::at(arguments.output.form_asked_by, arguments.output.format + " with --shard",
                      "json, of which etak merge makes csv");
  }
  const auto in_range = [](const char* option, double value) {
    if (!(value >= 0 && value <= 1)) throw Error::at(option, number(value, 6), "0 to 1");
  };
  (void)given_gloss(arguments.rough);
  in_range("--opacity", arguments.opacity);
  for (const double value : arguments.diffuse) in_range("--diffuse", value);
  if (!arguments.targets.empty() && arguments.to != "values")
    throw Error::at("--target", "--to " + arguments.to + " is one target", "--to values");
  const F0Options options = f0_options(arguments.compute, arguments.library);
  const bool other_space = options.custom_space || options.space != RgbSpace::srgb;
  if (arguments.to != "mtlx"
          ? other_space
          : options.custom_space || (options.space != RgbSpace::srgb && options.space != RgbSpace::acescg &&
                                     options.space != RgbSpace::display_p3))
    throw Error::at("--space", space_name(options) + " with --to " + arguments.to,
                    arguments.to == "mtlx" ? "srgb, acescg or display-p3" : "srgb, which its values are in");
  const F0Solver solver(options);
  const Fit fit = *fit_named(arguments.fit);
  Found found = find_surfaces(arguments, solver);
  if (!found.surfaces.empty() || !arguments.shard.empty()) {
    std::vector<Changes> changes;
    if (arguments.to == "values") {
      write_output(arguments.output, values(arguments, found, fit, policy(options)));
    } else {
      const auto form = arguments.gltf_form == "metal-rough" ? GltfMaterialForm::metal_rough
                                                             : GltfMaterialForm::specular_glossiness;
      const auto container = arguments.output.format == "glb" ? GltfContainer::glb : GltfContainer::gltf;
      write_output(arguments.output, arguments.to == "mtlx"
                                         ? material_x(found.surfaces, fit, changes)
                                         : gltf_document(found.surfaces, form, container, fit, changes));
      tell_notes_and_changes(arguments, found.surfaces, changes);
    }
  }
  return found.failed ? exit_failure : found.refused ? exit_findings : exit_ok;
}

}  // namespace etak::cli
