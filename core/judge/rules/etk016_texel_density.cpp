// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

std::string texels_text(double texels) {
  return number(texels, 3) + " texels a unit";
}

void report(RuleCheck& check, const TextureDensity& found, const std::string& limit) {
  Finding& finding = check.report();
  finding.file = found.label;
  finding.material = found.material;
  finding.value = texels_text(found.texels);
  finding.limit = limit;
  finding.message = "the texture has " + finding.value +
                    " of the scene on this material, where the project asks for " + limit;
}

}  // namespace

constinit const Rule etk016_texel_density{
    .id = "ETK016",
    .slug = "texel-density",
    .title = "A texture is finer or coarser in the scene than the project asks for",
    .severity = Severity::warning,
    .needs = {Need::header},
    .parameters = {{"colour_texels", 0, 0, "texels",
                    "of colours, F0 and emission for a unit of the scene; 0: any"},
                   {"normal_texels", 0, 0, "texels", "of normal maps for a unit of the scene; 0: any"},
                   {"data_texels", 0, 0, "texels",
                    "of roughness, metallic, gloss and occlusion for a unit of the scene; 0: any"},
                   {"factor", 2, 2, "times", "by which a texture may have more of them or fewer"},
                   {"spread", 0, 0, "times",
                    "by which the finest colours of a scene may be finer than the coarsest; 0: any"}},
    .source = "The budget of the project, in etak.toml",
    .what =
        "A texture of a glTF scene has more than `factor` times as many texels for a unit of the scene as [rules] ETK016 of etak.toml asks for its class, or fewer than that part; or two materials differ by more than `spread`. Judged on the whole of a material's triangles. Silent without a number.",
    .why =
        "One sharp and one blurred thing side by side look wrong at any distance, and texels that nobody sees cost memory.",
    .example = "A mug of 2048 texels beside a table of 512, both a metre wide in the picture.",
    .fix = "Scale the UVs of the material, or export the texture at the size that fits.",
    .check = [](RuleCheck& check) {
      if (!check.evidence.scene) return;
      const double factor = std::max(1.0, check.parameter("factor")), spread = check.parameter("spread");
      const TextureDensity *least = nullptr, *most = nullptr;
      for (const TextureDensity& each : check.evidence.scene->densities) {
        const double wanted = check.parameter(parameter_of_class(each.role, "texels"));
        if (wanted > 0 && (each.texels > wanted * factor || each.texels < wanted / factor))
          report(check, each, number(wanted / factor, 3) + " to " + number(wanted * factor, 3));
        if (picture_class(each.role) != PictureClass::colour) continue;
        if (least == nullptr || each.texels < least->texels) least = &each;
        if (most == nullptr || each.texels > most->texels) most = &each;
      }
      if (spread <= 0 || least == nullptr || most->texels <= spread * least->texels) return;
      report(check, *most,
             "at most " + number(spread, 3) + " times the " + number(least->texels, 3) + " of " +
                 least->material);
    }};

}  // namespace etak
