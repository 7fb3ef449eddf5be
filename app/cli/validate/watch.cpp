// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate/validate.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/base/system.h"
#include "core/runs/watched_files.h"
#include "core/validate/files/result_text.h"

namespace etak::cli {
namespace {

void refuse_what_does_not_go(const ValidateArguments& a) {
  const auto refuse = [](const char* option, bool given, const char* why) {
    if (given) throw Error::at("--watch", std::string(option) + " beside it, " + why, "one of both");
  };
  refuse("--fix", !a.fix_folder.empty(), "which makes copies once");
  refuse("--write-baseline", !a.write_baseline.empty(), "which would record every new finding as known");
  refuse("--list-files", a.list_files, "which checks nothing");
  refuse("--list-rules", a.list_rules, "which checks nothing");
  refuse("--changed-since", !a.changed_since.empty(), "which compares once");
  std::vector<std::string> named = a.paths;
  if (!a.files_from.empty()) named.push_back(a.files_from);
  for (const std::string& path : named)
    if (is_pipe_input(path))
      throw Error::at("--watch", printable(path, 200) + " is a pipe, which never changes",
                      "files and folders");
}

// Adds the files that the next run would read, and leaves out those that this program writes itself.
void watch_inputs(const ValidateArguments& a, WatchedFiles& watched) {
  watched.clear();
  for (const std::string& path : a.paths) {
    if (is_folder(path))
      watched.add_folder(path, true);
    else
      watched.add_folder(sys::path_text(std::filesystem::path(path).parent_path()), false);
  }
  // The files of a list, and those that scenes and layouts name, may lie anywhere.
  for (const std::string& file : a.before->files()) watched.add_file(file);
  for (const std::string& file :
       {a.files_from, a.baseline, config_of(a.settings, a.paths.empty() ? "" : a.paths.front())})
    watched.add_file(file);
  for (const std::string& folder : a.library.all_folders()) watched.add_folder(folder, true);
  for (const std::string& own : {a.mask_folder, a.cache.folder, a.cache.report}) watched.leave_out(own);
  if (!is_standard_output(a.output)) watched.leave_out(a.output.file);
}

}  // namespace

int watch_files(ValidateArguments& a) {
  refuse_what_does_not_go(a);
  a.before = std::make_shared<CheckedBefore>();
  WatchedFiles watched;
  for (bool first = true;; first = false) {
    watch_inputs(a, watched);
    // A change while the files are checked is seen by the next call.
    watched.wait_for_change();
    a.library.forget();
    try {
      check_files(a);
      remark(a.output, "waiting for changes");
    } catch (const Error& error) {
      if (first) throw;
      complain(error.what());  // the user may correct the input, so the watch goes on
    }
    // The files that the first run was allowed to write are this program's own.
    a.output.force = true;
  }
}

}  // namespace etak::cli
