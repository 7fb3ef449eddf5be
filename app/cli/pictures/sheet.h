// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "app/cli/pictures/render.h"
#include "core/image/image.h"

namespace etak::cli {

/// The contact sheet: eight materials (columns) with every model of the registry (rows). Beside each sphere
/// is its difference from the same with ggx-exact (of a diffuse model: with lambert). Five more rows use the
/// default models, with the light of the hemispheres alone, with that of etak's environment alone, and at
/// three values of gloss. Throws Error where a subject is given. All rows are more than a screen shows, so the
/// sheet has parts: "own", models whose lobe no other one has, "ggx", "lobes", all other models made of terms,
/// and "light", the diffuse models and the five more rows.
///   arguments   part, gloss or roughness, size (of one sphere; 128 in place of the default), lights, camera,
///               background, exposure and transfer are used
///   scene       gets exposure and transfer, for writing the sheet
Image draw_sheet(RenderArguments& arguments, unsigned threads, Scene& scene);

/// Draws the objects of --sweep side by side, each under its value. Throws Error for anything but
/// NAME=FIRST:LAST:COUNT (numbers at even steps) or NAME=VALUE,VALUE,..., with 2 to 64 values.
///   drawn   the picture of one of them
Image draw_sweep(const RenderArguments& arguments, const std::function<Image(RenderArguments&)>& drawn);

}  // namespace etak::cli
