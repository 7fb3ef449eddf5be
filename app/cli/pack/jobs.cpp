// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/jobs.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <thread>

#include "app/cli/output/progress.h"
#include "app/cli/pack/kept.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/system.h"

namespace etak::cli {
namespace {

namespace fs = std::filesystem;

constexpr auto watch_pause = std::chrono::milliseconds(300);

using Stamps = std::map<std::string, std::pair<fs::file_time_type, std::uintmax_t>>;

// Time and size of every file below the input, where it is a folder, else below its folder; files in the
// folder of the atlas are left out.
Stamps stamps(const std::string& input, const std::string& out) {
  Stamps found;
  std::error_code failure;
  const fs::path path(input);
  const fs::path folder = fs::is_directory(path, failure) ? path
                          : path.has_parent_path()        ? path.parent_path()
                                                          : ".";
  const fs::path skipped = fs::weakly_canonical(out, failure);
  for (fs::recursive_directory_iterator it(folder, failure), end; it != end && !failure;
       it.increment(failure)) {
    std::error_code gone;
    if (it->is_directory(gone) && fs::weakly_canonical(it->path(), gone) == skipped) {
      it.disable_recursion_pending();
      continue;
    }
    if (!it->is_regular_file(gone)) continue;
    const auto time = it->last_write_time(gone);
    const auto size = it->file_size(gone);
    if (!gone) found[sys::path_text(it->path())] = {time, size};
  }
  return found;
}

}  // namespace

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
  for (Stamps last;;) {
    const Stamps now = stamps(arguments.settings.input, arguments.settings.out);
    if (now != last) {
      last = now;
      try {
        with_cache(arguments, pack_once, again);
        again = true;
      } catch (const Error& error) {
        complain(error.what());  // the user may correct the input, so the watch goes on
      }
    }
    std::this_thread::sleep_for(watch_pause);
  }
}

}  // namespace etak::cli
