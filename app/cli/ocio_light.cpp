// SPDX-License-Identifier: Apache-2.0
#include "app/cli/custom_space.h"
#include "app/cli/image_program.h"
#include "core/base/error.h"

namespace etak::cli {

CustomSpace open_custom_space(const std::string&, const std::string& name) {
  become_image_program(
      "--space", printable(name) + " is no built-in space, and the program for OpenColorIO spaces is missing",
      std::string(built_in_spaces) + ", or an etak built with OpenColorIO");
}

}  // namespace etak::cli
