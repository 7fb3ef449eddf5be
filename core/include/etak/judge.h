// SPDX-License-Identifier: Apache-2.0
#pragma once

// Checks of pictures in memory: no file is opened. Link etak::core. Checks of files are in <etak/validate.h>.
//
// ```cpp
// #include <cstdio>
// #include <etak/judge.h>
//
// int main() {
//   etak::Pictures pictures;
//   pictures.b = etak::Image8(64, 64, 4);  // F0 as sRGB codes, and gloss
//   for (int y = 0; y < 64; ++y)
//     for (int x = 0; x < 64; ++x) {
//       const int f0 = x < 32 ? 59 : 155;  // F0 0.044, as of stone, and 0.33, which few materials have
//       for (int c = 0; c < 3; ++c) pictures.b.at(x, y)[c] = static_cast<unsigned char>(f0);
//       pictures.b.at(x, y)[3] = static_cast<unsigned char>(64 + 2 * y);
//     }
//   etak::CheckTarget target;
//   target.files = {{etak::FileRole::f0_only, "", "stone_specular.png"}};
//   const etak::CheckedFile file = etak::check_pictures(target, pictures, {});
//   for (const etak::Finding& finding : file.findings)
//     std::printf("%s: %s\n", finding.rule.c_str(), finding.message.c_str());
// }
// ```
//
// Units and ranges
//   Finding      one place of one picture: rule, severity, box in texels, value and limit, cause and fix
//   codes        8-bit; the settings say by which curve they become linear light
//   target       the roles of the pictures, the tiles of an atlas, what is stated about the material
//   threads      never change the result
//
// Errors
//   findings     a rule that failed is ETK901, and CheckedFile::unreadable is then true

#include "core/judge/check_pictures.h"
#include "core/judge/rules.h"
