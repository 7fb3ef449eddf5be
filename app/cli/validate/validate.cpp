// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate/validate.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/output/form.h"
#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "app/cli/pictures/pictures.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/files/output_file.h"
#include "core/base/files/output_target.h"
#include "core/base/files/output_tree.h"
#include "core/base/files/paths.h"
#include "core/base/files/read_places.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/base/system.h"
#include "core/findings/baseline.h"
#include "core/findings/output/formats.h"
#include "core/findings/suppress.h"
#include "core/judge/rules.h"
#include "core/pages/finding_pictures.h"
#include "core/pages/repair_page.h"
#include "core/validate/repairs/repair_files.h"
#include "core/validate/validate.h"

namespace etak::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* repairs_page = "repairs.html";  // in the folder of --fix

std::string form_of(const ValidationReport& report, const ValidateArguments& arguments,
                    const Settings& settings) {
  const std::string& format = arguments.output.format;
  if (format == "text") {
    TextOptions text{use_color(arguments.output)};
    text.findings = !arguments.output.quiet;
    text.least = severity_named(arguments.min_severity).value_or(Severity::info);
    text.fold_infos = arguments.min_severity.empty();
    return validation_text(report, text);
  }
  if (auto out = validation_form(format, report, {settings.fail_on, ETAK_VERSION})) return *std::move(out);
  const auto pictures =
      page_pictures(report, settings, picture_door(), most_page_pictures, thread_count(arguments.threads));
  return validation_page(report, pictures, {ETAK_VERSION, settings});
}

std::string count_text(std::size_t count, const char* one, const char* more) {
  return grouped(count) + ' ' + (count == 1 ? one : more);
}

// Tells that nothing was checked, and why: most often a path is wrong or the names of pictures tell no role.
void tell_nothing_checked(const ValidationReport& report) {
  const std::size_t unknown = report.unknown.size();
  std::string out =
      "nothing was checked: " + count_text(report.run.files, "file was", "files were") + " looked at";
  if (unknown > 0)
    out += ", " + count_text(unknown, "picture whose name tells", "pictures whose names tell") +
           " no role (--list-files shows which)";
  if (report.run.skipped > unknown)
    out += ", " + grouped(report.run.skipped - unknown) + " that no rule is about";
  complain(
      out +
      "; expected texture pairs, metal-rough sets, F0 pictures, atlas layouts, glTF scenes, material files or spectra, or --allow-empty");
}

// Names what could not be checked where the report goes to a file or is the verdict alone: a run that ends
// with status 2 says why.
void tell_not_checked(const ValidationReport& report, const ValidateArguments& arguments) {
  constexpr std::size_t most_named = 5;
  const std::string& file = arguments.output.file;
  if ((file.empty() || file == "-") && !arguments.output.quiet) return;
  std::size_t count = 0;
  for (const CheckedFile& each : report.files) {
    if (!each.unreadable || ++count > most_named) continue;
    // The finding of a pair or set names the file that is damaged.
    const auto why = std::ranges::find_if(each.findings, is_of_the_tool, &Finding::rule);
    const bool told = why != each.findings.end();
    complain(shown_path(told ? why->file : each.path, report.typed) + ": could not be checked" +
             (told ? ": " + sentence_of(*why) : ""));
  }
  if (count > most_named) complain(grouped(count - most_named) + " more files could not be checked");
}

void tell_unknown(const ValidationReport& report, const ValidateArguments& arguments) {
  constexpr std::size_t most_named = 5;
  if (report.unknown.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < std::min(most_named, report.unknown.size()); ++i)
    names += (i == 0 ? "" : ", ") + shown_path(report.unknown[i], report.typed);
  if (report.unknown.size() > most_named) names += ", ...";
  remark(arguments.output, count_text(report.unknown.size(), "picture was", "pictures were") +
                               " not recognised by name and not checked: " + names +
                               "; etak validate --list-files shows what every file is taken for");
}

void tell_stats(const ValidationReport& report, double seconds) {
  CheckStats sum;
  for (const CheckedFile& file : report.files) {
    sum.pictures_decoded += file.stats.pictures_decoded;
    sum.pictures_left_out += file.stats.pictures_left_out;
    sum.texels += file.stats.texels;
    sum.decode_seconds += file.stats.decode_seconds;
    sum.byte_seconds += file.stats.byte_seconds;
    sum.region_seconds += file.stats.region_seconds;
  }
  complain("stats: " + grouped(report.run.files) + " files, " + grouped(report.run.skipped) + " skipped, " +
           grouped(report.run.checks) + " checks, " + grouped(report.run.from_cache) + " from the cache" +
           (report.run.unchanged > 0 ? ", " + grouped(report.run.unchanged) + " unchanged" : ""));
  complain("stats: " + grouped(sum.pictures_decoded) + " pictures decoded, " +
           grouped(sum.pictures_left_out) + " left out because no rule needs them, " + grouped(sum.texels) +
           " texels");
  complain("stats: " + number(seconds, 3) + " s; summed over threads: decoding " +
           number(sum.decode_seconds, 3) + " s, byte rules " + number(sum.byte_seconds, 3) + " s, regions " +
           number(sum.region_seconds, 3) + " s");
}

// Checks the folder of an option before the work, and makes the folders above it where they are missing.
void check_folder(const char* option, const std::string& folder) {
  namespace fs = std::filesystem;
  const fs::path above = (fs::path(folder) / "").parent_path().parent_path();
  if (!above.empty()) (void)make_folders(above);
  if (is_there(folder) && !is_folder(folder))
    throw Error::at(option, printable(folder, 200) + " is no folder", "a folder");
  check_folder_target(folder, {}, Replace::files);
}

// Checks before the work whether the outputs can be written.
void check_targets(const ValidateArguments& arguments) {
  check_output(arguments.output);
  check_cache_report(arguments.cache, may_replace(arguments.output.force));
  if (!arguments.write_baseline.empty()) (void)replaces_baseline(arguments.write_baseline);
  const std::string& fix = arguments.fix_folder;
  refuse_same_outputs({{"-o", arguments.output.file},
                       {"--write-baseline", arguments.write_baseline},
                       {"--cache-report", arguments.cache.report},
                       {"--cache", arguments.cache.folder},
                       {"--mask", arguments.mask_folder},
                       {"--fix", fix},
                       {"--fix", fix.empty() ? "" : fix + '/' + repairs_page}});
  if (!arguments.mask_folder.empty()) check_folder("--mask", arguments.mask_folder);
  if (arguments.fix_folder.empty()) return;
  refuse_inputs_below(arguments.fix_folder, arguments.paths);
  check_folder("--fix", arguments.fix_folder);
}

// Makes the repaired copies of --fix, with their page, and adds to the report what was repaired. Null where
// nothing was.
std::unique_ptr<Output> repaired_copies(const ValidateArguments& arguments, const Settings& settings,
                                        ValidationReport& report) {
  if (arguments.fix_folder.empty()) return nullptr;
  auto originals = refuse_inputs_below(arguments.fix_folder, checked_paths(report));
  auto copies = std::make_unique<OutputTree>(arguments.fix_folder, may_replace(arguments.output.force));
  copies->keep_off(std::move(originals));
  RepairPage page;
  RepairRequest request;
  request.settings = settings;
  request.door = picture_door();
  request.threads = thread_count(arguments.threads);
  request.folder = arguments.fix_folder;
  request.shown = [&](const RepairedFile& file, const Image8& before, const Image8& after) {
    page.add(file, before, after);
  };
  report.repairs = repair_files(report, request, *copies);
  if (report.repairs->files.empty()) return nullptr;
  copies->write(repairs_page, page.html(*report.repairs, ETAK_VERSION),
                strictest_mode(checked_paths(report)));
  return copies;
}

int list_found_files(ValidateArguments& arguments) {
  if (arguments.output.format != "text" && arguments.output.format != "json")
    refuse_form(arguments.output, "etak validate", "with --list-files", {"text", "json"});
  check_output(arguments.output);
  const FileList list = list_files(validation_request(arguments));
  write_output(arguments.output,
               arguments.output.format == "json" ? file_list_json(list) : file_list_text(list));
  return std::ranges::count(list.files, ListedAs::unreadable, &ListedFile::as) == 0 ? exit_ok : exit_failure;
}

}  // namespace

int check_files(ValidateArguments& arguments) {
  const auto start = Clock::now();
  if (arguments.paths.empty() && arguments.files_from.empty() && arguments.changed_since.empty())
    throw Error::at("etak validate", "nothing to check", "files, folders, --files-from or --changed-since");
  if (!arguments.today.empty() && !is_date(arguments.today))
    throw Error::at("--today", printable(arguments.today), "a date such as 2027-01-01");
  const auto least = severity_named(arguments.min_severity);
  if (!arguments.min_severity.empty() && (!least || *least == Severity::off))
    throw Error::at("--min-severity", printable(arguments.min_severity), "info, warning or error");
  if (arguments.list_files) return list_found_files(arguments);
  check_targets(arguments);
  // A look-up in a cache takes microseconds, of which memory that comes anew from the system is a good part.
  if (!arguments.cache.folder.empty()) sys::keep_freed_memory(32 << 20, 512 << 20);
  ValidationRequest request = validation_request(arguments);
  std::optional<Progress> progress(std::in_place, arguments.output, 0, "validate");
  request.run.progress = [&](std::size_t done, std::size_t all) { progress->set(done, all); };
  const Settings settings = request.config.settings;
  ValidationReport report = validate(std::move(request));
  progress.reset();
  if (report.shard)
    remark(arguments.output, "shard " + report.shard->shard.text() + ": " + grouped(report.files.size()) +
                                 " results of " + grouped(report.shard->groups) + " groups of files");
  tell_not_found(arguments, report);
  std::unique_ptr<Output> marks;
  arguments.output.read = checked_paths(report);
  if (!arguments.mask_folder.empty())
    marks = masks(report, settings, picture_door(), arguments.mask_folder, thread_count(arguments.threads));
  const std::unique_ptr<Output> copies = repaired_copies(arguments, settings, report);
  const std::unique_ptr<Output> use =
      report.cache ? cache_report(arguments.cache, *report.cache, may_replace(arguments.output.force))
                   : nullptr;
  const int status = finish_report(arguments, settings, verdict_options(arguments), report,
                                   {copies.get(), marks.get(), use.get()});
  if (report.cache) tell_cache(arguments.cache, *report.cache, arguments.output);
  if (arguments.stats) tell_stats(report, std::chrono::duration<double>(Clock::now() - start).count());
  if (!arguments.watch) keep_to_end(std::move(report));
  return status;
}

VerdictOptions verdict_options(const ValidateArguments& arguments) {
  return {arguments.settings.fail_on == never_fails, arguments.exit_zero, arguments.max_warnings,
          arguments.min_severity};
}

void tell_not_found(const ValidateArguments& arguments, const ValidationReport& report) {
  if (!report.not_opened.empty()) remark(arguments.output, skipped_remark(report.not_opened));
  if (report.nothing_checked)
    tell_nothing_checked(report);
  else
    tell_unknown(report, arguments);
  tell_not_checked(report, arguments);
  if (!report.nothing_checked && report.run.checks + report.run.failed == 0)
    remark(arguments.output, "no file of a kind that etak validate checks was found");
}

int finish_report(const ValidateArguments& arguments, const Settings& settings, const VerdictOptions& verdict,
                  ValidationReport& report, std::vector<Output*> beside) {
  std::unique_ptr<Output> baseline;
  if (!arguments.write_baseline.empty()) {
    const std::vector<KnownDefect> known = baseline_of(report);
    baseline = std::make_unique<OutputFile>(arguments.write_baseline, baseline_json(known),
                                            replaces_baseline(arguments.write_baseline));
    remark(arguments.output,
           arguments.write_baseline + ": " + std::to_string(known.size()) + " findings recorded");
  }
  if (verdict.max_warnings && report.warnings > *verdict.max_warnings) report.passed = false;
  // The HTML form shows the pictures.
  const unsigned most_mode =
      arguments.output.format == "html" ? strictest_mode(checked_paths(report)) | 0200 : 0777;
  const std::unique_ptr<Output> said =
      output(arguments.output, form_of(report, arguments, settings), most_mode);
  beside.push_back(baseline.get());
  beside.push_back(said.get());
  put_in_place(beside);
  if (report.incomplete) return exit_failure;
  return report.passed || verdict.exit_zero || verdict.never_fails ? exit_ok : exit_findings;
}

}  // namespace etak::cli
