// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/find_targets.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/between_files.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/input.h"
#include "core/base/parallel.h"
#include "core/base/system.h"
#include "core/base/text/ascii.h"
#include "core/exchange/data_folder.h"
#include "core/judge/rules.h"
#include "core/scene/gltf.h"
#include "core/validate/files/candidates.h"
#include "core/validate/files/file_hints.h"
#include "core/validate/files/files.h"
#include "core/validate/files/picture_namer.h"
#include "core/validate/files/picture_sets.h"
#include "core/validate/files/set_targets.h"
#include "core/validate/names/names.h"

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

// Stable. Lists of files are mostly in order already, because folders were listed so.
template <class Value, class Less>
void sort_where_needed(std::vector<Value>& values, Less less) {
  if (!std::is_sorted(values.begin(), values.end(), less))
    std::stable_sort(values.begin(), values.end(), less);
}

// So many names of a list that lead to no file are reported one by one, and the others counted: a list of a
// million wrong names is one mistake.
constexpr std::size_t most_missing_reported = 1000;

// What helps where a path leads to nothing. Without -z git writes a name beyond ASCII in quotes.
const char* missing_fix(std::string_view path) {
  return path.starts_with('"') && path.ends_with('"')
             ? "Give the name without quotes; git writes it so with -z."
             : "Correct the path, or write the file first.";
}

class Finder {
 public:
  explicit Finder(ValidationRequest& request)
      : request_(request), reader_(request.config.names), namer_(request.config, reader_) {}

  FoundTargets find() {
    for (const std::string& path : request_.paths) add_path(path);
    candidates_.reserve(candidates_.size() + request_.listed.size());
    for (std::string& path : request_.listed) {
      remember_typed(folder_of(path));
      candidates_.push_back({std::move(path), Named::by_list, {}, false});
    }
    request_.listed = {};
    const ValidateConfig& config = request_.config;
    if (!config.file.empty())
      out_.typed.try_emplace(".", sys::path_text(fs::path(config.file).parent_path()));
    drop_doubles();
    classify();
    group_pictures();
    sort_where_needed(out_.targets, [](const FoundTarget& a, const FoundTarget& b) {
      return a.target.label < b.target.label;
    });
    std::ranges::sort(out_.unknown);
    std::ranges::stable_sort(out_.listing.files, {}, &ListedFile::file);
    return std::move(out_);
  }

 private:
  std::string label(const std::string& path) { return namer_.label(path); }

  void fail(const std::string& path, const std::string& message, const std::string& fix = {}) {
    // A file that fails here may be found again as a companion.
    if (!failed_.insert(path).second) return;
    const std::string text = label(path);
    CheckedFile file;
    file.path = text;
    file.unreadable = true;
    Finding& finding = file.findings.emplace_back(finding_of(rule_of_unreadable(message), Severity::error));
    finding.file = text;
    finding.message = message;
    if (!fix.empty()) finding.fix = fix;
    list_document(text, "", ListedAs::unreadable, message);
    out_.failed.push_back(std::move(file));
  }

  void add_path(const std::string& path) {
    BetweenFiles::call();
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (fs::is_directory(status)) return add_folder(path);
    remember_typed(folder_of(path));
    if (!fs::exists(status) && !is_pipe_input(path)) return fail(path, why_missing(path), missing_fix(path));
    candidates_.push_back({path, request_.pass_unknown ? Named::by_list : Named::by_hand, {}, false});
  }

  // Keeps a folder as the user typed it (ending in '/', or empty) by the name that labels have for it.
  void remember_typed(std::string_view folder) {
    if (folder == last_typed_ && !out_.typed.empty()) return;
    last_typed_ = folder;
    const std::string text = sys::path_text((fs::path(folder).lexically_normal() / "").parent_path());
    out_.typed.try_emplace(relative_label(text.empty() ? "." : text, request_.config.root),
                           text == "." ? "" : text);
  }

  void add_folder(const std::string& path) {
    remember_typed(path);
    Folder folder;
    try {
      folder = list_folder(path, request_.threads, [](std::string_view) { return true; });
    } catch (const Error& error) {
      return fail(path, error.what());
    }
    for (const std::string& message : folder.unreadable) {
      const std::size_t reason = message.rfind(": cannot be read");
      fail(message.substr(0, reason), "the folder" + message.substr(std::min(message.size(), reason + 1)));
    }
    std::move(folder.skipped.begin(), folder.skipped.end(), std::back_inserter(out_.no_files));
    for (std::string& hiding : folder.hiding) {
      make_normal(hiding);
      not_all_seen_.insert(std::move(hiding));
    }
    candidates_.reserve(candidates_.size() + folder.files.size());
    const std::string searched = sys::path_text(fs::path(path).lexically_normal());
    // A database of spectra is searched in a folder below, to which a link could lead.
    const bool searched_here = folder.root == path || folder.root == path + '/';
    for (std::string& file : folder.files) {
      const bool plain =
          searched_here && !std::binary_search(folder.linked.begin(), folder.linked.end(), file);
      candidates_.push_back({std::move(file), Named::by_folder, searched, plain});
    }
  }

  // A file that was named twice is checked once; named by hand wins.
  void drop_doubles() {
    std::string normal;  // the last folder that was found to be normal
    for (FileCandidate& candidate : candidates_) {
      const std::string_view folder = folder_of(candidate.path);
      const std::string_view name = std::string_view(candidate.path).substr(folder.size());
      if (folder == normal && !name.starts_with('.') && name.find('\\') == name.npos) continue;
      make_normal(candidate.path);
      normal = folder_of(candidate.path);
    }
    sort_where_needed(candidates_, [](const FileCandidate& a, const FileCandidate& b) {
      return std::tie(a.path, a.named) < std::tie(b.path, b.named);
    });
    candidates_.erase(
        std::unique(candidates_.begin(), candidates_.end(),
                    [](const FileCandidate& a, const FileCandidate& b) { return a.path == b.path; }),
        candidates_.end());
    drop_other_spellings();
    out_.files = candidates_.size();
  }

  // A file that was named by two spellings, as "tex/a.png" and "../r/tex/a.png", is checked once as well. Names that
  // all begin in one way are looked at only where they lead upwards from more than one name of the line.
  void drop_other_spellings() {
    std::array<std::size_t, 3> begins{};  // relative, upwards, absolute
    const auto begin_of = [](const std::string& path) -> std::size_t {
      return path.starts_with("..") ? 1 : fs::path(path).is_absolute() ? 2 : 0;
    };
    for (const FileCandidate& each : candidates_) ++begins[begin_of(each.path)];
    if (std::ranges::count(begins, 0U) >= 2 && (begins[1] == 0 || request_.paths.size() < 2)) return;
    std::error_code failure;
    std::map<fs::path, const FileCandidate*> whole;
    std::set<const FileCandidate*> dropped;
    for (const FileCandidate& each : candidates_) {
      BetweenFiles::call();
      const auto [first, fresh] =
          whole.try_emplace(fs::absolute(each.path, failure).lexically_normal(), &each);
      if (fresh) continue;
      const bool wins = each.named < first->second->named;
      dropped.insert(wins ? std::exchange(first->second, &each) : &each);
    }
    std::erase_if(candidates_, [&](const FileCandidate& each) { return dropped.contains(&each); });
  }

  void classify() {
    const std::vector<KindOfFile> kinds = kinds_of(candidates_, request_.threads);
    std::vector<const FileCandidate*> pictures;
    pictures.reserve(candidates_.size());
    std::size_t missing_reported = 0, missing_more = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      BetweenFiles::call();
      const FileCandidate& candidate = candidates_[i];
      const auto& [kind, missing, failure] = kinds[i];
      std::error_code ignored;
      const bool link = missing && fs::is_symlink(fs::symlink_status(candidate.path, ignored));
      if (link && !kind && candidate.named != Named::by_hand && !candidate.path.ends_with(".json"))
        ++out_.skipped;
      else if (missing && candidate.named == Named::by_list && missing_reported == most_missing_reported)
        ++missing_more;
      else if (missing) {
        fail(candidate.path, why_missing(candidate.path), missing_fix(candidate.path));
        ++missing_reported;
      } else if (!failure.empty())
        fail(candidate.path, failure);
      else if (!kind)
        skip(candidate,
             is_pipe_input(candidate.path) ? "holds nothing that etak validate checks"
                                           : "a kind of file that etak validate does not check",
             "Name a picture, atlas layout, glTF scene, material or spectrum.");
      else if (is_picture(*kind))
        pictures.push_back(&candidate);
      else
        add_document(candidate.path, *kind);
    }
    if (missing_more > 0)
      fail(request_.list, std::to_string(missing_more) + " more of its names lead to no file");
    if (!claimed_.empty())
      std::erase_if(pictures, [&](const FileCandidate* picture) {
        if (!claimed_.contains(picture->path) && !claimed_.contains(level_0_of(picture->path))) return false;
        if (request_.list_files)
          list_document(label(picture->path), "", ListedAs::judged, "with the scene or layout that names it");
        return true;
      });
    add_pictures(pictures);
  }

  void list_document(const std::string& file, std::string_view role, ListedAs as,
                     const std::string& note = {}) {
    if (!request_.list_files) return;
    ListedFile& row = out_.listing.files.emplace_back();
    row.file = file;
    row.role = role;
    row.as = as;
    row.note = note;
  }

  void skip(const FileCandidate& candidate, const std::string& why, const std::string& fix = {}) {
    if (candidate.named == Named::by_hand) return fail(candidate.path, why, fix);
    add_manifest_pictures(candidate.path, of_manifests_);
    ++out_.skipped;
    ++out_.listing.others;
  }

  void add_document(const std::string& path, FileRole role) {
    if (role == FileRole::layout) {
      try {
        std::vector<CheckTarget> pages = targets_of_layout(path, label(path));
        list_document(label(path), name(role), ListedAs::judged);
        for (CheckTarget& page : pages) {
          FoundTarget found{std::move(page), {path}};
          for (const TargetFile& file : found.target.files) {
            const std::string picture = sys::path_text(fs::path(file.path).lexically_normal());
            claimed_.insert(picture);
            found.depends.push_back(picture);
          }
          out_.targets.push_back(std::move(found));
        }
      } catch (const Error& error) {
        fail(path, error.what());
      }
      return;
    }
    FoundTarget found;
    found.target.label = label(path);
    list_document(found.target.label, name(role), ListedAs::judged);
    found.target.files = {{role, path, found.target.label, false}};
    found.depends = {path};
    if (role == FileRole::scene) {
      GltfFiles files = files_of_gltf(path);
      claimed_.insert(files.pictures.begin(), files.pictures.end());
      found.depends.insert(found.depends.end(), files.all.begin(), files.all.end());
    }
    out_.targets.push_back(std::move(found));
  }

  // With --role each picture is checked alone, because all of them have the same role.
  NamedPicture picture_of_role(const std::string& path) const {
    NamedPicture out;
    out.path = out.key = path;
    out.name.role = *request_.role;
    return out;
  }

  // Reads the names of pictures, by all threads.
  void add_pictures(const std::vector<const FileCandidate*>& found) {
    pictures_.resize(found.size());
    std::vector<char> known(found.size(), 0);
    parallel_chunks(found.size(), request_.threads, 256, [&](std::size_t begin, std::size_t end, unsigned) {
      PictureNamer namer(request_.config, reader_);
      for (std::size_t i = begin; i < end; ++i) {
        auto picture = request_.role ? picture_of_role(found[i]->path) : namer.named(found[i]->path);
        if (!picture) continue;
        picture->by_hand = found[i]->named == Named::by_hand;
        picture->plain = found[i]->plain;
        pictures_[i] = std::move(*picture);
        known[i] = 1;
      }
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (known[i] == 0)
        unknown_picture(found[i]->path, found[i]->named == Named::by_hand);
      else if (kept++ != i)
        pictures_[kept - 1] = std::move(pictures_[i]);
    pictures_.resize(kept);
  }

  // A picture whose name tells no role. Its texels tell none either: grey may be F0, roughness or a mask.
  void unknown_picture(const std::string& path, bool by_hand,
                       const std::string& why = "its name tells no role") {
    if (by_hand) {
      const bool pipe = is_pipe_input(path);
      return fail(path, pipe ? "a picture that comes without a name, which would tell its role" : why,
                  "Say what it is: --role " + std::string(picture_roles) +
                      (pipe ? "." : "; or give a pattern in [roles] of etak.toml."));
    }
    ++out_.skipped;
    if (of_manifests_.contains(path))
      return list_document(label(path), "", ListedAs::not_judged,
                           "of a manifest: etak pack judges it while it packs");
    out_.unknown.push_back(label(path));
    list_document(out_.unknown.back(), "", ListedAs::unknown, why);
  }

  // The folders of the run's pictures that may hold files that are no candidates. Of a folder that a search has
  // read all files are candidates already, except what it leaves out.
  std::set<std::string_view> folders_to_list() {
    for (const FileCandidate& candidate : candidates_)
      if (!candidate.plain) not_all_seen_.emplace(folder_of(candidate.path));
    std::set<std::string_view> out;
    if (not_all_seen_.empty() && claimed_.empty()) return out;
    for (const NamedPicture& picture : pictures_) {
      const std::string_view folder = folder_of(picture.path);
      if (!claimed_.empty() || not_all_seen_.contains(folder)) out.insert(folder);
    }
    return out;
  }

  // Adds possible companions from the folders of the run's pictures. Each folder is listed once.
  void add_companions() {
    if (request_.role) return;
    const std::set<std::string_view> folders = folders_to_list();
    if (folders.empty()) return;
    std::unordered_set<std::string_view> have, keys, keys_of_maps;
    have.reserve(pictures_.size());
    keys.reserve(pictures_.size());
    for (const NamedPicture& picture : pictures_) {
      have.insert(picture.path);
      keys.insert(picture.key);
      if (is_map(picture.name.role)) keys_of_maps.insert(picture.key);
    }
    std::vector<NamedPicture> companions;  // added at the end, because the sets refer to the pictures
    std::string path;
    for (const std::string_view folder : folders) {
      Descriptor opened(sys::open_file(folder.empty() ? "." : std::string(folder), sys::Open::folder));
      sys::FolderReader list(opened.get());
      if (!list) continue;
      (void)opened.release();
      for (sys::FolderReader::Entry entry; list.next(entry);) {
        path.assign(folder).append(entry.name);
        if (have.contains(path) || claimed_.contains(path)) continue;
        auto picture = namer_.named(path);
        if (!picture || !(is_judged(picture->name.role) ? keys : keys_of_maps).contains(picture->key) ||
            !(is_judged(picture->name.role) || is_map(picture->name.role)))
          continue;
        std::error_code gone;
        if (path.ends_with(".json") || (fs::exists(path, gone) && !fs::is_regular_file(path, gone))) continue;
        const auto kind = role_of_file(path);
        if (!kind || !is_picture(*kind)) continue;
        try {
          check_links(std::string(folder), path);
        } catch (const Error& error) {
          fail(path, error.what());
          continue;
        }
        picture->companion = true;
        companions.push_back(std::move(*picture));
      }
    }
    std::move(companions.begin(), companions.end(), std::back_inserter(pictures_));
  }

  // Pictures of one key, and what is to be judged of them.
  struct Group {
    std::span<NamedPicture> pictures;
    std::vector<std::pair<FoundTarget, std::string>> sets;  // with what is missing; empty: nothing
  };

  void find_sets(Group& group, PictureNamer& namer) const {
    std::vector<PictureSet> sets = sets_of(group.pictures);
    group.sets.reserve(sets.size());
    for (PictureSet& set : sets) {
      // A base colour that was named by --role is checked without its companions.
      if (request_.role == FileRole::base_color) set.missing.clear();
      // A set is judged only where at least one of its pictures belongs to the run.
      if (!std::ranges::all_of(set.members, &NamedPicture::companion))
        group.sets.emplace_back(target_of_set(set, request_.manifest, namer), std::move(set.missing));
    }
  }

  void group_pictures() {
    add_companions();
    sort_where_needed(pictures_, [](const NamedPicture& a, const NamedPicture& b) {
      return std::tie(a.key, a.name.role, a.companion, a.path) <
             std::tie(b.key, b.name.role, b.companion, b.path);
    });
    std::vector<Group> groups;
    groups.reserve(pictures_.size() / 2);
    for (std::size_t begin = 0, end = 0; begin < pictures_.size(); begin = end) {
      while (end < pictures_.size() && pictures_[end].key == pictures_[begin].key) ++end;
      groups.push_back({{pictures_.data() + begin, end - begin}, {}});
    }
    parallel_chunks(groups.size(), request_.threads, 256, [&](std::size_t begin, std::size_t end, unsigned) {
      PictureNamer namer(request_.config, reader_);
      for (std::size_t i = begin; i < end; ++i) find_sets(groups[i], namer);
    });
    out_.targets.reserve(out_.targets.size() + groups.size());
    for (Group& group : groups) {
      for (auto& [found, missing] : group.sets)
        if (missing.empty())
          out_.targets.push_back(std::move(found));
        else
          out_.lone.push_back(lone_set(found.target, missing, request_.config.settings));
      for (const NamedPicture& picture : group.pictures)
        if (picture.as == ListedAs::unknown) {
          if (!picture.companion) unknown_picture(picture.path, picture.by_hand, picture.note);
        } else {
          out_.skipped += picture.as == ListedAs::not_judged && !picture.companion;
          if (request_.list_files) list_picture(picture);
        }
    }
    settle_tiles(out_.targets);
  }

  void list_picture(const NamedPicture& picture) {
    ListedFile& row = out_.listing.files.emplace_back();
    row.file = label(picture.path);
    row.role = name(picture.name.role);
    row.set = std::string(folder_of(row.file)) + picture.name.set;
    row.parsed = picture.name;
    row.as = picture.as;
    row.note = picture.note;
  }

  ValidationRequest& request_;
  const NameReader reader_;
  PictureNamer namer_;
  std::vector<FileCandidate> candidates_;
  std::vector<NamedPicture> pictures_;
  std::unordered_set<std::string> claimed_, failed_;  // claimed: named by a scene or a layout
  std::unordered_set<std::string> of_manifests_;      // pictures that manifests of etak pack name
  std::set<std::string, std::less<>> not_all_seen_;   // folders that hold more than a search has told
  std::string last_typed_;
  FoundTargets out_;
};

}  // namespace

FoundTargets find_targets(ValidationRequest& request) {
  return Finder(request).find();
}

}  // namespace etak
