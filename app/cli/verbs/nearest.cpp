// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/ascii.h"
#include "core/color/srgb.h"
#include "core/pages/lists/lists.h"

namespace etak::cli {
namespace {

struct NearestArguments {
  std::string color;
  bool linear = false;
  std::size_t count = 5;
  std::vector<std::string> classes;
  OutputArguments output;
  Library library;
  unsigned threads = 0;
};

constexpr const char* color_forms =
    "a hex colour (#ffe29b), 8-bit codes (255,226,155), or linear values with --linear (1.0,0.76,0.33)";

// The three numbers of "r,g,b". Throws Error where there are more or fewer.
std::array<double, 3> three_numbers(const std::string& text) {
  std::array<double, 3> out{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (i == 2))
      throw Error::at(printable(text), "is no colour", color_forms);
    if (!parse_number(trimmed(rest.substr(0, comma), " "), out[i]))
      throw Error::at(printable(text), "is no colour", color_forms);
    rest.remove_prefix(i == 2 ? rest.size() : comma + 1);
  }
  return out;
}

Srgb8 eight_bit(const std::string& text) {
  if (text.find(',') == std::string::npos) return parse_hex(text);
  std::array<std::uint8_t, 3> codes{};
  const std::array<double, 3> values = three_numbers(text);
  for (std::size_t i = 0; i < 3; ++i) {
    codes[i] = static_cast<std::uint8_t>(std::clamp(values[i], 0.0, 255.0));
    if (codes[i] != values[i])
      throw Error::at(printable(text), number(values[i], 6) + " is no 8-bit code",
                      "whole numbers 0 to 255, or --linear");
  }
  return {codes[0], codes[1], codes[2]};
}

// Remarks on materials of class surface, whose colour is diffuse and no F0.
void tell_surfaces(const std::vector<NearMaterial>& found, const OutputArguments& output) {
  std::vector<std::string> ids;
  for (const NearMaterial& match : found)
    if (match.entry->material.material_class == "surface") ids.push_back(match.entry->material.id);
  if (!ids.empty()) remark(output, joined(ids) + ": of class surface, whose colour is diffuse: no F0");
}

int run(NearestArguments& arguments) {
  check_classes(arguments.classes);
  const F0Solver solver{F0Options{}};
  const std::vector<CatalogueEntry> all =
      catalogue(arguments.library.get(), solver, thread_count(arguments.threads));
  using Color = std::variant<LinearRgb, Srgb8>;
  const std::vector<NearMaterial> found = nearest_materials(
      all,
      arguments.linear ? Color(to_rgb(three_numbers(arguments.color))) : Color(eight_bit(arguments.color)),
      arguments.classes, arguments.count);
  const std::string& format = arguments.output.format;
  write_output(arguments.output, format == "csv"    ? nearest_csv(found)
                                 : format == "json" ? nearest_json(found, arguments.color, arguments.linear)
                                                    : nearest_table(found, use_color(arguments.output)));
  tell_surfaces(found, arguments.output);
  return exit_ok;
}

}  // namespace

void add_nearest(CommandLine& line) {
  const auto arguments = std::make_shared<NearestArguments>();
  Command verb = line.verb("nearest", "library materials whose F0 is nearest to a colour");
  verb.option("COLOUR", arguments->color, color_forms).required().value_name("");
  verb.flag("--linear", arguments->linear, "COLOUR is linear sRGB");
  verb.option("-n,--count", arguments->count, "how many to show").range(1, 10000).show_default();
  add_class_option(
      verb, arguments->classes,
      "only this class; may be repeated. Without it every class but surface, whose diffuse colours "
      "are no F0");
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"table", "csv", "json"});
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "The distance is CIEDE2000 between the colours under D65.\nExample:\n  etak nearest '#ffe29b' -n 3");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
