// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/pack.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>

#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "app/cli/pack/jobs.h"
#include "app/cli/pack/page.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/validate/request.h"
#include "core/atlas/pack/pack.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_folder.h"
#include "core/base/files/output_target.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/base/system.h"
#include "core/project/project_pack.h"
#include "core/validate/check_pack.h"
#include "core/validate/output/formats.h"

namespace etak::cli {
namespace {

std::size_t memory(const std::string& text) {
  if (text.empty()) return 0;
  const char unit = text.back();
  const int shift = unit == 'K' ? 10 : unit == 'M' ? 20 : unit == 'G' ? 30 : 0;
  double value = 0;
  if (!parse_number(shift == 0 ? text : text.substr(0, text.size() - 1), value) || !(value > 0) ||
      value > 1e15)
    throw Error::at("--memory", printable(text), "a number of bytes, with K, M or G for more");
  return static_cast<std::size_t>(value * static_cast<double>(std::size_t{1} << shift));
}

// The configuration that `etak validate` would use for the result. Throws Error.
PackCheckOptions check_options(PackArguments& a) {
  PackCheckOptions out;
  out.config = validate_config(a.check, a.settings.out + "/layout.json", asked_materials(a.library));
  out.never_fails = a.check.fail_on == never_fails;
  out.threads = thread_count(a.threads);
  out.version = ETAK_VERSION;
  return out;
}

// Writes the report and the findings.
//   check   null: the atlas was not checked
void say(const PackArguments& a, const PackResult& report, const PackCheck* check) {
  const ValidationReport* findings = check == nullptr ? nullptr : check->report();
  OutputArguments remarks;
  remarks.quiet = a.quiet;
  if (a.report == "json")
    write_output({}, report_json(report, a.stats));
  else if (a.report == "text" && !a.quiet)
    write_output({}, report_text(report, a.stats) +
                         (findings == nullptr ? "" : validation_text(*findings, {use_color({})})));
  if (a.report != "json")
    for (const std::string& each : report.remarks) remark(remarks, each);
  // The reason of an exit status other than 0 is always told, even where the report is not.
  const bool verdict_shown = a.report == "json" || (a.report == "text" && !a.quiet);
  if (findings != nullptr && (check->failed() || check->incomplete()) && !verdict_shown)
    complain(a.settings.out + ": " + verdict_of(*findings));
}

// Makes the allocator keep freed memory. The pictures of regions take megabytes and are freed soon; given
// back to the kernel, their memory would come again with page faults that cost more than the work on the
// texels.
void keep_memory_of_regions() {
  sys::keep_freed_memory(32 << 20, 512 << 20, 16 << 20);
}

// The path of the OpenColorIO config in use, because a change of its bytes is a change of the input; empty
// where it is etak's own.
std::string config_file(const std::string& asked) {
  if (!asked.empty()) return asked;
  const char* environment = std::getenv("OCIO");
  std::error_code failure;
  const std::string path = environment == nullptr ? "" : environment;
  return std::filesystem::is_regular_file(path, failure) ? path : "";
}

// The options of the line as values. Throws Error that names the option.
PackOptions options_of(const PackArguments& a) {
  PackOptions out = pack_options(a.settings);
  out.input.space_config = config_file(a.settings.ocio);
  out.input.pictures.door = picture_door();
  out.input.pictures.open_space = [config = a.settings.ocio](const std::string& name) {
    return pictures(printable(name)).open_source(config, name);
  };
  if (writes_floats(out.output.write))
    (void)pictures("--format");  // throws before the work where the module is missing
  out.output.overwrite = may_replace(a.force);
  out.output.update = a.update;
  out.output.dry_run = a.dry_run;
  out.run.memory = memory(a.memory);
  out.run.threads = thread_count(a.threads);
  out.run.version = ETAK_VERSION;
  return out;
}

void check_page_report(const PackArguments& a) {
  if (a.page_report.empty()) return;
  std::error_code failure;
  if (!is_in_atlas_folder(a) || std::filesystem::exists(a.settings.out, failure))
    check_file_target(a.page_report, true);
}

}  // namespace

int pack_once(PackArguments& a) {
  if (a.settings.input.empty())
    throw Error::at("etak pack", "nothing to pack", "a manifest, a glTF scene or a folder");
  if (a.settings.out.empty()) throw Error::at("etak pack", "no folder to write", "-o DIR");
  PackOptions options = options_of(a);
  check_page_report(a);
  std::optional<PackCheck> check;
  if (!a.no_validate) check.emplace(a.settings.out, check_options(a)).attach(options);
  PackPage page(a);
  page.attach(options);
  OutputArguments shown;
  shown.quiet = a.quiet;
  shown.progress = a.progress;
  std::optional<Progress> progress(std::in_place, shown, 0, "pack");
  options.run.progress = [&](std::size_t done, std::size_t all) { progress->set(done, all); };
  options.check.beside = [&](PackResult& report, OutputFolder* folder) {
    return page.output(report, check ? &check->finish(report) : nullptr, folder);
  };
  const PackResult report = with_memory_for(
      a.settings.input, [&] { return "its atlas " + a.settings.out; },
      [&] {
        options.input.other_manifest = project_reader(a.library.get());
        return pack(a.settings.input, a.settings.out, options, a.library.get());
      });
  progress.reset();
  say(a, report, check ? &*check : nullptr);
  if (!a.batch_report.empty()) a.told = report_json(report, false);
  if (check && check->incomplete()) return exit_failure;
  return check && check->failed() ? exit_findings : exit_ok;
}

int pack_atlas(PackArguments& a) {
  keep_memory_of_regions();
  if (!a.batch.empty()) return pack_batch(a);
  for (const auto& [option, text] : {std::pair{"--shard", &a.shard}, {"--batch-report", &a.batch_report}})
    if (!text->empty()) throw Error::at(option, "without --batch", "--batch FILE, whose jobs it is about");
  if (a.watch) return pack_watch(a);
  return pack_once(a);
}

}  // namespace etak::cli
