// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk005_lossy_format{
    .id = "ETK005",
    .slug = "lossy-format",
    .title = "F0 or gloss in a lossy file",
    .severity = {Severity::warning, Severity::error},
    .needs = {Need::header},
    .source = "etak: chroma subsampling alone moves the channels of a grey apart by more than ETK106 allows",
    .what = "JPEG or lossy WebP holds F0, gloss or metal-rough. Textures in blocks for a GPU are for ETK017.",
    .why = "Block noise becomes false F0 and false roughness, and subsampled chroma colours dielectrics.",
    .example = "An ORM texture saved as JPEG to save disk.",
    .fix = "Keep F0 and gloss in PNG, EXR or a lossless texture container.",
    .check = [](RuleCheck& check) {
      for (const PictureEvidence& picture : check.evidence.headers) {
        const bool holds_f0 = picture.role == FileRole::specular_gloss || picture.role == FileRole::f0_only ||
                              (traits(picture.role).data && picture.role != FileRole::gloss);
        if (!picture.header.lossy || !picture.header.blocks.empty() || !holds_f0) continue;
        Finding& finding = check.report(picture);
        finding.value = picture.header.format;
        finding.message =
            std::string(name(picture.role)) + " picture in a lossy format, " + picture.header.format;
      }
    }};

}  // namespace etak
