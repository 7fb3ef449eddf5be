// SPDX-License-Identifier: Apache-2.0
#include "core/material/f0/f0_settings.h"

#include <cmath>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/material/appearance.h"
#include "core/material/coverage.h"
#include "core/material/f0/f0_data.h"
#include "core/material/find.h"
#include "core/material/names.h"
#include "core/material/stack_text.h"

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

double number_setting(const char* name, const std::string& text) {
  double out = 0;
  if (!text.empty() && !parse_number(text, out)) throw Error::at(setting(name), printable(text), "a number");
  return out;
}

constexpr const char* coat_form =
    "an index above 0 or a clear material, maybe with a thickness: 1.5, pmma, water:2mm";

// Takes the thickness off the text of a coat, which is that of a stack of one layer but for its base.
std::string take_thickness(const std::string& text, const std::string& place, Coat& out) {
  if (!is_stack_text(text)) return text;
  const StackText parsed = parse_stack(text + "/base", place);
  const StackText::Layer& layer = parsed.layers.front();
  if (parsed.layers.size() > 1 || parsed.base != "base" || !layer.thickness_nm ||
      layer.rest.ends_with(":coherent"))
    throw Error::at(place, printable(text), coat_form);
  out.thickness_nm = *layer.thickness_nm;
  return layer.name;
}

}  // namespace

Coat coat_setting(const std::string& text, const LibraryWhenAsked& library) {
  const std::string place = setting("coat");
  Coat out;
  out.label = text;
  const std::string name = take_thickness(text, place, out);
  if (parse_number(name, out.n)) {
    if (!(out.n > 0 && out.n <= 1e4)) throw Error::at(place, printable(text), coat_form);
    if (name != text) throw Error::at(place, printable(text), "no thickness: an index alone absorbs nothing");
    out.medium.n = Spectrum{{550}, {out.n}};
    return out;
  }
  const NameWords words{.place = place, .instead = "an index"};
  const auto found = find_material(library(), name);
  if (!found || found->answer.by == NameKind::qualified) fail_unknown_name(library(), name, words);
  const Material& material = found->answer.material;
  const Dataset& dataset = dataset_named(material, found->dataset, place + ": " + material.id);
  const Clarity body = clarity(material, dataset);
  if (!body.clear)
    throw Error::at(place, material.id + "/" + dataset.id + " is not clear (" + body.reason + ")", coat_form);
  out.medium = std::get<OpticalConstants>(dataset.optics);
  const auto [first_nm, last_nm] = range_of(out.medium);
  if (!covers_enough(luminous_coverage(first_nm, last_nm)) || !body.body.n_d)
    throw Error::at(place,
                    material.id + "/" + dataset.id + " has n for " + number(first_nm, 6) + "-" +
                        number(last_nm, 6) + " nm",
                    "n of all visible light");
  out.n = *body.body.n_d;
  if (body.k_of != nullptr)
    out.medium.k = std::get<OpticalConstants>(body.k_of->optics).k;
  else if (out.thickness_nm > 0)
    throw Error::at(place, material.id + " has no k of visible light", "no thickness, which would not count");
  return out;
}

std::optional<Coat> coat_option(const std::string& text, const LibraryWhenAsked& library,
                                const F0Options& options, bool axis_average) {
  if (text.empty()) return std::nullopt;
  if (axis_average) throw Error::at(setting("coat"), "beside " + setting("axis-average"), "one of them");
  Coat out = coat_setting(text, library);
  if (options.instrument.any())
    throw Error::at(setting("coat"), "beside " + setting("aperture") + " or " + setting("scatter"),
                    "one of them");
  if (options.method == Method::exact || options.method == Method::automatic)
    throw Error::at(setting("method"), std::string(name(options.method)) + " beside a coat",
                    "1nm or another sum");
  return out;
}

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
  out.instrument = {number_setting("aperture", settings.aperture),
                    number_setting("scatter", settings.scatter)};
  set_space(settings, open_space, out);
  // The library is opened only where a medium is named, which is seldom.
  if (!settings.outside.empty())
    out.outside = outside_medium(library(), settings.outside, setting("outside"),
                                 NameWords{.place = {}, .found = "no material has this name", .instead = {}});
  return out;
}

}  // namespace etak
