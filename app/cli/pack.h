// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/pack_rects.h"
#include "core/atlas/plane.h"

namespace etak::cli {

/// `etak pack` as typed.
struct PackArguments {
  std::string input, out;
  std::string pattern = "{name}_{role}.png";
  std::string formats = "png", page_form = "auto", png_level, gloss, gutter = "auto", mips = "auto";
  std::string previous, choice, batch, memory, report = "text", gltf_form = "specular-ior";
  std::vector<std::string> keep;
  int page = 4096, effort = 100, zstd = 0, scene = -1;
  double max_seconds = 0, extra_area = 5;
  bool rotate = false, islands = false, bleed = false, all_scenes = false, drop_variants = false;
  bool update = false, dry_run = false, watch = false, stats = false, force = false, quiet = false;
  unsigned threads = 0;
  Library library;
  PackRectsArguments rects;
};

/// The work of the verb. In etak-pack and etak-image it packs (pack_run.cpp); in etak (pack_light.cpp), which
/// links no compressor, it becomes etak-pack.
int pack_atlas(PackArguments& arguments);

/// Where pictures other than plain PNGs come from. In etak-image (pack_full.cpp) OpenImageIO reads them; in
/// etak-pack (pack_png.cpp), which links no OpenImageIO, the process becomes etak-image at the first of them.
PictureDoor picture_door();

}  // namespace etak::cli
