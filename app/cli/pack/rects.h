// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "app/cli/arguments.h"

namespace etak::cli {

/// `etak pack --rects`: bare rectangles, as packing benchmarks exchange them.
struct PackRectsArguments {
  bool asked = false;
  std::string in, out, mode = "square", rotate = "0";
  std::string input;  // of a verb that has one: what stands behind a --rotate that is a flag
  int pad = 0, effort = 100;
  unsigned threads = 1;
};

/// Adds --rects, --in, --mode and --pad, and of --out, --rotate, --effort and --threads those that `verb`
/// does not have; the others are listened to.
void add_pack_rects_options(Command verb, PackRectsArguments& arguments);

/// Reads lines "w h" ('#' begins a comment line), packs, and writes "# pack_ms X" and one line
/// "page x y w h rot" for each rectangle, in the order of the input, w and h as placed. Returns the exit
/// status, 3 for a mode that is not offered; throws Error.
int pack_rects_command(const PackRectsArguments& arguments);

}  // namespace etak::cli
