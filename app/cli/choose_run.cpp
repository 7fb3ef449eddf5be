// SPDX-License-Identifier: Apache-2.0
#include <functional>

#include "app/cli/choose.h"
#include "app/cli/inputs.h"
#include "app/cli/pack.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/material/appearance.h"
#include "core/material/names.h"
#include "core/report/choose.h"
#include "core/report/choose_scene.h"
#include "core/report/error_time.h"

namespace etak::cli {
namespace {

CostTable cost_table(const ChooseArguments& arguments) {
  if (arguments.measure || arguments.write_costs) {
    const ReportHeader header = report_header({});
    return measure_costs(header.cpu + ", " + header.compiler + ", " + header.flags);
  }
  return arguments.costs.empty() ? shipped_costs() : parse_costs(read_file(arguments.costs), arguments.costs);
}

void add_scene(const std::string& scene, ChooseArguments& arguments,
               const std::function<void(const ChooseSubject&)>& add) {
  PackOptions options;
  options.door = picture_door();
  options.threads = thread_count(arguments.threads);
  std::vector<std::string> remarks;
  const auto subjects = scene_subjects(scene, options, arguments.library.get(), remarks);
  for (const std::string& each : remarks) remark(arguments.output, each);
  for (const ChooseSubject& subject : subjects) add(subject);
}

}  // namespace

int choose_materials(ChooseArguments& arguments) {
  if (arguments.measure || arguments.write_costs)
    remark(arguments.output, "measuring costs: half a minute, longer on a busy machine");
  const CostTable costs = cost_table(arguments);
  if (arguments.write_costs) {
    write_output(arguments.output, format_costs(costs));
    return exit_ok;
  }
  if (arguments.measure)
    remark(arguments.output, "costs measured here: the choice may differ from that of other machines");
  if (arguments.all == !arguments.materials.empty())
    throw Error::at("etak choose", arguments.all ? "--all and materials" : "no material",
                    "materials, or --all");
  ChooseOptions options;
  options.budget = arguments.budget;
  if (arguments.codes) options.unit = ErrorUnit::codes;
  const std::string scene =
      !arguments.materials.empty() && names_scene(arguments.materials[0]) ? arguments.materials[0] : "";
  const std::optional<Gloss> given = given_gloss(arguments.rough);
  if (given && !scene.empty())
    throw Error::at("etak choose", "--gloss or --roughness beside " + scene,
                    "a scene alone: it says its own");
  std::vector<Choice> choices;
  int status = exit_ok;
  // The sphere of a library material, as rough as was asked or as its class is by convention.
  const auto subject_of = [&](const Material& material, const Dataset& dataset) {
    if (given) {
      if (given->alpha() < lobe_alpha({{}, {}, *given}))
        remark(arguments.output, material.id + ": the lobe of roughness " + number(given->roughness(), 3) +
                                     " is compared with a width of " +
                                     number(lobe_alpha({{}, {}, *given}), 3) +
                                     ", the least that the models take");
      return library_subject(material, dataset, *given);
    }
    const DefaultGloss standard = default_gloss(material, clarity(material, dataset).clear);
    const Gloss gloss(double{standard.gloss});
    remark(arguments.output, material.id + ": " + told(standard) +
                                 (standard.gloss.held() ? "; compared with " + roughness_text(gloss) : ""));
    return library_subject(material, dataset, gloss);
  };
  const auto add = [&](const ChooseSubject& subject) {
    choices.push_back(choose(subject, options, costs));
    if (!choices.back().met) status = exit_findings;
  };
  if (!scene.empty()) {
    if (arguments.materials.size() > 1)
      throw Error::at("etak choose", arguments.materials[1] + " beside " + scene, "one scene alone");
    add_scene(scene, arguments, add);
  } else if (arguments.all) {
    const MaterialLibrary& library = arguments.library.get();
    std::size_t reflectances = 0;
    for (std::size_t i = 0; i < library.ids().size(); ++i) {
      const Material material = library.at(i);
      if (!std::holds_alternative<OpticalConstants>(material.preferred_dataset().optics)) {
        ++reflectances;
        continue;
      }
      try {
        add(subject_of(material, material.preferred_dataset()));
      } catch (const Error& error) {
        remark(arguments.output, error.what());
        status = exit_findings;
      }
    }
    remark(arguments.output, std::to_string(reflectances) + " materials without n and k are left out");
  } else {
    InputArguments names;
    names.names = arguments.materials;
    const std::vector<Input> inputs = find_inputs(names, arguments.library, 1);
    for (const std::string& each : alias_remarks(inputs)) remark(arguments.output, each);
    for (const Input& input : inputs) {
      const Material material = read_material(input, TableOptions{});
      add(subject_of(material, dataset_named(material, input.dataset, input.label())));
    }
  }
  write_output(arguments.output, arguments.output.format == "json" ? choice_json(choices, costs, scene)
                                                                   : choice_text(choices, costs, scene));
  return status;
}

}  // namespace etak::cli
