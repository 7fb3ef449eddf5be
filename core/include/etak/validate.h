// SPDX-License-Identifier: Apache-2.0
#pragma once

// Checks of textures, atlases, scenes and material files against physics and their own layout. Link
// etak::core and etak::validate_files; etak::validate_config to read an etak.toml, etak::image_io for
// pictures other than PNG, etak::finding_pictures for masks and thumbnails of findings.
//
// ```cpp
// #include <cstdio>
// #include <etak/validate.h>
//
// int main() {
//   etak::ValidationRequest request;
//   request.inputs.paths = {"atlas"};                  // files and folders
//   request.config = etak::read_config(etak::find_config("atlas"));
//   request.run.door = etak::picture_door();        // of etak::image_io; without it PNG alone is read
//   request.run.threads = 2;
//   const etak::ValidationReport report = etak::validate(request);
//   std::fputs(etak::validation_text(report).c_str(), stdout);
//   for (const etak::CheckedFile& file : report.files)
//     for (const etak::Finding& finding : file.findings)
//       if (finding.severity == etak::Severity::error)
//         std::puts(etak::explanation(*etak::find_rule(finding.rule)).c_str());
//   return report.incomplete ? 2 : report.passed ? 0 : 1;
// }
// ```
//
// Units and ranges
//   Finding      one place of one file: rule, severity, box in texels, value and limit, cause and fix
//   codes        8-bit; the settings say by which curve they become linear light
//   F0           the forbidden zone is 0.20 < Y < 0.45 of the linear luminance
//   report       the same for any number of threads, and equal bytes for equal reports in every form:
//                validation_text(), _csv(), _json(), _sarif(), _junit(), _github()
//
// Errors
//   findings     what cannot be read is a finding (ETK001) and makes the report incomplete; so are rules that
//                failed (ETK901)
//   etak::Error  a configuration that is wrong, a cache folder that cannot be made
//
// PackCheck (core/validate/check_pack.h) looks at the pages of <etak/pack.h> before they are in place.

#include "core/base/error.h"
#include "core/findings/output/explain.h"
#include "core/findings/output/formats.h"
#include "core/findings/report.h"
#include "core/image/image_io.h"
#include "core/judge/rules.h"
#include "core/pages/finding_pictures.h"
#include "core/pages/validation_page.h"
#include "core/validate/check_pack.h"
#include "core/validate/config.h"
#include "core/validate/validate.h"
