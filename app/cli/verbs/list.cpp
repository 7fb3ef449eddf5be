// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "app/cli/inputs/inputs.h"
#include "app/cli/list/catalogue.h"
#include "app/cli/list/names.h"
#include "app/cli/options/options.h"
#include "app/cli/output/form.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/ascii.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/number.h"
#include "core/color/srgb.h"

namespace etak::cli {
namespace {

struct ListArguments {
  std::vector<std::string> classes, names;
  std::string search, zone, names_from;
  OutputArguments output;
  Library library;
  unsigned threads = 0;
};

bool contains(std::string_view text, const std::string& lower_part) {
  return lower_case(text).find(lower_part) != std::string::npos;
}

bool fits(const CatalogueEntry& entry, const ListArguments& arguments) {
  const Material& material = entry.material;
  const auto& classes = arguments.classes;
  if (!classes.empty() && std::find(classes.begin(), classes.end(), material.material_class) == classes.end())
    return false;
  if (!arguments.zone.empty() && (!entry.result.zone || name(*entry.result.zone) != arguments.zone))
    return false;
  const std::string part = lower_case(arguments.search);
  return contains(material.id, part) || contains(material.name, part) || contains(material.group, part) ||
         std::any_of(material.aliases.begin(), material.aliases.end(),
                     [&](const std::string& alias) { return contains(alias, part); });
}

std::string table(const std::vector<const CatalogueEntry*>& entries, bool color) {
  std::size_t id_width = 2, name_width = 4, class_width = 5;
  for (const CatalogueEntry* entry : entries) {
    id_width = std::max(id_width, cell_width(entry->material.id));
    name_width = std::max(name_width, cell_width(entry->material.name));
    class_width = std::max(class_width, cell_width(entry->material.material_class));
  }
  const std::string gap = "  ";
  std::string out = (color ? "   " : "") + padded("id", id_width) + gap + padded("name", name_width) + gap +
                    padded("class", class_width) + gap + "datasets  sRGB     Y       zone    quality\n";
  for (const CatalogueEntry* entry : entries) {
    const Material& material = entry->material;
    const F0Result& result = entry->result;
    if (color)
      out += (result.refused() ? "  " : swatch(result.srgb8.r, result.srgb8.g, result.srgb8.b)) + " ";
    out += padded(material.id, id_width) + gap + padded(material.name, name_width) + gap +
           padded(material.material_class, class_width) + gap +
           padded(std::to_string(material.datasets.size()), 8) + gap;
    if (result.refused())
      out += "refused: " + line_text(result.refusal) + '\n';
    else
      out += hex(result.srgb8) + gap + padded(number(result.luminance, 4), 6) + gap +
             padded(result.zone ? name(*result.zone) : "-", 6) + gap + quality_text(*entry) + '\n';
  }
  return out;
}

std::string csv(const std::vector<const CatalogueEntry*>& entries) {
  std::string out = "id,name,class,datasets,preferred,hex,Y,zone,refusal,kind,flags\n";
  for (const CatalogueEntry* entry : entries) {
    const Material& material = entry->material;
    const F0Result& result = entry->result;
    const bool good = !result.refused();
    out += csv_field(material.id) + ',' + csv_field(material.name) + ',' +
           csv_field(material.material_class) + ',' + std::to_string(material.datasets.size()) + ',' +
           csv_field(material.preferred_dataset().id) + ',' + (good ? hex(result.srgb8) : "") + ',' +
           (good ? number(result.luminance, 9) : "") + ',' +
           (result.zone ? std::string(name(*result.zone)) : "") + ',' + csv_field(result.refusal) + ',' +
           std::string(name(material.preferred_dataset().origin)) + ',' + flag_names(*entry) + '\n';
  }
  return out;
}

std::string json_object(const CatalogueEntry& entry) {
  const Material& material = entry.material;
  const F0Result& result = entry.result;
  std::string out =
      "{\"id\": " + json(material.id) + ", \"name\": " + json(material.name) +
      ", \"aliases\": " + json_array_of(material.aliases) + ", \"class\": " + json(material.material_class) +
      (material.group.empty() ? "" : ", \"group\": " + json(material.group)) +
      ", \"datasets\": " + std::to_string(material.datasets.size()) +
      ", \"preferred\": " + json(material.preferred_dataset().id) +
      ", \"kind\": " + json(name(material.preferred_dataset().origin)) + ", \"flags\": " + json_flags(entry);
  if (result.refused()) return out + ", \"refusal\": " + json(result.refusal) + "}";
  return out + ", \"hex\": " + json(hex(result.srgb8)) + ", \"Y\": " + number(result.luminance, 9) +
         ", \"zone\": " + (result.zone ? json(name(*result.zone)) : "null") + "}";
}

std::string json_form(const std::vector<const CatalogueEntry*>& entries) {
  std::string out = "{\n  \"schema\": \"etak-list/1\",\n  \"materials\": [";
  for (std::size_t i = 0; i < entries.size(); ++i)
    out += (i == 0 ? "\n    " : ",\n    ") + json_object(*entries[i]);
  return out + (entries.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

std::string json_lines(const std::vector<const CatalogueEntry*>& entries) {
  std::string out;
  for (const CatalogueEntry* entry : entries) out += json_object(*entry) + '\n';
  return out;
}

int list_names(ListArguments& arguments) {
  if (!arguments.classes.empty() || !arguments.search.empty() || !arguments.zone.empty())
    throw Error::at("etak list", "names beside --class, --search or --zone", "one of the two");
  std::vector<std::string> names = arguments.names;
  if (!arguments.names_from.empty()) {
    const std::vector<std::string> more = ListedNames(arguments.names_from).take();
    names.insert(names.end(), more.begin(), more.end());
  }
  if (names.empty()) throw Error::at(arguments.names_from, "holds no name", "a name a line");
  const F0Solver solver{F0Options{}};
  std::vector<NameAnswer> answers;
  for (const std::string& each : names) answers.push_back(answer_name(arguments.library.get(), solver, each));
  write_output(arguments.output, names_text(answers, arguments.output.format));
  const auto answered = static_cast<std::size_t>(std::count_if(
      answers.begin(), answers.end(), [](const NameAnswer& a) { return a.material.has_value(); }));
  remark(arguments.output, std::to_string(answered) + " of " + std::to_string(answers.size()) +
                               " names answered by a material");
  return answered == answers.size() ? exit_ok : exit_findings;
}

int run(ListArguments& arguments) {
  if (!arguments.names.empty() || !arguments.names_from.empty()) return list_names(arguments);
  if (arguments.output.format == "markdown")
    refuse_form(arguments.output, "etak list", "without names", {"table", "csv", "json", "jsonl"}, "names");
  check_classes(arguments.classes);
  const F0Solver solver{F0Options{}};
  const std::vector<CatalogueEntry> all =
      catalogue(arguments.library.get(), solver, thread_count(arguments.threads));
  std::vector<const CatalogueEntry*> shown;
  for (const CatalogueEntry& entry : all)
    if (fits(entry, arguments)) shown.push_back(&entry);
  const std::string& format = arguments.output.format;
  write_output(arguments.output, format == "csv"     ? csv(shown)
                                 : format == "json"  ? json_form(shown)
                                 : format == "jsonl" ? json_lines(shown)
                                                     : table(shown, use_color(arguments.output)));
  remark(arguments.output, std::to_string(shown.size()) + " of " + std::to_string(all.size()) + " materials");
  return exit_ok;
}

}  // namespace

void add_list(CommandLine& line) {
  const auto arguments = std::make_shared<ListArguments>();
  Command verb = line.verb("list", "materials of the library, or what names are answered with");
  verb.option("NAME", arguments->names, "tell what these names are answered with").value_name("");
  verb.option("--names-from", arguments->names_from,
              "read more names from LIST, one per line or NUL-separated; - is standard input")
      .reads_file()
      .value_name("LIST");
  add_class_option(verb, arguments->classes, "only this class, such as metal or glass; may be repeated");
  verb.option("--search", arguments->search, "only where id, name, group or an alias contains TEXT")
      .value_name("TEXT");
  verb.option("--zone", arguments->zone,
              "only where the luminance of F0 lies below, inside or above 0.20-0.45; surfaces have no F0")
      .one_of({"below", "inside", "above"});
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"table", "csv", "json", "jsonl", "markdown"});
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "Names alone tell what each is answered with (etak list steel milk); the exit status is then 1 when "
      "one\n"
      "of them is answered by no material.\n"
      "Example:\n  etak list --class metal --zone above");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
