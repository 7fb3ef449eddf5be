// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/demo/start_page.h"
#include "core/material/library.h"

namespace etak::demo {

// The parts of the start page, each of which fills its fields of the page's data.

/// The spheres of 24 materials with their values for programs, and the chart of ways to compute F.
void add_spheres(const MaterialLibrary& library, unsigned threads, StartPageData& data);

/// The demo's scene and atlas, and what the validator finds in materials with mistakes. The working folder is that
/// of the demo, which holds scene/manifest.json, atlas/layout.json and mistakes/.
void add_scene(unsigned threads, StartPageData& data);

/// Adds a card for each of the demo's other pages that is there.
void add_cards(StartPageData& data);

}  // namespace etak::demo
