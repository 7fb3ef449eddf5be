// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/color.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/color/srgb.h"

namespace etak::cli {

std::vector<double> typed_numbers(std::string_view text) {
  std::vector<double> out;
  for (;;) {
    const std::size_t comma = text.find(',');
    if (double value = 0; parse_number(trimmed(text.substr(0, comma), " "), value))
      out.push_back(value);
    else
      return {};
    if (comma == text.npos) return out;
    text.remove_prefix(comma + 1);
  }
}

LinearRgb typed_color(const std::string& place, std::string_view text) {
  if (text.starts_with('#')) return srgb_decode(parse_hex(text));
  const std::vector<double> out = typed_numbers(text);
  if (out.empty()) throw Error::at(place, printable(text), "one number, three with ',' between, or #rrggbb");
  if (out.size() == 1) return {out[0], out[0], out[0]};
  if (out.size() != 3)
    throw Error::at(place, std::to_string(out.size()) + " numbers", "one or three, or #rrggbb");
  return {out[0], out[1], out[2]};
}

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

LinearRgb typed_share(const std::string& place, std::string_view text) {
  const LinearRgb out = typed_color(place, text);
  for (const double value : vec(out))
    if (!(value >= 0 && value <= 1)) throw Error::at(place, number(value, 6), "0 to 1");
  return out;
}

}  // namespace etak::cli
