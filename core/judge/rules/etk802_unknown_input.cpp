// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/edit_distance.h"
#include "core/judge/rules/surface_check.h"

namespace etak {

namespace {

// How many numbers an input takes; empty: it has them.
std::string wrong_count(const DocumentSurface& surface, const ModelInput& of, const SurfaceInput& input) {
  const std::size_t count = input.values.size();
  if (count == 0 || surface.model == "values") return {};
  if (of.type == InputType::color && count != 3) return "3 numbers of a colour are expected";
  if (of.type == InputType::number && count != 1) return "one number is expected";
  return of.type == InputType::pair && count > 2 ? "2 numbers are expected" : "";
}

}  // namespace

constinit const Rule etk802_unknown_input{
    .id = "ETK802",
    .slug = "unknown-input",
    .title = "An input that its model does not have",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::material},
    .source = "Node definitions of MaterialX 1.39, glTF 2.0, UsdPreviewSurface 2.6",
    .what =
        "An input of a material document whose name its model does not have, that has another count of numbers, or whose colour space is not known.",
    .why = "A renderer passes it over and takes the default, without a word.",
    .example = "base_colour in an open_pbr_surface; metallic in a standard_surface.",
    .fix = "Write the name as the model's definition has it.",
    .check = [](RuleCheck& check) {
      for_each_surface(check, [&](const DocumentSurface& surface, const DocumentValues& values) {
        for (const SurfaceInput& input : surface.inputs) {
          const ModelInput* of = model_input(surface.model, input.name);
          if (of == nullptr)
            report_surface(
                check, surface, values, &input,
                "no input of " + surface.model + did_you_mean(input.name, input_names(surface.model)));
          else if (!input.problem.empty())
            report_surface(check, surface, values, &input, input.problem);
          else if (const std::string wrong = wrong_count(surface, *of, input); !wrong.empty())
            report_surface(check, surface, values, &input, numbers_text(input.values) + "; " + wrong);
        }
      });
    }};

}  // namespace etak
