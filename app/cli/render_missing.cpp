// SPDX-License-Identifier: Apache-2.0
#include "app/cli/render.h"
#include "core/base/error.h"

namespace etak::cli {

int draw(RenderArguments&) {
  throw Error::at("etak render", "this etak was built without OpenImageIO", "one built with it");
}

}  // namespace etak::cli
