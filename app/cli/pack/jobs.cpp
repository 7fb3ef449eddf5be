// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/jobs.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/cli/output/progress.h"
#include "app/cli/pack/kept.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/watched_files.h"
#include "core/base/system.h"

namespace etak::cli {

namespace fs = std::filesystem;

int pack_batch(PackArguments& line) {
  if (!line.settings.input.empty() || !line.settings.out.empty())
    throw Error::at("--batch", "an input or -o beside it", "both in the jobs of the file");
  const std::vector<PackSettings> jobs = parse_pack_jobs(read_file(line.batch), line.batch, line.settings);
  std::map<std::string, std::size_t> outs;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto [same, fresh] = outs.try_emplace(sys::path_text(fs::path(jobs[i].out).lexically_normal()), i);
    if (!fresh)
      throw Error::at(line.batch + "#/jobs/" + std::to_string(i) + "/out",
                      jobs[i].out + " is that of job " + std::to_string(same->second) + " too",
                      "a folder for each job");
  }
  OutputArguments shown;
  shown.quiet = line.quiet;
  shown.progress = line.progress;
  Progress progress(shown, jobs.size(), "pack");
  int status = exit_ok;
  line.progress = "none";  // the line of all jobs is the only one
  for (const PackSettings& job : jobs) {
    line.settings = job;
    progress.stage(job.out);
    try {
      if (line.report == "text" && !line.quiet) write_output({}, line_text(job.out) + ":\n");
      status = std::max(status, pack_once(line));
    } catch (const Error& error) {
      complain(error.what());
      status = exit_failure;
    }
    progress.advance(1, 0);
  }
  return status;
}

int pack_watch(PackArguments& arguments) {
  if (is_pipe_input(arguments.settings.input))
    throw Error::at("--watch", arguments.settings.input + " is a pipe, which never changes",
                    "a file or a folder");
  // With -u, a file whose time changed but not its bytes costs a hash, and no atlas is packed.
  arguments.update = true;
  bool again = false;
  const fs::path input(arguments.settings.input);
  std::error_code failure;
  WatchedFiles watched;
  watched.add_folder(
      fs::is_directory(input, failure) ? arguments.settings.input : sys::path_text(input.parent_path()),
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
