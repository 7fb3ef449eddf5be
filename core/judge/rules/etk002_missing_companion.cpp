// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk002_missing_companion{
    .id = "ETK002",
    .slug = "missing-companion",
    .title = "One texture of the pair is missing",
    .severity = Severity::error,
    .source = "Schueler 2009: two RGBA textures per material",
    .what =
        "A diffuse picture without its specular one, or the reverse. An F0 picture on its own has a role of its own, \"f0\"; an atlas page may do with one where its layout says so.",
    .why =
        "Diffuse and specular share UVs and are judged together: energy, black diffuse under metal and the like need both.",
    .example = "crate_diff.png without crate_spec.png.",
    .fix = "Add the other texture, or give the picture the role \"f0\".",
    .check = [](RuleCheck& check) {
      if (check.target.manifest.one_texture) return;
      bool diffuse = false, specular = false;
      for (const TargetFile& file : check.target.files) {
        diffuse = diffuse || file.role == FileRole::diffuse_alpha;
        specular = specular || file.role == FileRole::specular_gloss;
      }
      if (diffuse == specular) return;
      Finding& finding = check.report();
      finding.value = diffuse ? "no specular + gloss" : "no diffuse + alpha";
      finding.limit = "both";
      finding.message = diffuse ? "a diffuse picture without its specular + gloss picture"
                                : "a specular + gloss picture without its diffuse picture";
    }};

}  // namespace etak
