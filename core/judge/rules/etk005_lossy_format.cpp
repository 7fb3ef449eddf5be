// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk005(RuleCheck& check) {
  for (const PictureEvidence& picture : check.evidence.headers) {
    const bool holds_f0 = picture.role == FileRole::specular_gloss || picture.role == FileRole::f0_only ||
                          (picture.role >= FileRole::metal_rough && picture.role <= FileRole::roughness);
    if (!picture.header.lossy || !holds_f0) continue;
    Finding& finding = check.report(picture);
    finding.value = picture.header.format;
    finding.message =
        std::string(name(picture.role)) + " picture in a lossy format, " + picture.header.format;
  }
}

}  // namespace

constinit const Rule etk005_lossy_format{
    "ETK005",
    "lossy-format",
    "F0 or gloss in a lossy file",
    Severity::warning,
    Severity::error,
    {Need::header},
    {},
    "etak: chroma subsampling alone moves the channels of a grey apart by more than ETK106 "
    "allows",
    "JPEG or lossy WebP holds F0, gloss or metal-rough.",
    "Block noise becomes false F0 and false roughness, and subsampled chroma colours "
    "dielectrics.",
    "An ORM texture saved as JPEG to save disk.",
    "Keep F0 and gloss in PNG, EXR or a lossless texture container.",
    &etk005};

}  // namespace etak
