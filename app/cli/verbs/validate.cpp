// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/options/options.h"
#include "app/cli/options/shard.h"
#include "app/cli/output/form.h"
#include "app/cli/output/progress.h"
#include "app/cli/validate/validate.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/findings/output/explain.h"
#include "core/judge/rules.h"

namespace etak::cli {
namespace {

int run(ValidateArguments& arguments, const std::vector<GivenOption>& line) {
  if (!arguments.shard.empty()) {
    (void)asked_shard(arguments.shard);
    check_can_be_cut(line);
    if (!arguments.write_baseline.empty())
      throw Error::at("--write-baseline", "in one shard, and a baseline holds the findings of all",
                      "etak merge SHARD... --write-baseline FILE");
    arguments.line_digest = line_digest(line);
  }
  if (arguments.watch) return watch_files(arguments);
  if (!arguments.list_rules) return check_files(arguments);
  if (arguments.output.format != "text" && arguments.output.format != "json")
    refuse_form(arguments.output, "etak validate", "with --list-rules", {"text", "json"});
  write_output(arguments.output, arguments.output.format == "json" ? rules_json(rules()) : rules_table());
  return exit_ok;
}

void add_rule_options(Command verb, ValidateArguments& a) {
  const auto add = [&](const char* option, std::vector<std::string>& ids, const char* text) {
    verb.option(option, ids, text).value_name("RULE,...").separated_by(',').group("Rules");
  };
  verb.option("--profile", a.settings.profile, "which rules run, and how strict they are")
      .words({"default", "strict", "film", "custom"})
      .group("Rules");
  add("--select", a.settings.choice.select,
      "only these rules, ids or prefixes such as ETK1; the configuration may still turn some off");
  add("--only", a.settings.choice.only, "exactly these rules, whatever the configuration says");
  add("--extend-select", a.settings.choice.extend_select, "these rules too");
  add("--ignore", a.settings.choice.ignore, "without these rules; goes last");
  verb.flag("--list-rules", a.list_rules, "print the rule table and stop (--format text or json)")
      .in_shards(InShards::whole)
      .group("Rules");
  verb.option("--config", a.settings.config, "configuration (default: etak.toml of the first folder upwards)")
      .reads_file()
      .value_name("FILE")
      .in_shards(InShards::free)  // its settings count by what they say, wherever the file lies
      .group("Rules");
  verb.flag("--no-config", a.settings.no_config, "look for no etak.toml")
      .in_shards(InShards::free)
      .group("Rules");
}

void add_verdict_options(Command verb, ValidateArguments& a) {
  const char* group = "Verdict";
  verb.option("--fail-on", a.settings.fail_on,
              "least severity that fails the run (default: error, or what etak.toml says)")
      .words({"error", "warning", "info", "never"})
      .group(group);
  verb.option("--max-warnings", a.max_warnings, "more warnings than this fail the run")
      .value_name("N")
      .group(group);
  verb.flag("--exit-zero", a.exit_zero,
            "exit status 0 in spite of findings; what could not be checked stays 2")
      .group(group);
  verb.option("--baseline", a.baseline, "findings of this file are known and do not count")
      .reads_file()
      .value_name("FILE")
      .group(group);
  verb.option("--write-baseline", a.write_baseline, "record all findings as known")
      .value_name("FILE")
      .in_shards(InShards::output)
      .group(group);
  verb.option("--today", a.today,
              "date that expiring [[allow]] entries are held against (default: the system's)")
      .value_name("YYYY-MM-DD")
      .group(group);
}

}  // namespace

void declare_validate(CommandLine& line, const std::shared_ptr<ValidateArguments>& arguments) {
  ValidateArguments& a = *arguments;
  Command verb = line.verb("validate", "find impossible materials in textures, atlases, scenes and data");
  verb.option(
          "path", a.paths,
          "files, folders and pipes: texture pairs, metal-rough sets, atlas layouts, glTF scenes, material files, spectra; - is standard input")
      .reads_file()
      .value_name("PATH...")
      .in_shards(InShards::free);  // what they hold is in the digest of the files
  verb.option("--files-from", a.files_from,
              "file with the paths, one a line or separated by NUL bytes; - is standard input")
      .reads_file()
      .value_name("FILE")
      .in_shards(InShards::free);
  verb.option(
          "--changed-since", a.changed_since,
          "of the given folders and files, only what differs from where this branch left COMMIT, or is new to git; nothing changed is no failure")
      .value_name("COMMIT");
  verb.flag(
      "--allow-empty", a.allow_empty,
      "pass where there is nothing to check, also with an empty --files-from, and pass over named files of no known kind; else that is status 2");
  verb.flag("--list-files", a.list_files,
            "show what every file is taken for, and stop (--format text or json)")
      .in_shards(InShards::whole);
  verb.option("--role", a.role, "what the pictures are (default: by their names)")
      .words({"diffuse", "specular", "f0", "base-color", "metal-rough"});
  verb.option("--transfer", a.settings.transfer, "curve of the 8-bit codes")
      .words({"srgb", "power-2.2", "linear"})
      .show_default("srgb");
  verb.option("--alpha", a.settings.alpha, "what the alpha of diffuse is")
      .words({"mask", "transparency"})
      .show_default("mask");
  verb.option("--material", a.material, "the material that the pictures are of, an id or name of etak list")
      .value_name("MATERIAL");
  verb.option("--surface", a.surface_class, "surface class of the pictures, for ETK205, such as dry-sand")
      .value_name("SURFACE");
  add_rule_options(verb, a);
  add_verdict_options(verb, a);
  add_output_options(verb, a.output, {"text", "json", "sarif", "junit", "github", "csv", "html"});
  verb.option("--min-severity", a.min_severity,
              "findings below info, warning or error are not shown as text; given, infos are not folded")
      .words({"info", "warning", "error"});
  verb.option("--mask", a.mask_folder, "folder for a picture per finding: plateau red, transition yellow")
      .value_name("DIR")
      .in_shards(InShards::whole);
  verb.option(
          "--fix", a.fix_folder,
          "folder for repaired copies of the sets that can be repaired, and a page of before and after; the originals stay as they are")
      .value_name("DIR")
      .in_shards(InShards::whole);
  verb.flag("--watch", a.watch,
            "check again whenever a file changes, until interrupted; sets that did not change are not read")
      .in_shards(InShards::whole);
  verb.flag("--stats", a.stats, "say on standard error what was read, left out and how long it took")
      .in_shards(InShards::free);
  add_cache_options(verb, a.cache, "results here and do not check the same files again");
  add_shard_option(verb, a.shard);
  add_follow_links(verb);
  add_library_options(verb, a.library);
  add_progress_option(verb, a.output.progress);
  add_thread_option(verb, a.threads);
  verb.footer(
      "Exit status: 0 nothing at or above --fail-on, 1 findings, 2 not everything could be checked.\n"
      "-q with the text form prints the verdict alone.\n"
      "Example:\n  etak validate textures --format sarif -o findings.sarif");
  verb.runs([arguments, verb] { return run(*arguments, verb.given()); });
}

void add_validate(CommandLine& line) {
  declare_validate(line, std::make_shared<ValidateArguments>());
}

}  // namespace etak::cli
