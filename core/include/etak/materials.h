// SPDX-License-Identifier: Apache-2.0
#pragma once

// Materials: the built-in library, material files, and their values in other programs. Link etak::core.
//
// ```cpp
// #include <cstdio>
// #include <etak/materials.h>
//
// int main() {
//   etak::MaterialLibrary library = etak::MaterialLibrary::builtin();
//   // library.add_folder("my-materials");      // *.json laid over the built-in ones
//
//   // By id, name, alias or formula; then the beginning of a dataset's id, or "" for the preferred one.
//   const etak::FoundDataset gold = etak::find_dataset(library, "Au", "johnson", {});
//   const etak::F0Options options;
//   const etak::F0Result f0 = etak::F0Solver(options).solve(gold.chosen().optics, gold.chosen().flags);
//   if (f0.refused()) {
//     std::puts(f0.refusal.c_str());
//     return 1;
//   }
//
//   // As a surface, polished to Schueler's gloss 0.8, and as the fields of another program.
//   const etak::ExportSurface surface =
//       etak::export_surface(gold.material, gold.chosen(), options, f0, {0, 0, 0}, 0.8);
//   const etak::EngineValues values = etak::engine_values(*etak::engine_target("unreal"), surface);
//   std::puts(etak::copy_text(values).c_str());
//   for (const etak::Change& change : values.changes) std::puts(etak::one_line(change).c_str());
//
//   std::vector<etak::Changes> changes;        // a list for each surface
//   const std::string glb = etak::gltf_document({&surface, 1}, etak::GltfMaterialForm::metal_rough,
//                                               etak::GltfContainer::glb, etak::Fit::clamp, changes);
//   std::printf("%zu bytes of glTF, %zu bytes of material file\n", glb.size(),
//               etak::format_material(gold.material).size());
// }
// ```
//
// Units and ranges
//   colours      linear light of ExportSurface::space; F0 is not clipped. Diffuse colours are Schueler's:
//                what the surface reflects is not taken off them
//   gloss        Schueler's gloss or a perceptual roughness, [0, 1]
//   Change       tells each value that a target cannot hold, what it got instead, and why
//   files        read_material_file() takes a material file (.json), a page of refractiveindex.info (.yml)
//                and a table of wavelength, n and k (.csv, .tsv, .txt, .dat) by material_file_kind()
//
// Errors
//   etak::Error  an unknown name (with the nearest ones), a broken file (with its row or JSON pointer), a
//                surface out of range
//
// A MaterialLibrary is const in use and shared between threads. <etak/f0.h> says more of F0Solver.

#include "core/base/error.h"
#include "core/exchange/engine_values.h"
#include "core/exchange/export_surface.h"
#include "core/exchange/export_values.h"
#include "core/exchange/gltf_material.h"
#include "core/exchange/material_file.h"
#include "core/exchange/material_input.h"
#include "core/exchange/material_x.h"
#include "core/exchange/rii/rii_page.h"
#include "core/material/catalogue.h"
#include "core/material/f0.h"
#include "core/material/find.h"
#include "core/material/json.h"
#include "core/material/library.h"
#include "core/material/names.h"
