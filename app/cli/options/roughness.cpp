// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/roughness.h"

#include <string>

#include "core/base/error.h"
#include "core/base/number.h"

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

std::optional<Gloss> given_gloss(const RoughnessArguments& arguments) {
  const auto in_range = [](const char* option, double value) {
    if (!(value >= 0 && value <= 1)) throw Error::at(option, number(value, 6), "0 to 1");
  };
  if (arguments.gloss) in_range("--gloss", *arguments.gloss);
  if (arguments.roughness) in_range("--roughness", *arguments.roughness);
  if (arguments.gloss && arguments.roughness)
    throw Error::at("--roughness", "given beside --gloss", "one of the two: they say the same thing");
  if (arguments.gloss) return Gloss(*arguments.gloss);
  if (arguments.roughness) return Gloss::of_roughness(*arguments.roughness);
  return std::nullopt;
}

}  // namespace etak::cli
