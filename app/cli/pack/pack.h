// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/pack/rects.h"
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

/// The work of the verb.
int pack_atlas(PackArguments& arguments);

}  // namespace etak::cli
