// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>

#include "app/cli/empty_list.h"
#include "app/cli/explain.h"
#include "app/cli/file_options.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/validate/rules.h"

namespace etak::cli {
namespace {

int run(ValidateArguments& arguments) {
  if (!arguments.list_rules) return check_files(arguments);
  if (arguments.output.format != "text" && arguments.output.format != "json")
    throw Error::at("--format", arguments.output.format + " with --list-rules", "text or json");
  write_output(arguments.output, arguments.output.format == "json" ? rules_json(rules()) : rules_table());
  return exit_ok;
}

void add_rule_options(CLI::App& verb, ValidateArguments& a) {
  const auto add = [&](const char* option, std::vector<std::string>& ids, const char* text) {
    verb.add_option(option, ids, text)->type_name("ID,...")->delimiter(',')->group("Rules");
  };
  verb.add_option("--profile", a.profile, "default, strict, film or custom")->group("Rules");
  add("--select", a.choice.select,
      "only these rules, ids or prefixes such as ETK1; the configuration may still turn some off");
  add("--only", a.choice.only, "exactly these rules, whatever the configuration says");
  add("--extend-select", a.choice.extend_select, "these rules too");
  add("--ignore", a.choice.ignore, "without these rules; goes last");
  verb.add_flag("--list-rules", a.list_rules, "print the rule table and stop (--format text or json)")
      ->group("Rules");
  reads_file(
      verb.add_option("--config", a.config, "configuration (default: etak.toml of the first folder upwards)"))
      ->type_name("FILE")
      ->group("Rules");
  verb.add_flag("--no-config", a.no_config, "look for no etak.toml")->group("Rules");
}

void add_verdict_options(CLI::App& verb, ValidateArguments& a) {
  const char* group = "Verdict";
  verb.add_option("--fail-on", a.fail_on,
                  "least severity that fails the run: error (default), warning, info or never")
      ->group(group);
  verb.add_option("--max-warnings", a.max_warnings, "more warnings than this fail the run")
      ->type_name("N")
      ->group(group);
  verb.add_flag("--exit-zero", a.exit_zero,
                "exit status 0 in spite of findings; what could not be checked stays 2")
      ->group(group);
  reads_file(verb.add_option("--baseline", a.baseline, "findings of this file are known and do not count"))
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--write-baseline", a.write_baseline, "record all findings as known")
      ->type_name("FILE")
      ->group(group);
  verb.add_option("--today", a.today,
                  "date that expiring [[allow]] entries are held against (default: the system's)")
      ->type_name("YYYY-MM-DD")
      ->group(group);
}

}  // namespace

void add_validate(CLI::App& app, Verb& chosen) {
  const auto arguments = std::make_shared<ValidateArguments>();
  ValidateArguments& a = *arguments;
  CLI::App& verb =
      *app.add_subcommand("validate", "find impossible materials in textures, atlases, scenes and data");
  reads_file(verb.add_option("path", a.paths,
                             "files, folders and pipes: texture pairs, metal-rough sets, atlas layouts, glTF "
                             "scenes, material files, spectra; - is standard input"))
      ->type_name("PATH...");
  reads_file(verb.add_option("--files-from", a.files_from, "file with one path a line; - is standard input"))
      ->type_name("FILE");
  add_allow_empty_option(verb, a.allow_empty);
  verb.add_option("--role", a.role,
                  "what the pictures are: diffuse, specular, f0, base-color or metal-rough (default: by "
                  "their names)");
  verb.add_option("--transfer", a.transfer, "curve of the 8-bit codes: srgb (default), gamma22 or linear");
  verb.add_option("--alpha", a.alpha, "what the alpha of diffuse is: mask (default) or transparency");
  verb.add_option("--material", a.material,
                  "the material that the pictures are of, an id or name of etak list");
  verb.add_option("--surface", a.surface_class,
                  "surface class of the pictures, for ETK205, such as dry-sand");
  add_rule_options(verb, a);
  add_verdict_options(verb, a);
  add_output_options(verb, a.output, {"text", "json", "sarif", "junit", "github", "csv", "html"});
  verb.add_option("--mask", a.mask_folder, "folder for a picture per finding: plateau red, transition yellow")
      ->type_name("DIR");
  verb.add_flag("--stats", a.stats, "say on standard error what was read, left out and how long it took");
  verb.add_option("--cache", a.cache_folder, "keep results here and do not check the same files again")
      ->type_name("DIR");
  reads_file(
      verb.add_option("--cache-key", a.cache_key,
                      "secret of at least 16 bytes: entries of the cache that were written without it do "
                      "not count"))
      ->type_name("FILE");
  add_follow_links(verb);
  add_library_options(verb, a.library);
  add_progress_option(verb, a.output.progress);
  add_thread_option(verb, a.threads);
  verb.footer(
      "Exit status: 0 nothing at or above --fail-on, 1 findings, 2 not everything could be checked.\n"
      "Example:\n  etak validate textures --format sarif -o findings.sarif");
  verb.callback([arguments, &chosen] { chosen = [arguments] { return run(*arguments); }; });
}

}  // namespace etak::cli
