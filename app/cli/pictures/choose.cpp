// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pictures/choose.h"

#include <optional>

#include "app/cli/inputs/inputs.h"
#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "app/cli/pictures/pictures.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/base/text/text.h"
#include "core/material/names.h"
#include "core/pages/choose_report.h"
#include "core/study/choose/choose_scene.h"
#include "core/study/error_time.h"

namespace etak::cli {
namespace {

CostTable cost_table(const ChooseArguments& arguments) {
  if (arguments.measure || arguments.write_costs) {
    const ReportHeader header = report_header({});
    Progress progress(arguments.output, 0, "choose");
    progress.stage("measuring costs");
    return measure_costs(header.cpu + ", " + header.compiler + ", " + header.flags,
                         [&](std::size_t done, std::size_t all) { progress.set(done, all); });
  }
  return arguments.costs.empty() ? shipped_costs() : parse_costs(read_file(arguments.costs), arguments.costs);
}

// The choices for the materials of a scene.
std::vector<Choice> scene_choices(const std::string& scene, ChooseArguments& arguments,
                                  const ChooseOptions& options, const CostTable& costs, Progress& progress) {
  PackOptions pack;
  pack.input.pictures.door = picture_door();
  pack.run.threads = thread_count(arguments.threads);
  std::vector<std::string> remarks;
  const auto subjects = scene_subjects(scene, pack, arguments.library.get(), remarks);
  for (const std::string& each : remarks) remark(arguments.output, each);
  progress.set(0, subjects.size());
  return choose_each(subjects, options, costs, pack.run.threads,
                     [&](unsigned worker) { progress.advance(1, worker); });
}

// The choices for all subjects. The remarks are written when the line of the progress is gone.
struct Chosen {
  std::vector<Choice> choices;
  std::vector<std::string> remarks;
  int status = exit_ok;

  void take(Choice choice) {
    if (!choice.met) {
      status = exit_findings;
      remarks.push_back(unmet_remark(choice));
    }
    choices.push_back(std::move(choice));
  }
};

// Chooses for materials of the library, or for all of it.
void choose_for_library(ChooseArguments& arguments, const ChooseOptions& options, const CostTable& costs,
                        Progress& progress, Chosen& out) {
  const std::optional<Gloss> given = given_gloss(arguments.rough);
  std::size_t total = 0;
  const auto add = [&](const Material& material, const Dataset& dataset, std::vector<std::string>& remarks) {
    const ChooseSubject subject = library_subject(material, dataset, given, remarks);
    progress.stage(subject.name);
    out.take(choose(subject, options, costs));
    progress.set(out.choices.size(), total);
  };
  if (!arguments.all) {
    InputNames names;
    names.names = arguments.materials;
    names.dataset = arguments.dataset;
    const std::vector<MaterialInput> inputs = find_inputs(names, arguments.library.when_asked(), 1);
    for (const std::string& each : alias_remarks(inputs)) out.remarks.push_back(each);
    total = inputs.size();
    for (const MaterialInput& input : inputs) {
      const Material material = read_material(input, table_options(arguments.tables));
      add(material, dataset_named(material, input.dataset, input.label()), out.remarks);
    }
    return;
  }
  const MaterialLibrary& library = arguments.library.get();
  total = library.ids().size();
  std::size_t reflectances = 0;
  std::vector<std::string> refused, standards;
  for (std::size_t i = 0; i < library.ids().size(); ++i) {
    const Material material = library.at(i);
    if (std::holds_alternative<Reflectance>(material.preferred_dataset().optics)) {
      ++reflectances;
      --total;
      continue;
    }
    try {
      add(material, material.preferred_dataset(), given ? out.remarks : standards);
    } catch (const Error& error) {
      refused.emplace_back(error.what());
      --total;
    }
  }
  // Nobody asked for them by name, so they do not change the exit status.
  out.remarks.push_back(std::to_string(reflectances) + " materials without n and k are left out");
  if (!refused.empty())
    out.remarks.push_back(std::to_string(refused.size()) + " more left out; " + joined(refused, "; "));
  if (!standards.empty())
    out.remarks.push_back(
        std::to_string(standards.size()) +
        " spheres have the default roughness of their class, a convention and no measurement; --gloss or --roughness gives one to all");
}

int choose_within_memory(ChooseArguments& arguments) {
  check_output(arguments.output);
  if (arguments.measure || arguments.write_costs)
    remark(arguments.output, "measuring costs: a minute, longer on a busy machine");
  const CostTable costs = cost_table(arguments);
  if (arguments.write_costs) {
    write_output(arguments.output, format_costs(costs));
    return exit_ok;
  }
  if (arguments.measure)
    remark(arguments.output, "costs measured here: the choice may differ from that of other machines");
  const auto& materials = arguments.materials;
  if (arguments.all == !materials.empty())
    throw Error::at("etak choose", arguments.all ? "--all and materials" : "no material",
                    "materials, or --all");
  ChooseOptions options;
  options.budget = arguments.budget;
  validate(options);
  if (arguments.codes) options.unit = ErrorUnit::codes;
  const std::string scene = !materials.empty() && names_scene(materials[0]) ? materials[0] : "";
  if (given_gloss(arguments.rough) && !scene.empty())
    throw Error::at("etak choose", "--gloss or --roughness beside " + scene,
                    "a scene alone: it says its own");
  Chosen chosen;
  {
    Progress progress(arguments.output,
                      arguments.all ? arguments.library.get().ids().size() : materials.size(), "choose");
    if (scene.empty())
      choose_for_library(arguments, options, costs, progress, chosen);
    else if (materials.size() > 1)
      throw Error::at("etak choose", materials[1] + " beside " + scene, "one scene alone");
    else
      for (Choice& each : scene_choices(scene, arguments, options, costs, progress))
        chosen.take(std::move(each));
  }
  for (const std::string& each : chosen.remarks) remark(arguments.output, each);
  write_output(arguments.output, arguments.output.format == "json"
                                     ? choice_json(chosen.choices, costs, scene)
                                     : choice_text(chosen.choices, costs, scene));
  return chosen.status;
}

}  // namespace

int choose_materials(ChooseArguments& arguments) {
  const auto& names = arguments.materials;
  return with_memory_for(
      names.size() == 1 ? names[0] : "etak choose", [] { return "what its shading is chosen from"; },
      [&] { return choose_within_memory(arguments); });
}

}  // namespace etak::cli
