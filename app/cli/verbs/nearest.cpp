// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "app/cli/list/catalogue.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/number.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"

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

struct Match {
  const CatalogueEntry* entry = nullptr;
  double delta_e = 0;
};

constexpr const char* color_forms =
    "a hex colour (#ffe29b), 8-bit codes (255,226,155), or linear values with --linear (1.0,0.76,0.33)";

// The three numbers of "r,g,b"; throws where there are more, fewer or none.
std::array<double, 3> three_numbers(const std::string& text) {
  std::array<double, 3> out{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (i == 2))
      throw Error::at(printable(text), "is no colour", color_forms);
    std::string_view part = rest.substr(0, comma);
    while (part.starts_with(' ')) part.remove_prefix(1);
    while (part.ends_with(' ')) part.remove_suffix(1);
    if (!parse_number(part, out[i])) throw Error::at(printable(text), "is no colour", color_forms);
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

// A surface's diffuse colour is no F0: it is offered only where its class was asked for.
bool may_be_offered(const Material& material, const std::vector<std::string>& classes) {
  if (classes.empty()) return gives_f0(material.material_class);
  return std::find(classes.begin(), classes.end(), material.material_class) != classes.end();
}

// An 8-bit colour is compared with the 8-bit colours of the library, so that a texture's own rounding and
// clipping cost nothing; a linear one with the unclipped values.
std::vector<Match> matches(const std::vector<CatalogueEntry>& entries, const NearestArguments& arguments) {
  Lab wanted;
  if (arguments.linear) {
    wanted = to_lab(to_rgb(three_numbers(arguments.color)));
  } else {
    wanted = to_lab(srgb_decode(eight_bit(arguments.color)));
  }
  std::vector<Match> out;
  for (const CatalogueEntry& entry : entries) {
    if (entry.result.refused() || !may_be_offered(entry.material, arguments.classes)) continue;
    const LinearRgb color = arguments.linear ? entry.result.srgb_linear : srgb_decode(entry.result.srgb8);
    out.push_back({&entry, delta_e2000(wanted, to_lab(color))});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Match& a, const Match& b) { return a.delta_e < b.delta_e; });
  out.resize(std::min(out.size(), arguments.count));
  return out;
}

std::string table(const std::vector<Match>& found, bool color) {
  std::size_t id_width = 2, name_width = 4, class_width = 5;
  for (const Match& match : found) {
    id_width = std::max(id_width, cell_width(match.entry->material.id));
    name_width = std::max(name_width, cell_width(match.entry->material.name));
    class_width = std::max(class_width, cell_width(match.entry->material.material_class));
  }
  std::string out = std::string(color ? "   " : "") + "dE2000  sRGB     " + padded("id", id_width) + "  " +
                    padded("name", name_width) + "  " + padded("class", class_width) + "  quality\n";
  for (const Match& match : found) {
    const Srgb8 codes = match.entry->result.srgb8;
    const Material& material = match.entry->material;
    if (color) out += swatch(codes.r, codes.g, codes.b) + " ";
    out += padded(number(match.delta_e, 4), 6) + "  " + hex(codes) + "  " + padded(material.id, id_width) +
           "  " + padded(material.name, name_width) + "  " + padded(material.material_class, class_width) +
           "  " + quality_text(*match.entry) + '\n';
  }
  return out;
}

std::string csv(const std::vector<Match>& found) {
  std::string out = "delta_e2000,hex,id,name,class,kind,flags\n";
  for (const Match& match : found) {
    const Material& material = match.entry->material;
    out += number(match.delta_e, 9) + ',' + hex(match.entry->result.srgb8) + ',' + csv_field(material.id) +
           ',' + csv_field(material.name) + ',' + csv_field(material.material_class) + ',' +
           std::string(name(material.preferred_dataset().origin)) + ',' + flag_names(*match.entry) + '\n';
  }
  return out;
}

std::string json_form(const std::vector<Match>& found, const NearestArguments& arguments) {
  std::string out = "{\n  \"schema\": \"etak-nearest/1\",\n  \"color\": " + json(arguments.color) +
                    ",\n  \"linear\": " + (arguments.linear ? "true" : "false") + ",\n  \"nearest\": [";
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Material& material = found[i].entry->material;
    out += std::string(i == 0 ? "" : ",") + "\n    {\"delta_e2000\": " + number(found[i].delta_e, 9) +
           ", \"hex\": " + json(hex(found[i].entry->result.srgb8)) + ", \"id\": " + json(material.id) +
           ", \"name\": " + json(material.name) + ", \"class\": " + json(material.material_class) +
           ", \"kind\": " + json(name(material.preferred_dataset().origin)) +
           ", \"flags\": " + json_flags(*found[i].entry) + "}";
  }
  return out + (found.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

// A surface's colour is diffuse: near as it may be, it is no F0.
void tell_surfaces(const std::vector<Match>& found, const OutputArguments& output) {
  std::string ids;
  for (const Match& match : found)
    if (match.entry->material.material_class == "surface")
      ids += (ids.empty() ? "" : ", ") + match.entry->material.id;
  if (!ids.empty()) remark(output, ids + ": of class surface, whose colour is diffuse: no F0");
}

int run(NearestArguments& arguments) {
  check_classes(arguments.classes);
  const F0Solver solver{F0Options{}};
  const std::vector<CatalogueEntry> all =
      catalogue(arguments.library.get(), solver, thread_count(arguments.threads));
  const std::vector<Match> found = matches(all, arguments);
  const std::string& format = arguments.output.format;
  write_output(arguments.output, format == "csv"    ? csv(found)
                                 : format == "json" ? json_form(found, arguments)
                                                    : table(found, use_color(arguments.output)));
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
