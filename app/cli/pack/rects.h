// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/cli/arguments.h"

namespace etak::cli {

/// The options of `etak pack --rects`, which packs bare rectangles in the form that packing benchmarks use.
struct PackRectsArguments {
  bool asked = false;
  std::string in, out, mode = "square", rotate = "0";
  std::string input;  // argument of the verb; where --rotate is a flag, the 0 or 1 behind it
  int pad = 0, effort = 100;
  unsigned threads = 1;
};

/// Adds --rects, --in, --mode and --pad to `verb`, and those of --out, --rotate, --effort and --threads that
/// it does not have. Where it has one of them, its value is copied from there.
void add_pack_rects_options(Command verb, PackRectsArguments& arguments);

/// Reads lines "w h" ('#' begins a comment line) and packs the rectangles. Writes "# pack_ms X" with the time
/// in milliseconds, then a line "page x y w h rot" for each rectangle, in the order of the input; w and h are
/// those on the page, after a rotation. Returns the exit status, 3 for a mode that is not offered; throws
/// Error.
int pack_rects_command(const PackRectsArguments& arguments);

}  // namespace etak::cli
