// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/options.h"

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "app/cli/output/output.h"
#include "app/cli/pictures/pictures.h"
#include "core/base/edit_distance.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/number.h"
#include "core/material/find.h"

namespace etak::cli {
namespace {

// The parts of `text` between separators, without empty ones.
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    if (end > 0) out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

// The value that `parse` makes of the text of an option; `standard` where the option was not given.
template <class Value, class Parse>
Value chosen(const char* option, const std::string& text, Value standard, Parse parse, const char* expected) {
  if (text.empty()) return standard;
  if (const auto value = parse(text)) return *value;
  throw Error::at(option, printable(text), expected);
}

}  // namespace

const MaterialLibrary& Library::get() {
  if (library_) return *library_;
  MaterialLibrary library = MaterialLibrary::builtin();
  std::vector<std::string> skipped;
  for (const std::string& folder : all_folders()) library.add_folder(folder, &skipped);
  if (!skipped.empty()) complain(skipped_remark(skipped));
  return library_.emplace(std::move(library));
}

std::vector<std::string> Library::all_folders() const {
  std::vector<std::string> out;
  if (const char* paths = std::getenv("ETAK_LIBRARY"))
    for (const std::string_view folder : split(paths, ':')) out.emplace_back(folder);
  out.insert(out.end(), folders.begin(), folders.end());
  return out;
}

void add_class_option(Command verb, std::vector<std::string>& classes, const std::string& help) {
  verb.option("--class", classes, help).value_name("CLASS").one_at_a_time();
}

void check_classes(const std::vector<std::string>& classes) {
  for (const std::string& each : classes)
    if (std::find(material_classes.begin(), material_classes.end(), each) == material_classes.end())
      throw Error::at(
          "--class", printable(each),
          joined(material_classes) + did_you_mean(each, {material_classes.begin(), material_classes.end()}));
}

void add_library_options(Command verb, Library& library) {
  verb.option(
          "--library", library.folders,
          "folder of material files laid over the built-in library; may be given again. ETAK_LIBRARY holds "
          "more, with ':' between")
      .value_name("DIR")
      .one_at_a_time()
      .common();
}

void add_compute_options(Command verb, ComputeArguments& arguments) {
  const std::string group = "Computation";
  const auto add = [&](const char* name, std::string& value, const char* text) {
    return verb.option(name, value, text).group(group);
  };
  add("--observer", arguments.observer, "whose colour-matching functions")
      .words({"1931-2deg", "1964-10deg"})
      .show_default("1931-2deg");
  add("--illuminant", arguments.illuminant, "light under which F0 has its colour")
      .words({"D65", "D50", "A", "E"})
      .show_default("D65");
  add("--interpolation", arguments.interpolation, "of n and k between the samples")
      .words({"linear", "pchip"})
      .show_default("linear");
  add("--method,--integration", arguments.method, "integration over the spectrum")
      .words({"1nm", "exact", "auto", "5nm", "10nm", "20nm", "e308-10nm", "e308-20nm", "point-650-550-450",
              "point-643-562-396"})
      .show_default("1nm");
  add("--integration-bound", arguments.integration_bound,
      "of the estimated error of X, Y and Z, for --integration auto (default 1e-5)")
      .value_name("NUMBER");
  add("--space", arguments.space,
      "output space: srgb (default; also Rec.709, linear), acescg, rec2020, display-p3, xyz, in any case, or "
      "a "
      "colour space of an OpenColorIO config")
      .value_name("SPACE");
  add("--ocio", arguments.ocio, "OpenColorIO config to look --space up in (else $OCIO, else etak's own)")
      .reads_file()
      .value_name("CONFIG");
  add("--outside", arguments.outside, "medium in front: an index of refraction or a material such as water")
      .value_name("NUMBER|MATERIAL");
  verb.flag("--allow-extrapolation", arguments.allow_extrapolation,
            "give results where the data hold less than 0.95 of the luminous weight")
      .group(group);
}

F0Options f0_options(const ComputeArguments& arguments, Library& library) {
  F0Options out;
  out.viewing.observer = chosen("--observer", arguments.observer, out.viewing.observer, observer_named,
                                "1931-2deg or 1964-10deg");
  out.viewing.illuminant = chosen("--illuminant", arguments.illuminant, out.viewing.illuminant,
                                  illuminant_named, "D65, D50, A or E");
  out.interpolation = chosen("--interpolation", arguments.interpolation, out.interpolation,
                             interpolation_named, "linear or pchip");
  out.method = chosen(
      "--method", arguments.method, out.method, method_named,
      "1nm, exact, auto, 5nm, 10nm, 20nm, e308-10nm, e308-20nm, point-650-550-450 or point-643-562-396");
  if (!arguments.integration_bound.empty()) {
    const char* const option = "--integration-bound";
    if (out.method != Method::automatic)
      throw Error::at(option, "nothing is refined", "--integration auto beside it");
    if (!parse_number(arguments.integration_bound, out.integration_bound) || !(out.integration_bound > 0))
      throw Error::at(option, printable(arguments.integration_bound), "a number above 0, such as 1e-5");
  }
  out.allow_extrapolation = arguments.allow_extrapolation;
  if (!arguments.ocio.empty() && arguments.space.empty())
    throw Error::at("--ocio", "no colour space of it is named", "--space NAME beside it");
  // A config that is named on the line wins over a built-in space of the same name. A config of $OCIO wins
  // over the aliases of the built-in spaces, but not over the names that etak itself writes.
  auto built_in = arguments.ocio.empty() ? rgb_space_named(arguments.space) : std::nullopt;
  const char* const config = std::getenv("OCIO");
  if (built_in && config != nullptr && *config != '\0' && arguments.space != name(*built_in))
    built_in.reset();
  if (built_in)
    out.space = *built_in;
  else if (!arguments.space.empty())
    out.custom_space = pictures("--space").open_space(arguments.ocio, arguments.space);
  // The library is opened only where the line names a medium, which few runs do.
  if (!arguments.outside.empty())
    out.outside = outside_medium(library.get(), arguments.outside, "--outside",
                                 NameWords{.place = {}, .found = "no material has this name", .instead = {}});
  return out;
}

void add_table_options(Command verb, TableArguments& arguments) {
  const std::string group = "Tables";
  verb.option("--unit", arguments.unit, "unit of the wavelengths in tables; wins over the header")
      .words({"nm", "um", "A", "eV"})
      .group(group);
  verb.option("--columns", arguments.columns,
              "columns of a table without header, such as wavelength,n,k or wavelength,R; _ skips one")
      .value_name("NAME,...")
      .group(group);
  verb.option("--duplicates", arguments.duplicates, "equal wavelengths with other values in tables")
      .words({"refuse", "first", "mean"})
      .show_default()
      .group(group);
}

TableOptions table_options(const TableArguments& arguments) {
  TableOptions out;
  if (!arguments.unit.empty()) {
    out.unit = wavelength_unit_named(arguments.unit);
    if (!out.unit) throw Error::at("--unit", printable(arguments.unit), "nm, um, A or eV");
  }
  out.columns = split(arguments.columns, ',');
  const auto duplicates = [](const std::string& text) -> std::optional<Duplicates> {
    if (text == "refuse") return Duplicates::refuse;
    if (text == "first") return Duplicates::first;
    if (text == "mean") return Duplicates::mean;
    return std::nullopt;
  };
  out.duplicates =
      chosen("--duplicates", arguments.duplicates, Duplicates::refuse, duplicates, "refuse, first or mean");
  return out;
}

void add_thread_option(Command verb, unsigned& threads) {
  verb.option("-j,--jobs", threads,
              "threads to use (default: all cores); the output is the same for any number")
      .value_name("N")
      .range(1u, 256u)
      .common();
}

unsigned thread_count(unsigned asked) {
  return asked != 0 ? asked : std::clamp(std::thread::hardware_concurrency(), 1u, 256u);
}

}  // namespace etak::cli
