// SPDX-License-Identifier: Apache-2.0
#include "app/cli/image_program.h"
#include "app/cli/render.h"

namespace etak::cli {

int draw(RenderArguments&) {
  become_image_program("etak render", "the program that makes pictures is missing",
                       "an etak built with OpenImageIO and OpenColorIO");
}

}  // namespace etak::cli
