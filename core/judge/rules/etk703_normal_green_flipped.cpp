// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

std::string_view convention_word(GreenAxis axis) {
  return axis == GreenAxis::opengl ? "OpenGL (green up)" : "DirectX (green down)";
}

}  // namespace

constinit const Rule etk703_normal_green_flipped{
    .id = "ETK703",
    .slug = "normal-green-flipped",
    .title = "Green of a normal map points the other way",
    .severity = Severity::error,
    .needs = {Need::maps},
    .source =
        "A surface's slope to the right changes downwards as its slope downwards changes to the right (equality of mixed derivatives)",
    .what =
        "The name (NormalDX, _nor_gl, Unreal's and Unity's words), glTF, which asks for OpenGL's, or `green` in etak.toml, for names that do not tell, says one convention and the relief is of the other: by the twist of the map itself, whose two mixed "
        "derivatives have equal signs for DirectX and opposite ones for OpenGL, or by the height map beside. Found from 64 texels that are twisted by 1.5 codes, where the two agree to 50 %; a warning below 70 "
        "%. Ridges along the axes alone have no twist and need the height map.",
    .why = "What stands out seems hollow when the light comes from above or below.",
    .example = "A map downloaded as NormalDX and renamed for a glTF export.",
    .fix = "Invert the green channel, or correct the name.",
    .check = [](RuleCheck& check) {
      for_each_map(check, FileRole::normal, [&](const MapEvidence& map) {
        const NormalDamage damage = damage_of(map);
        const bool by_name = map.green != GreenAxis::unsaid;
        const GreenAxis said = by_name ? map.green : check.settings.green;
        if (said == GreenAxis::unsaid || damage == NormalDamage::height || damage == NormalDamage::constant ||
            damage == NormalDamage::empty)
          return;
        const MeasuredGreen measured = measured_green(map);
        if (measured.axis == GreenAxis::unsaid || measured.axis == said) return;
        Finding& finding = check.report(map);
        // Parts of the surface may be mirrored in the texture, so that only a clear case is an error.
        if (measured.agreement < 0.7) finding.severity = check.at_most(Severity::warning);
        finding.value = convention_word(measured.axis);
        finding.limit = convention_word(said);
        finding.message =
            "the relief is that of " + finding.value + ", but " +
            (by_name ? map.said_by : "green in etak.toml") + " says " + finding.limit + ": they agree to " +
            percent(measured.agreement) +
            (measured.by_height ? " with the height map beside" : " of the twist of the surface");
      });
    }};

}  // namespace etak
