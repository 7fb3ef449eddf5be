// SPDX-License-Identifier: Apache-2.0
#include "app/cli/image_program.h"
#include "app/cli/validate.h"

namespace etak::cli {

int check_files(ValidateArguments&) {
  become_companion("etak-pack", "etak validate", "the program that reads textures is missing",
                   "an etak built with zlib");
}

}  // namespace etak::cli
