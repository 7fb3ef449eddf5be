// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/pack.h"

#include <filesystem>
#include <map>
#include <optional>

#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "app/cli/pack/page.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/validate/validate.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_folder.h"
#include "core/base/files/output_target.h"
#include "core/base/files/paths.h"
#include "core/base/memory.h"
#include "core/base/system.h"
#include "core/findings/output/formats.h"
#include "core/pack/pack.h"
#include "core/project/project_pack.h"
#include "core/validate/check_pack.h"

namespace etak::cli {
namespace {

// The configuration that `etak validate` would use for the result. Throws Error.
PackCheckOptions check_options(PackArguments& a) {
  PackCheckOptions out;
  out.config = validate_config(a.check, a.settings.out + "/layout.json", asked_materials(a.library));
  for (const std::string& each : out.config.remarks) remark(shown_as(a), each);
  out.never_fails = a.check.fail_on == never_fails;
  out.threads = thread_count(a.threads);
  out.version = ETAK_VERSION;
  return out;
}

// The texts that are said of an atlas.
//   check   null: the atlas was not checked
PackTold told_of(const PackResult& report, const PackCheck* check, bool stages) {
  PackTold out;
  out.text = report_text(report, stages);
  out.json = report_json(report, stages);
  out.remarks = report.remarks;
  const ValidationReport* findings = check == nullptr ? nullptr : check->report();
  if (findings == nullptr) return out;
  out.findings = validation_text(*findings, {false});
  out.findings_in_colour = validation_text(*findings, {true});
  out.verdict = verdict_of(*findings);
  out.failed = check->failed();
  out.incomplete = check->incomplete();
  return out;
}

// Writes the report and the findings. Returns the exit status.
int say(const PackArguments& a, const PackTold& told) {
  if (a.report == "json")
    write_output({}, told.json);
  else if (a.report == "text" && !a.quiet)
    write_output({}, told.text + (use_color({}) ? told.findings_in_colour : told.findings));
  if (a.report != "json")
    for (const std::string& each : told.remarks) remark(shown_as(a), each);
  // The reason of an exit status other than 0 is always told, even where the report is not.
  const bool verdict_shown = a.report == "json" || (a.report == "text" && !a.quiet);
  if ((told.failed || told.incomplete) && !verdict_shown) complain(a.settings.out + ": " + told.verdict);
  return told.incomplete ? exit_failure : told.failed ? exit_findings : exit_ok;
}

// Makes the allocator keep freed memory. The pictures of regions take megabytes and are freed soon; given
// back to the kernel, their memory would come again with page faults that cost more than the work on the
// texels.
void keep_memory_of_regions() {
  sys::keep_freed_memory(32 << 20, 512 << 20, 16 << 20);
}

// The options of the line as values. Throws Error that names the option.
PackOptions options_of(const PackArguments& a) {
  PackOptions out = pack_options(a.settings);
  out.input.space_config = space_config_file(a.settings.ocio);
  out.input.pictures.door = picture_door();
  out.input.pictures.open_space = [config = a.settings.ocio](const std::string& name) {
    return pictures(printable(name)).doors.open_source(config, name);
  };
  if (writes_floats(out.output.write))
    (void)pictures("--textures");  // throws before the work where the module is missing
  out.output.overwrite = may_replace(a.force);
  out.output.update = a.update;
  out.output.dry_run = a.dry_run;
  out.run.memory = memory_setting(a.memory);
  out.run.threads = thread_count(a.threads);
  out.run.version = ETAK_VERSION;
  return out;
}

void check_page_report(const PackArguments& a) {
  if (a.page_report.empty()) return;
  if (!is_in_atlas_folder(a) || is_there(a.settings.out)) check_file_target(a.page_report, true);
}

}  // namespace

OutputArguments shown_as(const PackArguments& arguments) {
  OutputArguments out;
  out.quiet = arguments.quiet;
  out.progress = arguments.progress;
  return out;
}

int pack_once(PackArguments& a) {
  if (a.settings.input.empty())
    throw Error::at("etak pack", "nothing to pack", "a manifest, a glTF scene or a folder");
  if (a.settings.out.empty()) throw Error::at("etak pack", "no folder to write", "-o DIR");
  PackOptions options = options_of(a);
  check_page_report(a);
  const std::optional<PackCheckOptions> checking =
      a.no_validate ? std::nullopt : std::optional(check_options(a));
  const auto key_now = [&] {
    if (a.kept == nullptr || a.dry_run) return std::string();
    return a.kept->key_of(identity_of(a, checking ? &checking->config : nullptr, options.input.space_config));
  };
  const std::string key = key_now();
  if (!key.empty())
    if (const auto told = atlas_from_cache(a, key)) {
      a.told = told->json;
      return say(a, *told);
    }
  std::optional<PackCheck> check;
  if (checking) check.emplace(a.settings.out, *checking).attach(options);
  PackPage page(a);
  page.attach(options);
  std::optional<Progress> progress(std::in_place, shown_as(a), 0, "pack");
  options.run.progress = [&](std::size_t done, std::size_t all) { progress->set(done, all); };
  std::optional<PackCache::Keeping> keeping;
  options.check.beside = [&](PackResult& report, OutputFolder* folder) {
    auto out = page.output(report, check ? &check->finish(report) : nullptr, folder);
    if (folder == nullptr || key.empty()) return out;
    PackTold told = told_of(report, check ? &*check : nullptr, false);
    told.page = page.written();
    std::vector<std::string> names = report.files;
    if (!a.page_report.empty() && !told.page)
      names.push_back(sys::path_text(std::filesystem::path(a.page_report).filename()));
    keeping = a.kept->gather(key, report, told, names, *folder);
    return out;
  };
  const PackResult report = with_memory_for(
      a.settings.input, [&] { return "its atlas " + a.settings.out; },
      [&] {
        options.input.other_manifest = project_reader(a.library.get());
        return pack(a.settings.input, a.settings.out, options, a.library.get());
      });
  progress.reset();
  // A file that changed meanwhile may have been read before or after.
  if (keeping && key_now() == key) keeping->keep();
  if (!a.batch_report.empty()) a.told = report_json(report, false);
  return say(a, told_of(report, check ? &*check : nullptr, a.stats));
}

int pack_atlas(PackArguments& a) {
  keep_memory_of_regions();
  for (const auto& [option, text] : {std::pair{"--shard", &a.shard}, {"--batch-report", &a.batch_report}})
    if (!text->empty() && a.batch.empty())
      throw Error::at(option, "without --batch", "--batch FILE, whose jobs it is about");
  if (!a.batch.empty()) return with_cache(a, pack_batch);
  if (a.watch) return pack_watch(a);
  return with_cache(a, pack_once);
}

}  // namespace etak::cli
