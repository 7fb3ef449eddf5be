// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/color.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/color/srgb.h"

namespace etak::cli {

void add_color_option(Command verb, const char* name, std::string& value, const char* help) {
  verb.option(name, value, help).value_name("R,G,B|#RRGGBB");
}

LinearRgb typed_emission(std::string_view text) {
  const LinearRgb out = typed_color("--emission", text);
  for (const double value : vec(out))
    if (!(value >= 0 && std::isfinite(value)))
      throw Error::at("--emission", number(value, 6), "finite numbers of at least 0");
  return out;
}

}  // namespace etak::cli
