// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/surface_check.h"

namespace etak {

constinit const Rule etk807_colour_space_slip{
    .id = "ETK807",
    .slug = "colour-space-slip",
    .title = "A colour in another encoding than its input takes",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::material},
    .source =
        "The material library of etak; MaterialX 1.39, glTF 2.0 and USD: colours of surfaces are linear",
    .what =
        "A colour of a material document is made of codes of 8 bits (numbers from 1 to 255), or the F0 of a metal is more than 3 dE from every measured metal and within 2 dE of one once it is decoded from sRGB, or encoded.",
    .why = "An sRGB value taken as linear is too bright and too pale; the metal is another one then.",
    .example = "base_color 1, 0.894, 0.612 of gold, as a colour picker shows it.",
    .fix = "Type the linear value, or state colorspace=\"srgb_texture\" in MaterialX.",
    .check = [](RuleCheck& check) {
      for_each_surface(check, [&](const DocumentSurface& surface, const DocumentValues& values) {
        for (const SurfaceInput& input : surface.inputs)
          if (const ModelInput* of = model_input(surface.model, input.name);
              of != nullptr && is_eight_bit(*of, input))
            report_surface(check, surface, values, &input,
                           numbers_text(input.values) + "; these are codes of 8 bits");
        if (!values.f0 || values.sort == SurfaceSort::dielectric || values.f0_from == nullptr) return;
        if (is_what_it_is_called(known_materials(check.settings), surface, *values.f0)) return;
        if (const std::string slip = transfer_slip(known_materials(check.settings), *values.f0);
            !slip.empty())
          report_surface(check, surface, values, values.f0_from,
                         numbers_text({values.f0->r, values.f0->g, values.f0->b}) + "; " + slip);
      });
    }};

}  // namespace etak
