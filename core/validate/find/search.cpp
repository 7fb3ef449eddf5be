// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <filesystem>
#include <map>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/between_files.h"
#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/base/system.h"
#include "core/exchange/data_folder.h"
#include "core/validate/find/file_hints.h"
#include "core/validate/find/finds.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

// Whether lexically_normal() would leave the path as it is. Most are, and to ask that takes far less time.
bool is_normal(std::string_view path) {
  return !path.starts_with('.') && path.find("//") == path.npos && path.find("/.") == path.npos &&
         path.find('\\') == path.npos;
}

void make_normal(std::string& path) {
  if (!is_normal(path)) path = sys::path_text(fs::path(path).lexically_normal());
}

class Search {
 public:
  explicit Search(Finds& finds) : finds_(finds) {}

  Searched run() {
    for (const std::string& path : finds_.request.inputs.paths) add_path(path);
    searched_.files.reserve(searched_.files.size() + finds_.request.inputs.listed.size());
    for (std::string& path : finds_.request.inputs.listed) {
      remember_typed(folder_of(path));
      searched_.files.push_back({std::move(path), Named::by_list, {}, false});
    }
    finds_.request.inputs.listed = {};
    const std::string& config = finds_.request.config.file;
    if (!config.empty()) finds_.found.typed.try_emplace(".", sys::path_text(fs::path(config).parent_path()));
    drop_doubles();
    return std::move(searched_);
  }

 private:
  void add_path(const std::string& path) {
    BetweenFiles::call();
    const auto kind = kind_at(path);
    if (kind == sys::FileInfo::Kind::folder) return add_folder(path);
    remember_typed(folder_of(path));
    if (!kind && !is_pipe_input(path)) return finds_.fail(path, why_missing(path), missing_fix(path));
    searched_.files.push_back(
        {path, finds_.request.inputs.pass_unknown ? Named::by_list : Named::by_hand, {}, false});
  }

  // Keeps a folder as the user typed it (ending in '/', or empty) by the name that labels have for it.
  void remember_typed(std::string_view folder) {
    if (folder == last_typed_ && !finds_.found.typed.empty()) return;
    last_typed_ = folder;
    const std::string text = sys::path_text((fs::path(folder).lexically_normal() / "").parent_path());
    finds_.found.typed.try_emplace(relative_label(text.empty() ? "." : text, finds_.request.config.root),
                                   text == "." ? "" : text);
  }

  void add_folder(const std::string& path) {
    remember_typed(path);
    Folder folder;
    try {
      folder = list_folder(path, finds_.request.run.threads, [](std::string_view) { return true; });
    } catch (const Error& error) {
      return finds_.fail(path, error.what());
    }
    for (const std::string& message : folder.unreadable) {
      const std::size_t reason = message.rfind(": cannot be read");
      finds_.fail(message.substr(0, reason),
                  "the folder" + message.substr(std::min(message.size(), reason + 1)));
    }
    std::move(folder.skipped.begin(), folder.skipped.end(), std::back_inserter(finds_.found.no_files));
    for (std::string& hiding : folder.hiding) {
      make_normal(hiding);
      searched_.not_all_seen.insert(std::move(hiding));
    }
    searched_.files.reserve(searched_.files.size() + folder.files.size());
    const std::string searched = sys::path_text(fs::path(path).lexically_normal());
    // A database of spectra is searched in a folder below, to which a link could lead.
    const bool searched_here = folder.root == path || folder.root == path + '/';
    for (std::string& file : folder.files) {
      const bool plain =
          searched_here && !std::binary_search(folder.linked.begin(), folder.linked.end(), file);
      searched_.files.push_back({std::move(file), Named::by_folder, searched, plain});
    }
  }

  // A file that was named twice is checked once; named by hand wins.
  void drop_doubles() {
    std::string normal;  // the last folder that was found to be normal
    for (FileCandidate& candidate : searched_.files) {
      const std::string_view folder = folder_of(candidate.path);
      const std::string_view name = std::string_view(candidate.path).substr(folder.size());
      if (folder == normal && !name.starts_with('.') && name.find('\\') == name.npos) continue;
      make_normal(candidate.path);
      normal = folder_of(candidate.path);
    }
    sort_where_needed(searched_.files, [](const FileCandidate& a, const FileCandidate& b) {
      return std::tie(a.path, a.named) < std::tie(b.path, b.named);
    });
    searched_.files.erase(
        std::unique(searched_.files.begin(), searched_.files.end(),
                    [](const FileCandidate& a, const FileCandidate& b) { return a.path == b.path; }),
        searched_.files.end());
    drop_other_spellings();
    finds_.found.files = searched_.files.size();
  }

  // A file that was named by two spellings, as "tex/a.png" and "../r/tex/a.png", is checked once as well. Names that
  // all begin in one way are looked at only where they lead upwards from more than one name of the line.
  void drop_other_spellings() {
    std::array<std::size_t, 3> begins{};  // relative, upwards, absolute
    const auto begin_of = [](const std::string& path) -> std::size_t {
      return path.starts_with("..") ? 1 : fs::path(path).is_absolute() ? 2 : 0;
    };
    for (const FileCandidate& each : searched_.files) ++begins[begin_of(each.path)];
    if (std::ranges::count(begins, 0U) >= 2 && (begins[1] == 0 || finds_.request.inputs.paths.size() < 2))
      return;
    std::map<fs::path, const FileCandidate*> whole;
    std::set<const FileCandidate*> dropped;
    for (const FileCandidate& each : searched_.files) {
      BetweenFiles::call();
      const auto [first, fresh] = whole.try_emplace(sys::absolute(each.path).lexically_normal(), &each);
      if (fresh) continue;
      const bool wins = each.named < first->second->named;
      dropped.insert(wins ? std::exchange(first->second, &each) : &each);
    }
    std::erase_if(searched_.files, [&](const FileCandidate& each) { return dropped.contains(&each); });
  }

  Finds& finds_;
  Searched searched_;
  std::string last_typed_;
};

}  // namespace

Searched search(Finds& finds) {
  return Search(finds).run();
}

}  // namespace etak
