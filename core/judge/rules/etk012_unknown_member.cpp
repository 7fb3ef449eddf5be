// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk012_unknown_member{
    .id = "ETK012",
    .slug = "unknown-member",
    .title = "A picture is named like a set and its word is not known",
    .severity = Severity::warning,
    .source = "etak",
    .what =
        "A picture's name begins with the name of a set that was judged beside it, and what follows is no word that tells a role.",
    .why =
        "A mistyped word takes the picture out of its set: without its metallic map a set passes for a dielectric.",
    .example = "wall_metalic_mask.png beside wall_basecolor.png and wall_roughness.png.",
    .fix =
        "Correct the word, or say in [names] of etak.toml what it means (\"ignore\" where no rule is to look at it).",
    // The finder of sets reports it: the pictures of a set do not tell what else lies beside them.
    .check = [](RuleCheck&) {}};

}  // namespace etak
