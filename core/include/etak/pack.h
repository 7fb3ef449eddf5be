// SPDX-License-Identifier: Apache-2.0
#pragma once

// From materials to an atlas: pages of texture pairs and their layout in a folder. Link etak::core and
// etak::pack; etak::image_io for input pictures other than PNG, etak::project_files for editor projects.
//
// ```cpp
// #include <cstdio>
// #include <etak/pack.h>
//
// int main() {
//   etak::ManifestMaterial ring;
//   ring.name = "ring";
//   ring.specular = etak::LibrarySource{"silver", "", ""};
//   ring.gloss = etak::ConstantSource{{0.7, 0.7, 0.7}, {}};
//   etak::PackManifest manifest;                // or the path of a manifest, a scene or a folder of pictures
//   manifest.manifest.materials.push_back(ring);
//
//   etak::PackSettings settings;                // what etak pack takes, by the same names
//   settings.page = 1024;                       // texels a side
//   settings.keep = {"all"};                    // also what nobody needs: here a texel of one colour
//   etak::PackOptions options = etak::pack_options(settings);
//   options.output.overwrite = true;
//   const etak::PackResult result =
//       etak::pack(manifest, "rings", "atlas", options, etak::MaterialLibrary::builtin());
//   std::printf("%zu regions on %zu pages\n", result.regions, result.pages.size());
//   for (const std::string& file : result.files) std::printf("atlas/%s\n", file.c_str());
//   for (const std::string& remark : result.remarks) std::puts(remark.c_str());
// }
// ```
//
// Units and ranges
//   page         texels a side. The folder that the atlas goes into must exist, but for its last name
//   ImageSource  a picture file with the channels that are taken and the colour space of its codes
//   textures     A holds diffuse colour and alpha, B F0 and gloss: 8-bit codes, colours encoded as sRGB
//   layout       PackResult::layout, on disk layout.json: where each material lies, in texels
//   memory       PackRunOptions::memory bounds the bytes of pages and decoded pictures
//
// Errors
//   etak::Error  inputs that are missing, broken or do not fit each other, regions that fit no page, a target
//                that cannot be written. The folder is then as it was: its files appear all at once
//   PackCancelled  when PackRunOptions::cancelled said so
//
// Before long work, PackRunOptions::progress and `threads` are to be set. <etak/validate.h> checks an atlas,
// on disk or before it is put in place.

#include "core/atlas/layout.h"
#include "core/atlas/manifest.h"
#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/image/load.h"
#include "core/material/library.h"
#include "core/pack/pack.h"
#include "core/pack/settings.h"
#include "core/project/project_pack.h"
