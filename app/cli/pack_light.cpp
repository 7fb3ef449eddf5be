// SPDX-License-Identifier: Apache-2.0
#include "app/cli/image_program.h"
#include "app/cli/pack.h"

namespace etak::cli {

int pack_atlas(PackArguments&) {
  become_companion("etak-pack", "etak pack", "the program that packs is missing", "an etak built with zlib");
}

}  // namespace etak::cli
