// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "app/cli/options/options.h"
#include "app/cli/options/shard.h"
#include "app/cli/output/output.h"
#include "app/cli/output/progress.h"
#include "app/cli/pack/pack.h"
#include "app/cli/verbs.h"
#include "core/base/text/ascii.h"

namespace etak::cli {
namespace {

Option add_setting(Command verb, const PackSettingRow& row, const std::string& name, bool& value) {
  const std::string help = row.help_text();
  return row.is(PackSettingRow::flag) ? verb.flag(name, value, help) : verb.option(name, value, help);
}

template <class Value>
Option add_setting(Command verb, const PackSettingRow& row, const std::string& name, Value& value) {
  Option out = verb.option(name, value, row.help_text());
  if constexpr (std::is_same_v<Value, int>)
    out.range(static_cast<int>(row.least), static_cast<int>(row.most));
  else if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>)
    out.range(row.least, row.most);
  else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
    out.one_at_a_time();
  return out;
}

// The settings that the short help shows, beside the options that every verb has there.
bool in_short_help(std::string_view name) {
  return name == "page" || name == "islands" || name == "textures" || name == "gltf-form";
}

// --gloss is a number in every other verb.
void add_older_gloss(Command verb, PackSettings& settings, const std::vector<std::string>& words) {
  verb.option("--gloss", settings.gloss, "older name of --gloss-channel")
      .one_of(words)
      .group("")
      .each([](const std::string&) { complain("--gloss: is now called --gloss-channel"); });
}

// --format is the form of what a verb says, as everywhere; it was the form of the textures.
void take_format(PackArguments& a, const std::string& typed) {
  const std::string word = lower_case(typed);
  if (word == "text" || word == "json" || word == "none") {
    a.report = word;
    return;
  }
  a.settings.format = typed;
  complain("--format " + typed + ": the files of the textures are now asked for by --textures");
}

void add_settings(Command verb, PackSettings& settings) {
  for (const PackSettingRow& row : pack_setting_rows()) {
    const std::string name = "--" + std::string(row.name);
    Option option =
        std::visit([&](auto member) { return add_setting(verb, row, name, settings.*member); }, row.value);
    if (!in_short_help(row.name)) option.group(std::string(row.group));
    if (row.is(PackSettingRow::file)) option.reads_file();
    if (!row.words.empty()) option.one_of(row.word_list());
    if (!row.value_name.empty()) option.value_name(std::string(row.value_name));
    if (row.is(PackSettingRow::commas)) option.separated_by(',');
    if (row.older == "gloss") add_older_gloss(verb, settings, row.word_list());
    if (!row.is(PackSettingRow::shown)) continue;
    const auto* const text = std::get_if<std::string PackSettings::*>(&row.value);
    if (text != nullptr && (settings.**text).empty())
      option.show_default(row.word_list().front());
    else
      option.show_default();
  }
}

void add_output_group(Command verb, PackArguments& a) {
  const std::string group = "Output";
  verb.flag("--force", a.force, "replace files that are of no earlier atlas; ETAK_FORCE=1 says the same");
  verb.flag("-u,--update", a.update, "do nothing where the result of the same input and options is in place")
      .group(group);
  verb.flag("--dry-run", a.dry_run, "read, lay out and report, but write nothing").group(group);
  verb.option("--report", a.report, "form of the report on standard output: text, json or none; as --format")
      .one_of({"text", "json", "none"})
      .show_default()
      .group(group);
  verb.option("--format", a.format, "form of the report: text, json or none")
      .value_name("FORM")
      .group(group)
      .each([&a](const std::string& typed) { take_format(a, typed); });
  verb.option("--page-report", a.page_report,
              "HTML page to write: textures, layout, what was left out, findings")
      .value_name("FILE")
      .in_shards(InShards::one_file)
      .group(group);
  verb.option("--page-link", a.page_links,
              "a link in the head of that page, relative, http or https; may be given again")
      .value_name("TEXT=TARGET")
      .one_at_a_time()
      .group(group);
  verb.flag("--stats", a.stats, "with the time of each stage").group(group);
}

void add_finding_options(Command verb, PackArguments& a) {
  const std::string group = "Findings";
  verb.option(
          "--fail-on", a.check.fail_on,
          "least severity of the validator's findings that makes the exit status 1: error (default, or what etak.toml says), warning, info or never; the atlas is written all the same")
      .one_of({"error", "warning", "info", "never"})
      .group(group);
  verb.flag("--no-validate", a.no_validate, "do not check the pages").group(group);
  verb.option("--config", a.check.config,
              "configuration of the check (default: etak.toml of --output upwards)")
      .reads_file()
      .value_name("FILE")
      .group(group);
  verb.flag("--no-config", a.check.no_config, "look for no etak.toml").group(group);
}

void add_run_options(Command verb, PackArguments& a) {
  const std::string group = "Runs";
  verb.option("--batch", a.batch, "file of many jobs: {\"jobs\": [{\"input\", \"out\", options...}]}")
      .reads_file()
      .value_name("FILE")
      .group(group);
  verb.option("--batch-report", a.batch_report,
              "file for the reports of all jobs, or those of the shard, as JSON")
      .value_name("FILE")
      .in_shards(InShards::output)
      .group(group);
  add_shard_option(verb, a.shard);
  verb.option("--memory", a.memory, "most that pages may take, such as 512M or 2G")
      .value_name("SIZE")
      .group(group);
  verb.flag("--watch", a.watch, "pack again whenever an input changes, until interrupted")
      .in_shards(InShards::whole)
      .group(group);
  add_cache_options(verb, a.cache, "packed atlases here and do not pack the same input again");
  add_follow_links(verb);
  add_thread_option(verb, a.threads);
  verb.flag("-q,--quiet", a.quiet, "no remarks and no progress; errors still appear")
      .in_shards(InShards::output);
  add_progress_option(verb, a.progress);
}

}  // namespace

void declare_pack(CommandLine& line, const std::shared_ptr<PackArguments>& arguments) {
  Command verb = line.verb("pack", "materials into one atlas: texture pair, layout and glTF");
  verb.option("input", arguments->settings.input,
              "manifest or project (.json), glTF scene (.gltf, .glb), or folder of pictures")
      .reads_file()
      .value_name("INPUT");
  verb.option("-o,--output,--out", arguments->settings.out, "folder to write; --out is its older name")
      .value_name("DIR");
  add_settings(verb, arguments->settings);
  add_output_group(verb, *arguments);
  add_finding_options(verb, *arguments);
  add_run_options(verb, *arguments);
  add_library_options(verb, arguments->library);
  add_pack_rects_options(verb, arguments->rects);
  verb.footer(
      "Texture A holds diffuse and alpha, texture B F0 and gloss, colours sRGB-encoded. All files appear together or not at all. Last come the findings of etak validate for what was written.\n"
      "Exit status: 0, or 1 when there are findings at or above --fail-on, 2 when something failed.\n"
      "Example:\n  etak pack materials.json -o atlas --page 4096");
  verb.runs([arguments, verb] {
    if (arguments->rects.asked) return pack_rects_command(arguments->rects);
    if (!arguments->shard.empty() && !arguments->batch.empty()) check_can_be_cut(*arguments, verb.given());
    return pack_atlas(*arguments);
  });
}

void add_pack(CommandLine& line) {
  declare_pack(line, std::make_shared<PackArguments>());
}

}  // namespace etak::cli
