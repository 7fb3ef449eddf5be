// SPDX-License-Identifier: Apache-2.0
// What F0 results and options are called in outputs.
#include "core/base/number.h"
#include "core/material/f0.h"
#include "core/spectrum/own_viewing.h"

namespace etak {

Zone zone_of(double luminance) {
  if (luminance <= forbidden_zone_first) return Zone::below;
  return luminance < forbidden_zone_last ? Zone::inside : Zone::above;
}

std::string_view name(Zone zone) {
  return zone == Zone::below ? "below" : zone == Zone::inside ? "inside" : "above";
}

bool F0Result::out_of_gamut() const {
  return flags.has(Flag::out_of_gamut);
}

std::string space_name(const F0Options& options) {
  return options.custom_space ? options.custom_space->name : std::string(name(options.space));
}

std::string policy(const F0Options& o) {
  std::string text = o.interpolation == Interpolation::linear
                         ? "n and k linear in wavelength"
                         : "n and k by monotone cubic (pchip) in wavelength";
  text += ", ends held";
  if (o.method == Method::nm1)
    text += "; sum at 1 nm";
  else if (o.method == Method::automatic)
    text += "; integration auto: 20, 10, 5, 1 nm or exact, until X, Y, Z are within " +
            number(o.integration_bound, 3) + " (estimated)";
  else
    text.append("; integration ").append(name(o.method));
  if (samples_rgb(o.method)) {
    text += " (three samples as red, green, blue)";
  } else {
    text += o.viewing.observer == Observer::cie1931_2deg    ? ", 360-830 nm; CIE 1931 2-degree"
            : o.viewing.observer == Observer::cie1964_10deg ? ", 360-830 nm; CIE 1964 10-degree"
                                                            : ", 360-830 nm; own";
    text.append(" observer; illuminant ").append(name(o.viewing.illuminant));
    if (o.own_illuminant)
      if (const std::string said = light_remark(*o.own_illuminant); !said.empty()) text += " (" + said + ")";
    text += "; white is the same sum for R = 1";
  }
  text.append("; outside medium ").append(o.outside.label);
  if (o.instrument.aperture > 0)
    text += "; mean over the cone of aperture " + number(o.instrument.aperture, 4);
  if (o.instrument.scatter > 0) text += "; " + number(o.instrument.scatter, 4) + " of it lost by scatter";
  text.append(o.custom_space ? "; in " : "; linear ").append(space_name(o));
  text += "; 8 bit by ";
  text += o.method == Method::legacy_schueler ? "the power 1/2.2" : "the piecewise sRGB curve";
  text += ", rounded half up";
  if (o.allow_extrapolation) text += "; extrapolation allowed";
  return text;
}

}  // namespace etak
