// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate/validate.h"

#include <algorithm>
#include <chrono>

#include "app/cli/inputs/folder.h"
#include "app/cli/inputs/inputs.h"
#include "app/cli/options/empty_list.h"
#include "app/cli/options/options.h"
#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "app/cli/pictures/pictures.h"
#include "app/cli/validate/cache.h"
#include "app/cli/validate/pictures.h"
#include "app/cli/validate/plan.h"
#include "app/cli/validate/targets.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/links.h"
#include "core/base/files/output_target.h"
#include "core/base/hash/sha256.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/pages/validation_page.h"
#include "core/validate/baseline.h"
#include "core/validate/files/files.h"
#include "core/validate/output/formats.h"
#include "core/validate/suppress.h"

namespace etak::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_pages_with_pictures = 200;

FoundTargets targets_of(const ValidateArguments& arguments, const ValidatePlan& plan) {
  TargetRequest request;
  request.paths = arguments.paths;
  request.list = arguments.files_from;
  if (!arguments.files_from.empty()) request.listed = ListedNames(arguments.files_from).take();
  if (request.paths.empty() && request.listed.empty() && !arguments.allow_empty)
    throw empty_list(arguments.files_from);
  request.patterns = plan.config.roles;
  request.manifest.material = arguments.material;
  request.manifest.surface_class = arguments.surface_class;
  request.root = plan.root;
  request.threads = thread_count(arguments.threads);
  if (!arguments.role.empty()) {
    request.role = role_named(arguments.role);
    if (!request.role) throw Error::at("--role", printable(arguments.role), picture_roles);
  }
  return find_targets(std::move(request));
}

// Checked files in the order of `found`, from the cache where it has them.
std::vector<CheckedFile> checked(const FoundTargets& found, const ValidateArguments& arguments,
                                 const Settings& settings, std::size_t& from_cache) {
  const unsigned threads = thread_count(arguments.threads);
  std::vector<CheckedFile> out(found.targets.size());
  std::vector<char> known(found.targets.size());
  std::vector<CacheKey> keys(found.targets.size());
  std::optional<ResultCache> cache;
  if (!arguments.cache_folder.empty()) {
    cache.emplace(arguments.cache_folder, settings_hash(settings) + (follows_links() ? " links" : ""),
                  arguments.cache_key.empty() ? "" : read_cache_key(arguments.cache_key));
    parallel_chunks(found.targets.size(), threads, 16, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) {
        keys[i] = cache->key_of(found.targets[i]);
        if (auto file = cache->find(keys[i])) {
          out[i] = std::move(*file);
          known[i] = 1;
        }
      }
    });
  }
  const PictureDecoder decoder = picture_decoder();
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (!known[i]) left.push_back(i);
  from_cache = known.size() - left.size();
  // Few targets share the threads inside of each; many are checked side by side.
  const std::size_t lanes = std::clamp<std::size_t>(left.size(), 1, threads);
  const unsigned inner = std::max(1u, threads / static_cast<unsigned>(lanes));
  Progress progress(arguments.output, left.size(), "validate");
  parallel_chunks(left.size(), static_cast<unsigned>(lanes), 1,
                  [&](std::size_t begin, std::size_t end, unsigned worker) {
                    for (std::size_t l = begin; l < end; ++l) {
                      const std::size_t i = left[l];
                      out[i] = check(found.targets[i].target, decoder, settings, inner);
                      if (cache) cache->keep(keys[i], found.targets[i], out[i]);
                    }
                    progress.advance(end - begin, worker);
                  });
  return out;
}

std::string form_of(const ValidationReport& report, const ValidateArguments& arguments,
                    const ValidatePlan& plan, const std::vector<const CheckTarget*>& targets) {
  const Settings& settings = plan.config.settings;
  const OutputOptions options{settings.fail_on, ETAK_VERSION};
  const std::string& format = arguments.output.format;
  if (format == "json") return validation_json(report, options);
  if (format == "sarif") return validation_sarif(report, options);
  if (format == "junit") return validation_junit(report, options);
  if (format == "github") return validation_github(report);
  if (format == "csv") return validation_csv(report);
  if (format != "html") return validation_text(report, use_color(arguments.output));
  const auto pictures =
      page_pictures(report, targets, settings, most_pages_with_pictures, thread_count(arguments.threads));
  return validation_page(report, pictures, {ETAK_VERSION, settings});
}

// The target behind each file of the report, null for others; labels and members tell them.
std::vector<const CheckTarget*> targets_behind(const ValidationReport& report, const FoundTargets& found) {
  std::vector<const CheckTarget*> out;
  for (const CheckedFile& file : report.files) {
    const auto same = std::lower_bound(
        found.targets.begin(), found.targets.end(), file.path,
        [](const FoundTarget& target, const std::string& path) { return target.target.label < path; });
    const bool is_it = same != found.targets.end() && same->target.label == file.path;
    out.push_back(is_it ? &same->target : nullptr);
  }
  return out;
}

void add_hashes(ValidationReport& report, const std::vector<const CheckTarget*>& targets, unsigned threads) {
  parallel_chunks(targets.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i)
      if (targets[i] != nullptr && !targets[i]->files.empty())
        report.files[i].sha256 = sha256_of_file(targets[i]->files.front().path);
  });
}

void tell_stats(const ValidationReport& report, const FoundTargets& found, std::size_t from_cache,
                double seconds) {
  CheckStats sum;
  for (const CheckedFile& file : report.files) {
    sum.pictures_decoded += file.stats.pictures_decoded;
    sum.pictures_left_out += file.stats.pictures_left_out;
    sum.texels += file.stats.texels;
    sum.decode_seconds += file.stats.decode_seconds;
    sum.byte_seconds += file.stats.byte_seconds;
    sum.region_seconds += file.stats.region_seconds;
  }
  complain("stats: " + grouped(found.files) + " files, " + grouped(found.skipped) + " skipped, " +
           grouped(found.targets.size()) + " checks, " + grouped(from_cache) + " from the cache");
  complain("stats: " + grouped(sum.pictures_decoded) + " pictures decoded, " +
           grouped(sum.pictures_left_out) + " left out because no rule needs them, " + grouped(sum.texels) +
           " texels");
  complain("stats: " + number(seconds, 3) + " s; summed over threads: decoding " +
           number(sum.decode_seconds, 3) + " s, byte rules " + number(sum.byte_seconds, 3) + " s, regions " +
           number(sum.region_seconds, 3) + " s");
}

}  // namespace

namespace {

// What is written at the end, looked at before the work. A baseline is renewed by every run that writes it.
void check_targets(const ValidateArguments& arguments) {
  check_output(arguments.output);
  if (!arguments.write_baseline.empty()) check_file_target(arguments.write_baseline, true);
  if (!arguments.mask_folder.empty()) check_mask_folder(arguments.mask_folder);
}

}  // namespace

int check_files(ValidateArguments& arguments) {
  const auto start = Clock::now();
  if (arguments.paths.empty() && arguments.files_from.empty())
    throw Error::at("etak validate", "nothing to check", "files, folders or --files-from");
  if (!arguments.today.empty() && !is_date(arguments.today))
    throw Error::at("--today", printable(arguments.today), "a date such as 2027-01-01");
  if (!arguments.cache_key.empty() && arguments.cache_folder.empty())
    throw Error::at("--cache-key", "no --cache", "--cache DIR with it");
  check_targets(arguments);
  auto known = asked_materials(arguments.library);
  const ValidatePlan plan = validate_plan(arguments, std::move(known));
  const Settings& settings = plan.config.settings;
  FoundTargets found = targets_of(arguments, plan);
  if (!found.no_files.empty()) remark(arguments.output, skipped_remark(found.no_files));
  std::size_t from_cache = 0;
  std::vector<CheckedFile> files = checked(found, arguments, settings, from_cache);
  std::move(found.failed.begin(), found.failed.end(), std::back_inserter(files));
  if (files.empty()) remark(arguments.output, "no file of a kind that etak validate checks was found");
  ValidationReport report = report_of(std::move(files), settings);
  const std::unique_ptr<Output> baseline = take_out_known(report, arguments, plan);
  report = report_of(std::move(report.files), settings);
  report.settings_hash = settings_hash(settings);
  if (arguments.max_warnings && report.warnings > *arguments.max_warnings) report.passed = false;
  const auto targets = targets_behind(report, found);
  // Only this form tells it, and reading all files once more takes its time.
  if (arguments.output.format == "json") add_hashes(report, targets, thread_count(arguments.threads));
  std::unique_ptr<Output> marks;
  if (!arguments.mask_folder.empty())
    marks = masks(report, targets, settings, arguments.mask_folder, thread_count(arguments.threads));
  const std::unique_ptr<Output> said = output(arguments.output, form_of(report, arguments, plan, targets));
  Output* const outputs[] = {marks.get(), baseline.get(), said.get()};
  put_in_place(outputs);
  if (arguments.stats)
    tell_stats(report, found, from_cache, std::chrono::duration<double>(Clock::now() - start).count());
  if (report.incomplete) return exit_failure;
  return report.passed || arguments.exit_zero || arguments.fail_on == never_fails ? exit_ok : exit_findings;
}

}  // namespace etak::cli
