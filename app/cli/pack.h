// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/pack_rects.h"
#include "core/atlas/sources/plane.h"
#include "core/atlas/sources/sources.h"

namespace etak::cli {

/// `etak pack` as typed.
struct PackArguments {
  std::string input, out;
  std::string pattern = "{name}_{role}.png";
  std::string formats = "png", page_form = "auto", png_level, gloss, gutter = "auto", mips = "auto";
  std::string previous, choice, batch, memory, report = "text", gltf_form = "specular-ior";
  std::vector<std::string> keep, space_of;
  std::string ocio;
  std::string fail_on, config, page_report, progress = "auto";
  std::vector<std::string> page_links;
  int page = 4096, effort = 100, zstd = 0, scene = -1;
  double max_seconds = 0, extra_area = 5, texel_density = 0;
  std::optional<double> max_error;
  int view_height = 0;
  bool rotate = false, islands = false, bleed = false, all_scenes = false, drop_variants = false;
  bool update = false, dry_run = false, watch = false, stats = false, force = false, quiet = false;
  bool no_validate = false, no_config = false;
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

/// What only OpenImageIO writes is asked for: in etak-pack the process becomes etak-image.
void need_float_formats();

/// Opens spaces of an OpenColorIO config; in etak-pack the process becomes etak-image at the first of them.
///   config   path; empty: $OCIO, else the built-in one
SpaceOpener space_opener(const std::string& config);

}  // namespace etak::cli
