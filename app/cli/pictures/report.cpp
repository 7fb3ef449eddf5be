// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pictures/report.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "app/cli/options/options.h"
#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "core/base/error.h"
#include "core/base/files/output_folder.h"
#include "core/base/files/output_target.h"
#include "core/base/files/paths.h"
#include "core/base/system.h"
#include "core/base/text/edit_distance.h"
#include "core/base/text/text.h"
#include "core/glsl/gl_runner.h"
#include "core/pages/error_time_report.h"
#include "core/pages/stability_report.h"

namespace etak::cli {
namespace {

// Few first rounds of short repeats are enough for most ways. What they leave open gets more, until it is
// settled: a quick report, which must be done within a minute on a busy machine as well, adds none after
// quick_until.
constexpr std::size_t quick_repeats = 15, full_repeats = 33;
constexpr double quick_seconds = 0.015, full_seconds = 0.6;         // for these repeats of a way
constexpr double quick_most_seconds = 0.5, full_most_seconds = 60;  // for those of a table
constexpr std::size_t quick_more_rounds = 100, full_more_rounds = 200;
constexpr auto quick_until = std::chrono::seconds(40);

std::vector<FamilyEntry> chosen_families(const std::vector<std::string>& names) {
  const auto all = all_families();
  if (names.empty()) return {all.begin(), all.end()};
  std::vector<FamilyEntry> out;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const FamilyEntry& each) { return each.id == name; });
    if (found == all.end()) {
      std::vector<std::string> ids;
      for (const FamilyEntry& each : all) ids.emplace_back(each.id);
      throw Error::at("--family", printable(name), joined(ids) + did_you_mean(name, ids));
    }
    out.push_back(*found);
  }
  return out;
}

// Checks before the work whether the report may replace the files of its folder. The names of the plots are
// known only after the measuring, so every file that has the name of a plot of these families counts as one.
void check_report_folder(const ReportArguments& arguments, const std::vector<FamilyEntry>& entries) {
  std::vector<std::string> names{"report.html", "report.json", "report.csv"};
  (void)walk_folder(arguments.folder, false, [&](const FolderEntry& entry) {
    const std::string name(entry.name);
    const auto is_plot = [&](const FamilyEntry& each) {
      return name.starts_with(std::string(each.id) + "-");
    };
    if ((name.ends_with(".svg") || name.ends_with(".csv")) &&
        std::any_of(entries.begin(), entries.end(), is_plot))
      names.push_back(name);
  });
  check_folder_target(arguments.folder, names, arguments.force ? Replace::anything : Replace::nothing);
}

// ", 3 of 40 verdicts not settled"; nothing where all are.
std::string unsettled_text(const std::vector<ErrorTimeFamily>& families) {
  std::size_t timed = 0, open = 0;
  for (const ErrorTimeFamily& family : families)
    for (const ErrorTimeTable& table : family.tables)
      for (const ErrorTimeRow& row : table.rows) {
        timed += row.verdict != Verdict::not_timed;
        open += row.verdict == Verdict::not_settled;
      }
  return open == 0 ? ""
                   : ", " + std::to_string(open) + " of " + std::to_string(timed) + " verdicts not settled";
}

GlRunner open_gl(const std::string& device) {
  std::string why;
  auto gl = GlRunner::open(why);
  if (!gl) throw Error::at("--device " + device, "no OpenGL here: " + why, "--device cpu");
  return std::move(*gl);
}

}  // namespace

int measure(ReportArguments& arguments) {
  arguments.force = may_replace(arguments.force);
  const std::vector<FamilyEntry> entries = chosen_families(arguments.families);
  check_report_folder(arguments, entries);
  ReportOptions options;
  options.full = arguments.full;
  TimingOptions timing;
  timing.repeats = options.full ? full_repeats : quick_repeats;
  timing.seconds_a_case = options.full ? full_seconds : quick_seconds;
  timing.most_seconds = options.full ? full_most_seconds : quick_most_seconds;
  timing.more_rounds = options.full ? full_more_rounds : quick_more_rounds;
  if (!options.full) timing.until = std::chrono::steady_clock::now() + quick_until;
  options.threads = thread_count(arguments.threads);
  options.gl = arguments.device == "gl" || arguments.device == "all";
  options.cpu = arguments.device != "gl";
  ReportHeader header = report_header(options);
  header.repeats = timing.repeats;
  GlEvaluate evaluate;
  std::optional<GlRunner> gl;
  if (options.gl) {
    gl.emplace(open_gl(arguments.device));
    header.gpu =
        gl->info().renderer + ", OpenGL " + gl->info().version + (gl->info().software ? " (software)" : "");
    evaluate = [&gl](std::string_view expression) { return double{gl->evaluate(expression)}; };
  }
  // The time of an empty case, which is the error of the clock.
  const TimedCase nothing[] = {{"nothing", 1, [] {}}};
  time_cases(nothing, timing, &header.empty_loop_ns);

  OutputArguments output;
  output.quiet = arguments.quiet;
  output.progress = arguments.progress;
  std::vector<ErrorTimeFamily> families;
  {
    // The errors of each family are measured first; then all are timed, which counts as much.
    const std::size_t steps = 2 * entries.size();
    Progress progress(output, steps, "report");
    for (const FamilyEntry& entry : entries) {
      if (!progress.draws_line()) remark(output, "measuring " + std::string(entry.id));
      progress.stage(entry.id);
      families.push_back(entry.measure(options));
      progress.set(families.size(), steps);
    }
    if (!progress.draws_line()) remark(output, "timing");
    progress.stage("times");
    timing.progress = [&](std::size_t begun, std::size_t all) {
      progress.set(entries.size() * (all + begun) / all, steps);
    };
    time_families(families, timing);
    for (ErrorTimeFamily& family : families) settle_picks(family);
  }
  const auto stability = stability_cases(evaluate);

  OutputFolder folder(arguments.folder, arguments.force ? Replace::anything : Replace::nothing);
  folder.write("report.html", error_time_page(header, families, stability_html(stability)));
  folder.write("report.json", error_time_json(header, families));
  folder.write("report.csv", error_time_csv(header, families));
  for (const ErrorTimeFamily& family : families)
    for (const ErrorTimeTable& table : family.tables)
      if (const std::string plot = error_time_svg_file(family, table); !plot.empty()) {
        folder.write(family.id + "-" + table.id + ".svg", plot);
        folder.write(family.id + "-" + table.id + ".csv", error_time_csv(family, table));
      }
  folder.commit();
  remark(output, "wrote " + arguments.folder + "/report.html" + unsettled_text(families));
  return exit_ok;
}

std::vector<StabilityCase> stability_on_gl(const std::string& device) {
  GlRunner gl = open_gl(device);
  return stability_cases([&gl](std::string_view expression) { return double{gl.evaluate(expression)}; });
}

}  // namespace etak::cli
