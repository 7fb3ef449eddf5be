// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/pack.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "app/cli/options/shard.h"
#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/output_file.h"
#include "core/base/files/output_target.h"
#include "core/base/files/paths.h"
#include "core/base/json/json_text.h"
#include "core/base/system.h"
#include "core/runs/watched_files.h"
#include "core/scene/gltf.h"

namespace etak::cli {

namespace fs = std::filesystem;

namespace {

std::vector<PackSettings> read_jobs(const PackArguments& line) {
  std::vector<std::string> remarks;
  const std::vector<PackSettings> jobs =
      parse_pack_jobs(read_file(line.batch), line.batch, line.settings, remarks);
  for (const std::string& each : remarks) remark(shown_as(line), each);
  std::map<std::string, std::size_t> outs;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto [same, fresh] = outs.try_emplace(sys::path_text(fs::path(jobs[i].out).lexically_normal()), i);
    if (!fresh)
      throw Error::at(line.batch + "#/jobs/" + std::to_string(i) + "/out",
                      jobs[i].out + " is that of job " + std::to_string(same->second) + " too",
                      "a folder for each job");
  }
  return jobs;
}

// The files that a job reads, as far as its input names them at once: the files of a folder, those of a scene,
// else the input alone.
std::vector<std::string> files_of(const std::string& input) {
  std::vector<std::string> files;
  if (is_folder(input)) {
    (void)walk_folder(input, true, [&](const FolderEntry& entry) {
      if (entry.kind == sys::FileInfo::Kind::file) files.push_back(entry.path);
    });
  } else {
    files.push_back(input);
    if (is_gltf_file(input)) {
      std::vector<std::string> named = files_of_gltf(input).all;
      files.insert(files.end(), named.begin(), named.end());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::uint64_t> bytes_of(const std::vector<PackSettings>& jobs) {
  std::vector<std::uint64_t> out;
  for (const PackSettings& job : jobs) {
    std::uint64_t& bytes = out.emplace_back();
    sys::FileInfo info;
    for (const std::string& file : files_of(job.input))
      if (sys::file_info(file, info) && info.kind == sys::FileInfo::Kind::file) bytes += info.size;
  }
  return out;
}

// A job in the report of all. The report of its atlas is moved in by six blanks, to stand below it.
std::string job_json(const PackSettings& job, int status, const std::string& failure,
                     const std::string& report) {
  std::string moved;
  for (const char c : report) {
    moved += c;
    if (c == '\n') moved += "      ";
  }
  while (!moved.empty() && (moved.back() == ' ' || moved.back() == '\n')) moved.pop_back();
  return json_object({{"input", json(job.input)},
                      {"out", json(job.out)},
                      {"status", json(static_cast<std::size_t>(status))},
                      {"failure", failure.empty() ? "null" : json(failure)},
                      {"report", moved.empty() ? "null" : moved}},
                     4);
}

}  // namespace

void check_can_be_cut(const PackArguments& a, const std::vector<GivenOption>& line) {
  if (a.batch.empty() || a.rects.asked)
    throw Error::at("etak pack", "no --batch to cut into shards", "--batch FILE");
  check_can_be_cut(line);
}

int pack_batch(PackArguments& line) {
  if (!line.settings.input.empty() || !line.settings.out.empty())
    throw Error::at("--batch", "an input or -o beside it", "both in the jobs of the file");
  const std::vector<PackSettings> jobs = read_jobs(line);
  if (!line.batch_report.empty()) check_file_target(line.batch_report, true);
  refuse_input(line.batch_report);
  const OutputArguments shown = shown_as(line);
  const auto shard = asked_shard(line.shard);
  const auto [first, last] =
      shard ? items_of(*shard, bytes_of(jobs)) : std::pair(std::size_t{0}, jobs.size());
  if (shard)
    remark(shown, "shard " + shard->text() + ": " + std::to_string(last - first) + " of " +
                      std::to_string(jobs.size()) + " jobs");
  Progress progress(shown, last - first, "pack");
  int status = exit_ok;
  line.progress = "none";  // the line of all jobs is the only one
  std::vector<std::string> reports;
  for (std::size_t i = first; i < last; ++i) {
    const PackSettings& job = jobs[i];
    line.settings = job;
    line.told.clear();
    progress.stage(job.out);
    int own = exit_failure;
    std::string failure;
    try {
      if (line.report == "text" && !line.quiet) write_output({}, line_text(job.out) + ":\n");
      own = pack_once(line);
    } catch (const Error& error) {
      failure = error.what();
      complain(failure);
    }
    status = std::max(status, own);
    if (!line.batch_report.empty()) reports.push_back(job_json(job, own, failure, line.told));
    progress.advance(1, 0);
  }
  if (line.batch_report.empty()) return status;
  const std::string report =
      json_document("etak-pack-batch/1", {{"version", json(ETAK_VERSION)}, {"jobs", json_lines(reports, 2)}});
  OutputFile(line.batch_report, report, true).commit();
  return status;
}

std::vector<ShardPlan> plan_batch(const PackArguments& line, std::size_t count) {
  const std::vector<PackSettings> jobs = read_jobs(line);
  const std::vector<std::uint64_t> bytes = bytes_of(jobs);
  std::vector<ShardPlan> out;
  for (std::size_t i = 1; i <= count; ++i) {
    ShardPlan& plan = out.emplace_back();
    plan.shard = {i, count, items_of({i, count, {}}, bytes)};
    std::set<std::string> files;
    for (std::size_t j = plan.shard.items->first; j < plan.shard.items->second; ++j)
      for (std::string& file : files_of(jobs[j].input)) files.insert(std::move(file));
    plan.files.assign(files.begin(), files.end());
  }
  return out;
}

int pack_watch(PackArguments& arguments) {
  if (is_pipe_input(arguments.settings.input))
    throw Error::at("--watch", arguments.settings.input + " is a pipe, which never changes",
                    "a file or a folder");
  // With -u, a file whose time changed but not its bytes costs a hash, and no atlas is packed.
  arguments.update = true;
  bool again = false;
  const fs::path input(arguments.settings.input);
  WatchedFiles watched;
  watched.add_folder(
      is_folder(arguments.settings.input) ? arguments.settings.input : sys::path_text(input.parent_path()),
      true);
  watched.leave_out(arguments.settings.out);
  watched.leave_out(arguments.cache.folder);
  for (;;) {
    watched.wait_for_change();
    try {
      with_cache(arguments, pack_once, again);
      again = true;
    } catch (const Error& error) {
      complain(error.what());  // the user may correct the input, so the watch goes on
    }
  }
}

}  // namespace etak::cli
