// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk015_scene_over_budget{
    .id = "ETK015",
    .slug = "scene-over-budget",
    .title = "A scene has more textures, or takes more memory, than the project allows",
    .severity = Severity::error,
    .needs = {Need::header},
    .parameters = {{"textures", 0, 0, "pictures", "most pictures that materials of a scene read; 0: any"},
                   {"gpu_mib", 0, 0, "MiB",
                    "most memory of these on a GPU, with all mips and without block compression; 0: any"}},
    .source = "The budget of the project, in etak.toml",
    .what =
        "The materials of a glTF scene read more pictures, or pictures of more memory, than [rules] ETK015 of etak.toml allows. A picture that is read twice counts once. Silent without a limit.",
    .why = "What one asset takes, others lack.",
    .example = "A prop of twelve 4096 x 4096 pictures, 1 GiB, where 64 MiB were agreed on.",
    .fix = "Pack the scene (etak pack), or export smaller pictures.",
    .check = [](RuleCheck& check) {
      if (!check.evidence.scene) return;
      const SceneFacts& scene = *check.evidence.scene;
      const auto look = [&](double found, std::string_view parameter, const std::string& unit, int digits) {
        const double most = check.parameter(parameter);
        if (most <= 0 || found <= most) return;
        Finding& finding = check.report();
        finding.value = number(found, digits) + unit;
        finding.limit = number(most, 9) + unit;
        finding.message = "the materials of the scene read " + finding.value + ", where the project allows " +
                          finding.limit;
      };
      look(static_cast<double>(scene.textures), "textures", " textures", 9);
      look(static_cast<double>(scene.gpu_bytes) / (1 << 20), "gpu_mib", " MiB of textures", 4);
    }};

}  // namespace etak
