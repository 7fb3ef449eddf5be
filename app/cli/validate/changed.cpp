// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate/changed.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace etak::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* option = "--changed-since";

/// Runs git in a folder and returns what it prints. Its own messages go to standard error.
///   expected   what should have been given, for the message where git refuses
std::string git(const std::string& folder, std::vector<std::string> words, const std::string& given,
                const char* expected) {
  words.insert(words.begin(), {"git", "-C", folder});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw Error::at("git", "cannot be run: " + reason_of(errno));
  Descriptor from(ends[0]), to(ends[1]);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, to.get(), STDOUT_FILENO);
  pid_t process = 0;
  const int failure = ::posix_spawnp(&process, "git", &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw Error::at(option, "git cannot be run: " + reason_of(failure), "git in PATH");
  to = Descriptor();
  std::string out;
  std::array<char, 1 << 16> block{};
  for (;;) {
    const ssize_t got = ::read(from.get(), block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    out.append(block.data(), static_cast<std::size_t>(got));
  }
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Error::at(option, given, expected);
  return out;
}

/// Adds the names of a list that is separated by NUL bytes, each behind `folder`.
void add_names(std::string_view list, const fs::path& folder, std::vector<std::string>& out) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find('\0'), list.size());
    if (end > 0) out.push_back((folder / list.substr(0, end)).lexically_normal().string());
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
