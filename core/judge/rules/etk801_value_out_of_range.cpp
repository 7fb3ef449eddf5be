// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/judge/rules/surface_check.h"

namespace etak {

namespace {

// Gold's red is outside of sRGB: an F0 of a measured metal may be a little above 1.
bool is_metal_above_one(const RuleCheck& check, const DocumentSurface& surface, const ModelInput& of,
                        const DocumentValues& values) {
  if ((of.meaning != Meaning::f0 && of.meaning != Meaning::f82 && of.meaning != Meaning::base_color) ||
      !values.f0)
    return false;
  if (is_what_it_is_called(known_materials(check.settings), surface, *values.f0)) return true;
  const Measured nearest = nearest_measured(known_materials(check.settings), *values.f0, SurfaceSort::metal);
  return nearest.entry != nullptr && nearest.entry->metal && nearest.delta_e <= 3;
}

std::string range_text(const ModelInput& of) {
  if (!std::isfinite(of.most)) return number(of.least, 3) + " or more";
  return number(of.least, 3) + " to " + number(of.most, 3);
}

// glTF's index 0 says that F0 is 1.
bool is_special(const ModelInput& of, double value) {
  return of.meaning == Meaning::ior && of.model == "gltf" && value == 0;
}

}  // namespace

constinit const Rule etk801_value_out_of_range{
    .id = "ETK801",
    .slug = "value-out-of-range",
    .title = "A number that its input does not take",
    .severity = Severity::error,
    .needs = {Need::material},
    .source =
        "Node definitions of MaterialX 1.39, glTF 2.0, UsdPreviewSurface 2.6; no solid or liquid has an index below 1 in the visible range but metals",
    .what =
        "A number of a material document below the least or above the most that the model's definition allows: colours, weights, roughness and metalness outside of 0 to 1, an index of a dielectric below 1, negative lengths. An F0 of a measured metal may reach 1.1; another colour of at most 1.1 is a warning. Numbers that are codes of 8 bits are ETK807.",
    .why = "A colour above 1 reflects more than arrives; an index below 1 bends light the wrong way.",
    .example = "specular_ior 0.04: F0 typed in the place of the index.",
    .fix = "Bring the number into the range; F0 and index are different numbers (F0 0.04 is index 1.5).",
    .check = [](RuleCheck& check) {
      for_each_surface(check, [&](const DocumentSurface& surface, const DocumentValues& values) {
        for (const SurfaceInput& input : surface.inputs) {
          const ModelInput* of = model_input(surface.model, input.name);
          if (of == nullptr || of->type == InputType::other || is_eight_bit(*of, input)) continue;
          const bool above_one = is_metal_above_one(check, surface, *of, values);
          constexpr double rounding = 1e-6, most_of_metals = 1.1;
          const double most = above_one ? most_of_metals : of->most;
          if (std::ranges::all_of(input.values, [&](double value) {
                return (value >= of->least - rounding && value <= most + rounding) || is_special(*of, value);
              }))
            continue;
          Finding& finding = report_surface(check, surface, values, &input,
                                            numbers_text(input.values) + "; its range is " + range_text(*of));
          finding.limit = range_text(*of);
          // Conversions between colour spaces leave such numbers.
          if (of->type == InputType::color && std::ranges::all_of(input.values, [&](double value) {
                return value >= of->least && value <= most_of_metals;
              }))
            finding.severity = check.at_most(Severity::warning);
          if (of->meaning == Meaning::ior && input.values[0] > 0 && input.values[0] < 0.3)
            finding.cause = "possible cause: an F0 in the place of the index";
        }
      });
    }};

}  // namespace etak
