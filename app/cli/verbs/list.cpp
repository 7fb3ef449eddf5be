// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/form.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/pages/lists/lists.h"

namespace etak::cli {
namespace {

struct ListArguments {
  std::vector<std::string> names;
  std::string zone, names_from;
  CatalogueFilter filter;
  F0Settings compute;
  OutputArguments output;
  Library library;
  unsigned threads = 0;
};

int list_names(ListArguments& arguments) {
  if (!arguments.filter.classes.empty() || !arguments.filter.search.empty() || !arguments.zone.empty())
    throw Error::at("etak list", "names beside --class, --search or --zone", "one of the two");
  std::vector<std::string> names = arguments.names;
  if (!arguments.names_from.empty()) {
    const std::vector<std::string> more = ListedNames(arguments.names_from).take();
    names.insert(names.end(), more.begin(), more.end());
  }
  if (names.empty()) throw Error::at(arguments.names_from, "holds no name", "a name a line");
  const F0Solver solver{f0_options(arguments.compute, arguments.library)};
  std::vector<NameAnswer> answers;
  for (const std::string& each : names) answers.push_back(answer_name(arguments.library.get(), solver, each));
  const std::string& format = arguments.output.format;
  write_output(arguments.output, format == "csv"        ? names_csv(answers)
                                 : format == "json"     ? names_json(answers)
                                 : format == "jsonl"    ? names_jsonl(answers)
                                 : format == "markdown" ? names_markdown(answers)
                                                        : names_table(answers));
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
  check_classes(arguments.filter.classes);
  for (const Zone zone : {Zone::below, Zone::inside, Zone::above})
    if (arguments.zone == name(zone)) arguments.filter.zone = zone;
  const F0Solver solver{f0_options(arguments.compute, arguments.library)};
  const std::vector<CatalogueEntry> all = catalogue(
      arguments.library.get(), solver, thread_count(arguments.threads), arguments.compute.axis_average);
  std::vector<const CatalogueEntry*> shown;
  for (const CatalogueEntry& entry : all)
    if (fits(entry, arguments.filter)) shown.push_back(&entry);
  const std::string& format = arguments.output.format;
  write_output(arguments.output, format == "csv"     ? catalogue_csv(shown)
                                 : format == "json"  ? catalogue_json(shown)
                                 : format == "jsonl" ? catalogue_jsonl(shown)
                                                     : catalogue_table(shown, use_color(arguments.output)));
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
  add_class_option(verb, arguments->filter.classes,
                   "only this class, such as metal or glass; may be repeated");
  verb.option("--search", arguments->filter.search, "only where id, name, group or an alias contains TEXT")
      .value_name("TEXT");
  verb.option("--zone", arguments->zone,
              "only where the luminance of F0 lies below, inside or above 0.20-0.45; surfaces have no F0")
      .one_of({"below", "inside", "above"});
  add_compute_options(verb, arguments->compute);
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"table", "csv", "json", "jsonl", "markdown"});
  add_thread_option(verb, arguments->threads);
  verb.footer(
      "Names alone tell what each is answered with (etak list steel milk); the exit status is then 1 when one\n"
      "of them is answered by no material.\n"
      "Example:\n  etak list --class metal --zone above");
  verb.runs([arguments] { return run(*arguments); });
}

}  // namespace etak::cli
