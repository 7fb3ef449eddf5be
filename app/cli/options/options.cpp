// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/options.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>

#include "app/cli/output/output.h"
#include "app/cli/pictures/pictures.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/files/links.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/base/text/edit_distance.h"
#include "core/color/srgb.h"
#include "core/exchange/viewing_file.h"
#include "core/material/find.h"

namespace etak::cli {

const MaterialLibrary& Library::get() {
  if (library_) return *library_;
  std::vector<std::string> skipped;
  MaterialLibrary library = known_library(folders, &skipped);
  if (!skipped.empty()) complain(skipped_remark(skipped));
  return library_.emplace(std::move(library));
}

std::vector<std::string> Library::all_folders() const {
  std::vector<std::string> out = environment_libraries();
  out.insert(out.end(), folders.begin(), folders.end());
  return out;
}

void add_class_option(Command verb, std::vector<std::string>& classes, const std::string& help) {
  verb.option("--class", classes, help).value_name("CLASS").separated_by(',').one_at_a_time();
}

void add_library_options(Command verb, Library& library) {
  verb.option(
          "--library", library.folders,
          "folder of material files laid over the built-in library; may be given again. ETAK_LIBRARY holds more, with ':' between")
      .value_name("DIR")
      .one_at_a_time()
      .in_shards(InShards::free)  // what its materials change in the settings of a run is in their hash
      .common();
}

void add_solver_options(Command verb, F0Settings& settings) {
  const std::string group = "Computation";
  const auto add = [&](const char* name, std::string& value, const char* text) {
    return verb.option(name, value, text).group(group);
  };
  add("--observer", settings.observer,
      "whose colour-matching functions; FILE: a table of wavelength, x, y and z")
      .words({"1931-2deg", "1964-10deg", "FILE"})
      .show_default("1931-2deg");
  add("--illuminant", settings.illuminant,
      "light under which F0 has its colour; FILE: a table of wavelength and power")
      .words({"D65", "D50", "A", "E", "FILE"})
      .show_default("D65");
  add("--interpolation", settings.interpolation, "of n and k between the samples")
      .words({"linear", "pchip"})
      .show_default("linear");
  add("--method,--integration", settings.method, "integration over the spectrum")
      .words({"1nm", "exact", "auto", "5nm", "10nm", "20nm", "e308-10nm", "e308-20nm", "point-650-550-450",
              "point-643-562-396"})
      .show_default("1nm");
  add("--integration-bound", settings.integration_bound,
      "of the estimated error of X, Y and Z, for --integration auto (default 1e-5)")
      .value_name("NUMBER");
  add("--outside", settings.outside, "medium in front: an index of refraction or a material such as water")
      .value_name("NUMBER|MATERIAL");
  verb.flag(
          "--axis-average", settings.axis_average,
          "crystals as random grains: (2 ordinary + extraordinary) / 3, or a third of alpha, beta and gamma each")
      .group(group);
  verb.flag("--allow-extrapolation", settings.allow_extrapolation,
            "give results where the data hold less than 0.95 of the luminous weight")
      .group(group);
}

void add_compute_options(Command verb, F0Settings& settings) {
  add_solver_options(verb, settings);
  verb.option(
          "--space", settings.space,
          "output space: srgb (default; also Rec.709, linear), acescg, rec2020, display-p3, xyz, in any case, or a colour space of an OpenColorIO config")
      .value_name("SPACE")
      .group("Computation");
  verb.option("--ocio", settings.ocio,
              "OpenColorIO config to look --space up in (else $OCIO, else etak's own)")
      .reads_file()
      .value_name("CONFIG")
      .group("Computation");
}

F0Options f0_options(const F0Settings& settings, Library& library) {
  F0Settings opened = settings;
  open_viewing(opened);
  return f0_options(opened, library.when_asked(), [](const std::string& config, const std::string& name) {
    return pictures("--space").doors.open_space(config, name);
  });
}

void add_table_options(Command verb, TableSettings& settings) {
  const std::string group = "Tables";
  verb.option("--unit", settings.unit, "unit of the wavelengths in tables; wins over the header")
      .words({"nm", "um", "A", "eV"})
      .group(group);
  verb.option("--columns", settings.columns,
              "columns of a table without header, such as wavelength,n,k or wavelength,R; _ skips one")
      .value_name("NAME,...")
      .group(group);
  verb.option("--duplicates", settings.duplicates, "equal wavelengths with other values in tables")
      .words({"refuse", "first", "mean"})
      .show_default()
      .group(group);
  verb.option("--class", settings.material_class,
              "class of the input, such as metal or glass, in place of what it states or its numbers tell")
      .value_name("CLASS")
      .group(group);
  verb.option("--origin", settings.origin, "where the numbers come from, in place of what the input states")
      .words({"measured", "fit", "computed", "unknown"})
      .group(group);
}

void add_thread_option(Command verb, unsigned& threads) {
  verb.option("-j,--jobs", threads,
              "threads to use (default: all cores); the output is the same for any number")
      .value_name("N")
      .range(1u, 256u)
      .in_shards(InShards::free)
      .common();
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

void add_allow_empty_option(Command verb, bool& allow_empty) {
  verb.flag("--allow-empty", allow_empty, "a --files-from that names nothing is no failure");
}

Error empty_list(const std::string& list) {
  return Error::at("--files-from " + printable(list, 200), "names nothing", "names, or --allow-empty");
}

void add_follow_links(Command verb) {
  verb.flag(
          "--follow-links", [] { set_follow_links(true); },
          "follow links that lead out of the folder of a scene, manifest, layout or search")
      .common();
}

void add_input_timeout(CommandLine& line) {
  constexpr double longest = 1e6;
  for (Command verb : line.verbs())
    verb.option("--input-timeout", std::function<void(double)>(set_input_timeout),
                "how long a named pipe may be silent at first (default 60); standard input may for ever")
        .value_name("SECONDS")
        .range(0.0, longest)
        .in_shards(InShards::free)
        .common();
}

}  // namespace etak::cli
