// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk002(RuleCheck& check) {
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
}

}  // namespace

constinit const Rule etk002_missing_companion{
    "ETK002",
    "missing-companion",
    "One texture of the pair is missing",
    Severity::error,
    Severity::error,
    {},
    {},
    "Schueler 2009: two RGBA textures per material",
    "A diffuse picture without its specular one, or the reverse. An F0 picture on its own "
    "has a role of its own, \"f0\"; an atlas page may do with one where its layout says so.",
    "Diffuse and specular share UVs and are judged together: energy, black diffuse under "
    "metal and the like need both.",
    "crate_diff.png without crate_spec.png.",
    "Add the other texture, or give the picture the role \"f0\".",
    &etk002};

}  // namespace etak
