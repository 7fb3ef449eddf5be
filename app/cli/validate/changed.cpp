// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate/changed.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <string_view>

#include "core/base/error.h"
#include "core/base/system.h"

namespace etak::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* option = "--changed-since";

/// Runs git in a folder and returns what it prints. Its own messages go to standard error.
///   expected   what should have been given, for the message where git refuses
std::string git(const std::string& folder, std::vector<std::string> words, const std::string& given,
                const char* expected) {
  words.insert(words.begin(), {"git", "-C", folder});
  std::string out;
  int status = 0;
  if (!sys::run_program(words, out, status))
    throw Error::at(option, "git cannot be run: " + reason_of(errno), "git in PATH");
  if (status != 0) throw Error::at(option, given, expected);
  return out;
}

/// Adds the names of a list that is separated by NUL bytes, each behind `folder`.
void add_names(std::string_view list, const fs::path& folder, std::vector<std::string>& out) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find('\0'), list.size());
    if (end > 0) out.push_back(sys::path_text((folder / list.substr(0, end)).lexically_normal()));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
}

}  // namespace

std::vector<std::string> changed_since(const std::string& commit, const std::vector<std::string>& paths) {
  std::vector<std::string> out;
  for (const std::string& path : paths.empty() ? std::vector<std::string>{"."} : paths) {
    std::error_code ignored;
    const bool is_folder = fs::is_directory(path, ignored);
    fs::path folder = is_folder ? fs::path(path) : fs::path(path).parent_path();
    if (folder.empty()) folder = ".";
    const std::string what = is_folder ? "." : fs::path(path).filename().string();
    // The hash, because a name could be taken for an option.
    std::string hash =
        git(folder.string(), {"rev-parse", "--verify", "--quiet", "--end-of-options", commit + "^{commit}"},
            in_quotes(commit) + " is no commit of the repository of " + printable(folder.string(), 200),
            "a branch, tag or hash");
    while (!hash.empty() && hash.back() == '\n') hash.pop_back();
    const auto names = [&](std::vector<std::string> words) {
      words.insert(words.end(), {"--", ":(literal)" + what});
      add_names(git(folder.string(), std::move(words), "git cannot compare with " + in_quotes(commit),
                    "a commit that HEAD shares history with"),
                folder, out);
    };
    names({"diff", "--name-only", "-z", "--relative", "--no-ext-diff", "--diff-filter=d", "--merge-base",
           hash});
    names({"ls-files", "-z", "--others", "--exclude-standard"});
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace etak::cli
