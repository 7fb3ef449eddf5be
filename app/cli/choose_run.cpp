// SPDX-License-Identifier: Apache-2.0
#include "app/cli/choose.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/report/choose.h"
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

}  // namespace

int choose_materials(ChooseArguments& arguments) {
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
  std::vector<Choice> choices;
  int status = exit_ok;
  const auto add = [&](const Material& material, const Dataset& dataset) {
    choices.push_back(choose(material, dataset, arguments.budget, arguments.gloss, costs));
  };
  if (arguments.all) {
    const MaterialLibrary& library = arguments.library.get();
    for (std::size_t i = 0; i < library.ids().size(); ++i) {
      const Material material = library.at(i);
      try {
        add(material, material.preferred_dataset());
      } catch (const Error& error) {
        remark(arguments.output, error.what());
        status = exit_findings;
      }
    }
  } else {
    for (const std::string& text : arguments.materials) {
      const std::size_t slash = text.find('/');
      const auto material = arguments.library.get().find(std::string_view(text).substr(0, slash));
      if (!material) unknown_material(text, arguments.library.get());
      const Dataset* dataset = slash == std::string::npos
                                   ? &material->preferred_dataset()
                                   : material->dataset(std::string_view(text).substr(slash + 1));
      if (dataset == nullptr)
        throw Error::at(text, "no such dataset", "a dataset of " + material->id + ", see etak show");
      add(*material, *dataset);
    }
  }
  write_output(arguments.output,
               arguments.output.format == "json" ? choice_json(choices, costs) : choice_text(choices, costs));
  return status;
}

}  // namespace etak::cli
