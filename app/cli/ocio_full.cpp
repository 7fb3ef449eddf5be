// SPDX-License-Identifier: Apache-2.0
#include "app/cli/custom_space.h"
#include "core/base/error.h"
#include "core/color/ocio.h"

namespace etak::cli {

CustomSpace open_custom_space(const std::string& config, const std::string& name) {
  const OcioSpace space = [&] {
    try {
      return OcioSpace::open(config, name);
    } catch (const Error& error) {
      if (!config.empty()) throw;
      throw Error(std::string(error.what()) + ", or a built-in space: " + built_in_spaces);
    }
  }();
  return {space.name(), [space](const Xyz& color, const Xyz& white) { return space.from_xyz(color, white); }};
}

void set_program_arguments(char**) {}

}  // namespace etak::cli
