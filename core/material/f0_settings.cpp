// SPDX-License-Identifier: Apache-2.0
#include "core/material/f0_settings.h"

#include <cmath>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/material/find.h"

namespace etak {
namespace {

double integration_bound(const F0Settings& settings, Method method) {
  const std::string place = setting("integration-bound");
  if (method != Method::automatic)
    throw Error::at(place, "nothing is refined", setting("method") + " auto beside it");
  double out = 0;
  if (!parse_number(settings.integration_bound, out) || !(out > 0))
    throw Error::at(place, printable(settings.integration_bound), "a number above 0, such as 1e-5");
  return out;
}

void set_space(const F0Settings& settings, const OpenSpace& open_space, F0Options& out) {
  if (!settings.ocio.empty() && settings.space.empty())
    throw Error::at(setting("ocio"), "no colour space of it is named", setting("space") + " NAME beside it");
  // A config that is named beside the space wins over a built-in space of the same name. A config of $OCIO
  // wins over the aliases of the built-in spaces, but not over the names that etak itself writes.
  auto built_in = settings.ocio.empty() ? rgb_space_named(settings.space) : std::nullopt;
  const char* const config = std::getenv("OCIO");
  if (built_in && config != nullptr && *config != '\0' && settings.space != name(*built_in)) built_in.reset();
  if (built_in)
    out.space = *built_in;
  else if (!settings.space.empty())
    out.custom_space = open_space(settings.ocio, settings.space);
}

void set_viewing(const F0Settings& settings, F0Options& out) {
  out.own_observer = settings.own_observer;
  out.own_illuminant = settings.own_illuminant;
  out.viewing.observer = out.own_observer ? *out.own_observer
                                          : setting_value("observer", settings.observer, out.viewing.observer,
                                                          observer_named, "1931-2deg or 1964-10deg");
  out.viewing.illuminant = out.own_illuminant
                               ? *out.own_illuminant
                               : setting_value("illuminant", settings.illuminant, out.viewing.illuminant,
                                               illuminant_named, "D65, D50, A or E");
  if (out.own_observer || out.own_illuminant)
    if (const double y = make_quadrature(Method::nm1, out.viewing).white()[1]; !(std::abs(y - 1) < 1e-6))
      throw Error::at(setting("illuminant"), "no light that the observer sees",
                      "a sum of power and y above 0");
}

}  // namespace

F0Options f0_options(const F0Settings& settings, const LibraryWhenAsked& library,
                     const OpenSpace& open_space) {
  F0Options out;
  set_viewing(settings, out);
  out.interpolation = setting_value("interpolation", settings.interpolation, out.interpolation,
                                    interpolation_named, "linear or pchip");
  out.method = setting_value(
      "method", settings.method, out.method, method_named,
      "1nm, exact, auto, 5nm, 10nm, 20nm, e308-10nm, e308-20nm, point-650-550-450 or point-643-562-396");
  if (!settings.integration_bound.empty()) out.integration_bound = integration_bound(settings, out.method);
  out.allow_extrapolation = settings.allow_extrapolation;
  set_space(settings, open_space, out);
  // The library is opened only where a medium is named, which is seldom.
  if (!settings.outside.empty())
    out.outside = outside_medium(library(), settings.outside, setting("outside"),
                                 NameWords{.place = {}, .found = "no material has this name", .instead = {}});
  return out;
}

}  // namespace etak
