// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/roughness.h"

#include <string>

namespace etak::cli {

void add_roughness_options(Command verb, RoughnessArguments& arguments, const char* whose) {
  verb.option("--gloss", arguments.gloss,
              std::string("Schueler's g ") + whose +
                  ", 0 to 1: exponent 2^(12 g); it reaches roughness 0.904 to 0.149 (default by class)")
      .value_name("G");
  verb.option("--roughness", arguments.roughness,
              std::string("perceptual roughness ") + whose +
                  " in place of --gloss, 0 (mirror) to 1: width of the lobe R^2")
      .value_name("R");
}

}  // namespace etak::cli
