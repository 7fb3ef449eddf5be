// SPDX-License-Identifier: Apache-2.0
#include "app/cli/validate/changed.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files/links.h"
#include "core/base/files/paths.h"
#include "core/base/hash/sha256.h"
#include "core/base/system.h"
#include "core/base/text/ascii.h"
#include "core/base/text/text.h"
#include "core/exchange/data_folder.h"
#include "core/image/picture_endings.h"

namespace etak::cli {
namespace {

namespace fs = std::filesystem;
using Kind = sys::FileInfo::Kind;
using Names = std::vector<std::string>;

constexpr const char* option = "--changed-since";

// Variables that lead git to another repository, index or configuration are left out, as are those that change
// what its arguments mean. Hooks set some of them; the working tree tells the same without them.
Names git_environment() {
  Names out = sys::environment();
  std::erase_if(out, [](const std::string& variable) {
    return variable.starts_with("GIT_") && !variable.starts_with("GIT_CEILING_DIRECTORIES=") &&
           !variable.starts_with("GIT_DISCOVERY_ACROSS_FILESYSTEM=");
  });
  // Objects that a partial clone lacks are not fetched: git before 2.39.4 knows the first variable alone.
  out.insert(out.end(), {"GIT_ALLOW_PROTOCOL=", "GIT_NO_LAZY_FETCH=1"});
  return out;
}

// git in a folder of a working tree. Its own messages go to standard error.
class Git {
 public:
  // Throws Error where git finds no working tree, or takes a folder of the tree for a repository: a commit may
  // bring a folder with all that git looks for, whose configuration would name programs.
  explicit Git(const fs::path& folder)
      : words_{"git",
               "-C",
               sys::path_text(folder),
               "--no-pager",
               "-c",
               "core.fsmonitor=",
               "-c",
               "core.hooksPath=/dev/null",
               "-c",
               "safe.bareRepository=explicit"} {
    const std::string shown = printable(words_[2], 200), expected = "a working tree of git";
    std::string found = output({"rev-parse", "--absolute-git-dir"},
                               shown + " lies in no repository that git accepts", expected);
    found.pop_back();
    const fs::path repository(found), here = sys::canonical(folder);
    if (std::ranges::mismatch(repository, here).in1 == repository.end())
      throw Error::at(option, shown + " lies in " + printable(found, 200) + ", which looks like a repository",
                      expected);
    // Filters are programs that turn a file into what git stores. The name of a setting ends at the first =.
    for (const std::string& name :
         parts_of(output({"config", "--null", "--name-only", "--get-regexp", "^filter\\."}), '\0')) {
      const std::string filter = name.substr(0, name.rfind('.'));
      if (filter.find('=') != filter.npos)
        throw Error::at(option, "git's configuration has " + in_quotes(filter),
                        "a filter without = in its name");
      if (filters_.insert(filter).second)
        for (const char* value : {".clean=", ".process=", ".required="})
          words_.insert(words_.end(), {"-c", filter + value});
    }
  }

  // The output of git. Throws Error where git refuses, unless there is no text for that.
  std::string output(const Names& arguments, const std::string& refused = {},
                     const std::string& expected = {}) const {
    Names words = words_;
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::string out;
    int status = 0;
    if (!sys::run_program(words, git_environment(), out, status))
      throw Error::at(option, "git cannot be run: " + reason_of(errno), "git in PATH");
    if (status != 0 && !refused.empty()) throw Error::at(option, refused, expected);
    return out;
  }

  // The parts of what git prints of these files and folders.
  Names list(Names words, std::span<const std::string> named, const std::string& refused,
             char separator = '\0') const {
    words.emplace_back("--");
    for (const std::string& name : named) words.push_back(":(literal)" + name);
    return parts_of(
        output(words, refused, "a commit that HEAD shares history with, in a clone that holds both"),
        separator);
  }

  bool has_filters() const { return !filters_.empty(); }

 private:
  Names words_;
  std::set<std::string> filters_;
};

// Takes away the files that are what Git LFS has stored for them, as the hashes in the index say. Without its
// filter, git takes every file that it has to read for a changed one.
void leave_out_stored(const Git& git, const fs::path& folder, Names& names) {
  constexpr std::size_t names_at_once = 256;
  std::set<std::string> stored;
  for (std::size_t i = 0; git.has_filters() && i < names.size(); i += names_at_once)
    for (const std::string& line :
         git.list({"grep", "--cached", "-zaG", "--no-color", "--no-textconv", "--no-column",
                   "--no-line-number", "--no-full-name", "--no-recurse-submodules", "-e", "^oid sha256:"},
                  std::span(names).subspan(i, std::min(names_at_once, names.size() - i)), {}, '\n')) {
      const Names parts = parts_of(line, '\0');
      const fs::path path = folder / parts.front();
      if (parts.size() == 2 && kind_at(sys::path_text(path), false) == Kind::file &&
          parts.back() == "oid sha256:" + sha256_of_file(sys::path_text(path)))
        stored.insert(parts.front());
    }
  std::erase_if(names, [&](const std::string& name) { return stored.contains(name); });
}

// Whether other files may need this one, as those of a set, of an atlas and of a scene do.
bool belongs_to_others(const std::string& name) {
  const std::string ending = path_ending(name);
  return ending == "json" || ending == "gltf" || ending == "bin" || has_picture_ending(name);
}

// Adds the files beside one that is gone: its other half may be among them.
void add_files_beside(const fs::path& gone, Changed& out) {
  const fs::path folder = gone.has_parent_path() ? gone.parent_path() : ".";
  (void)walk_folder(sys::path_text(folder), false, [&](const FolderEntry& each) {
    if (each.kind == Kind::file && !each.linked && !each.name.starts_with('.'))
      out.files.push_back(sys::path_text(fs::path(each.path).lexically_normal()));
  });
}

bool is_full_folder(const fs::path& path) {
  const std::string folder = sys::path_text(path);
  bool full = false;
  return kind_at(folder, false) == Kind::folder &&
         (walk_folder(folder, false, [&](const FolderEntry&) { full = true; }) || full);
}

void add_changes(const fs::path& folder, const Names& named, const std::string& commit, Changed& out) {
  const Git git(folder);
  const std::string shown = printable(sys::path_text(folder), 200);
  // The hash, because a name could be taken for an option.
  std::string hash =
      git.output({"rev-parse", "--verify", "--quiet", "--end-of-options", commit + "^{commit}"},
                 in_quotes(commit) + " is no commit of the repository of " + shown, "a branch, tag or hash");
  hash.pop_back();
  const std::string refused = "git cannot compare the files of " + shown;
  // The index beside the commit, then the files beside the index.
  Names names = git.list({"diff-index", "--cached", "--merge-base", "--name-only", "-z", "--relative",
                          "--no-renames", "--ignore-submodules=none", hash},
                         named, refused);
  Names unstaged =
      git.list({"ls-files", "-z", "--modified", "--others", "--exclude-standard"}, named, refused);
  leave_out_stored(git, folder, unstaged);
  names.insert(names.end(), unstaged.begin(), unstaged.end());
  std::set<std::string> submodules;
  for (const std::string& entry : git.list({"ls-files", "-z", "--stage"}, named, refused))
    if (entry.starts_with("160000 ")) submodules.insert(entry.substr(entry.find('\t') + 1));
  for (const std::string& name : names) {
    const fs::path path = (folder / name).lexically_normal();
    const auto kind = kind_at(sys::path_text(path), false);
    const bool changed_submodule = submodules.erase(name) > 0;
    if (is_full_folder(path)) {
      out.folders.push_back(sys::path_text(path));
    } else if (changed_submodule) {
      throw Error::at(sys::path_text(path), "a submodule that has changed, and is not checked out",
                      "its files (git submodule update --init)");
    } else if (kind && kind != Kind::folder) {
      const bool checked = belongs_to_others(name) || is_material_file_name(name);
      if (checked) (void)path_beside(sys::path_text(folder), name);
      out.files.push_back(sys::path_text(path));
    } else if (belongs_to_others(name)) {
      add_files_beside(path, out);
    }
  }
  // Adds what has changed in the submodules and is not committed there. A way through links leads to no submodule.
  for (const std::string& name : submodules) {
    const fs::path path = (folder / name).lexically_normal();
    if (!is_full_folder(path) || sys::canonical(path) != sys::canonical(folder) / name) continue;
    if (is_there(sys::path_text(path / ".git")))
      add_changes(path, {"."}, "HEAD", out);
    else
      out.folders.push_back(sys::path_text(path));
  }
}

}  // namespace

Changed changed_since(const std::string& commit, const std::vector<std::string>& paths) {
  std::map<std::string, Names> named;  // by the folder that git is asked in
  for (const std::string& path : paths.empty() ? Names{"."} : paths) {
    const bool folder_itself = is_folder(path);
    if (!kind_at(path, false))
      throw Error::at(option, printable(path, 200) + " does not exist",
                      "files and folders of a working tree");
    const std::string folder = folder_itself ? path : sys::path_text(fs::path(path).parent_path());
    named[folder.empty() ? "." : folder].push_back(folder_itself ? "."
                                                                 : sys::path_text(fs::path(path).filename()));
  }
  Changed out;
  for (const auto& [folder, names] : named) add_changes(folder, names, commit, out);
  for (Names* const list : {&out.files, &out.folders}) {
    std::ranges::sort(*list);
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return out;
}

}  // namespace etak::cli
