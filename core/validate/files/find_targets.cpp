// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/find_targets.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/input.h"
#include "core/base/system.h"
#include "core/base/text/ascii.h"
#include "core/exchange/data_folder.h"
#include "core/scene/gltf.h"
#include "core/validate/engine.h"
#include "core/validate/files/candidates.h"
#include "core/validate/files/file_hints.h"
#include "core/validate/files/files.h"
#include "core/validate/files/picture_sets.h"
#include "core/validate/names/names.h"
#include "core/validate/rules.h"
#include "core/validate/suppress.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

std::string_view folder_of(std::string_view path) {
  return path.substr(0, path.rfind('/') + 1);  // npos + 1 is 0
}

// Whether lexically_normal() would leave the path as it is. Most are, and to ask that takes far less time.
bool is_normal(std::string_view path) {
  return !path.starts_with('.') && path.find("//") == path.npos && path.find("/.") == path.npos &&
         path.find('\\') == path.npos;
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

constexpr const char* missing_fix = "Correct the path, or write the file first.";

class Finder {
 public:
  explicit Finder(ValidationRequest& request) : request_(request), reader_(request.config.names) {}

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
  std::string label(const std::string& path) const {
    // Input from a pipe lies in no folder and keeps its name.
    if (is_pipe_input(path)) return path;
    // Labels of one folder begin alike.
    const std::string_view folder = folder_of(path);
    if (labelled_ != folder || label_.empty()) {
      labelled_ = folder;
      label_ = relative_label(labelled_ + 'x', request_.config.root);
      if (label_.ends_with("/x") || label_ == "x")
        label_.pop_back();
      else
        return std::exchange(label_, {}), relative_label(path, request_.config.root);
    }
    return label_ + path.substr(folder.size());
  }

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
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (fs::is_directory(status)) return add_folder(path);
    remember_typed(folder_of(path));
    if (!fs::exists(status) && !is_pipe_input(path)) return fail(path, why_missing(path), missing_fix);
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
    for (FileCandidate& candidate : candidates_)
      if (!is_normal(candidate.path))
        candidate.path = sys::path_text(fs::path(candidate.path).lexically_normal());
    sort_where_needed(candidates_, [](const FileCandidate& a, const FileCandidate& b) {
      return std::tie(a.path, a.named) < std::tie(b.path, b.named);
    });
    candidates_.erase(
        std::unique(candidates_.begin(), candidates_.end(),
                    [](const FileCandidate& a, const FileCandidate& b) { return a.path == b.path; }),
        candidates_.end());
    out_.files = candidates_.size();
  }

  void classify() {
    const std::vector<KindOfFile> kinds = kinds_of(candidates_, request_.threads);
    std::vector<const FileCandidate*> pictures;
    std::size_t missing_reported = 0, missing_more = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const FileCandidate& candidate = candidates_[i];
      const auto& [kind, missing, failure] = kinds[i];
      std::error_code ignored;
      const bool link = missing && fs::is_symlink(fs::symlink_status(candidate.path, ignored));
      if (link && !kind && candidate.named != Named::by_hand && !candidate.path.ends_with(".json"))
        ++out_.skipped;
      else if (missing && candidate.named == Named::by_list && missing_reported == most_missing_reported)
        ++missing_more;
      else if (missing) {
        fail(candidate.path, why_missing(candidate.path), missing_fix);
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
    for (const FileCandidate* picture : pictures)
      if (!claimed_.contains(picture->path) && !claimed_.contains(level_0_of(picture->path)))
        add_picture(*picture);
      else if (request_.list_files)
        list_document(label(picture->path), "", ListedAs::judged, "with the scene or layout that names it");
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

  // The picture with what its name tells; nullopt where that is no role.
  std::optional<NamedPicture> named_picture(const std::string& path) const {
    const std::string_view folder = folder_of(path), name = std::string_view(path).substr(folder.size());
    NamedPicture out;
    out.path = path;
    if (!request_.config.roles.empty()) {
      const std::string relative = label(path);
      for (const RolePattern& pattern : request_.config.roles) {
        if (!glob_matches(pattern.pattern, relative)) continue;
        out.name.role = pattern.role;
        out.name.convention = Convention::own;
        out.name.set =
            pattern_stem(pattern.pattern.substr(folder_of(pattern.pattern).size()), std::string(name));
        out.key = lower_case(std::string(folder) + out.name.set);
        return out;
      }
    }
    auto parsed = reader_.read(name);
    if (!parsed) return std::nullopt;
    out.name = std::move(*parsed);
    out.guessed = out.name.convention != Convention::own;
    out.key = lower_case(std::string(folder) + out.name.set);
    // Each part begins with a line end, so that keys with and without it differ.
    if (!out.name.tile.empty()) out.key += '\n' + out.name.tile;
    if (!out.name.lod.empty()) out.key += '\n' + out.name.lod;
    return out;
  }

  void add_picture(const FileCandidate& candidate) {
    if (request_.role) {
      // With --role each picture is checked alone, because all of them have the same role.
      NamedPicture picture;
      picture.path = picture.key = candidate.path;
      picture.name.role = *request_.role;
      picture.by_hand = candidate.named == Named::by_hand;
      pictures_.push_back(std::move(picture));
      return;
    }
    auto picture = named_picture(candidate.path);
    if (!picture) return unknown_picture(candidate.path, candidate.named == Named::by_hand);
    picture->by_hand = candidate.named == Named::by_hand;
    pictures_.push_back(std::move(*picture));
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

  // Adds possible companions from the folders of the run's pictures. Each folder is listed once.
  void add_companions() {
    if (request_.role) return;
    std::unordered_set<std::string_view> have, keys, keys_of_maps;
    std::set<std::string_view> folders;
    have.reserve(pictures_.size());
    keys.reserve(pictures_.size());
    for (const NamedPicture& picture : pictures_) {
      have.insert(picture.path);
      keys.insert(picture.key);
      if (is_map(picture.name.role)) keys_of_maps.insert(picture.key);
      folders.insert(folder_of(picture.path));
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
        auto picture = named_picture(path);
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

  void group_pictures() {
    add_companions();
    std::sort(pictures_.begin(), pictures_.end(), [](const NamedPicture& a, const NamedPicture& b) {
      return std::tie(a.key, a.name.role, a.companion, a.path) <
             std::tie(b.key, b.name.role, b.companion, b.path);
    });
    for (std::size_t begin = 0, end = 0; begin < pictures_.size(); begin = end) {
      while (end < pictures_.size() && pictures_[end].key == pictures_[begin].key) ++end;
      const std::span<NamedPicture> same(pictures_.data() + begin, end - begin);
      for (PictureSet& set : sets_of(same)) {
        // A base colour that was named by --role is checked without its companions.
        if (request_.role == FileRole::base_color) set.missing.clear();
        // A set is judged only where at least one of its pictures belongs to the run.
        if (!std::ranges::all_of(set.members, &NamedPicture::companion)) add_set(set);
      }
      for (const NamedPicture& picture : same)
        if (picture.as == ListedAs::unknown) {
          if (!picture.companion) unknown_picture(picture.path, picture.by_hand, picture.note);
        } else {
          out_.skipped += picture.as == ListedAs::not_judged && !picture.companion;
          if (request_.list_files) list_picture(picture);
        }
    }
    settle_tiles();
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

  void add_set(const PictureSet& set) {
    FoundTarget found;
    found.target.manifest = request_.manifest;
    CheckTarget& target = found.target;
    for (auto [pictures, files] :
         {std::pair(&set.members, &target.files), std::pair(&set.beside, &target.beside)})
      for (const NamedPicture* member : *pictures) {
        files->push_back({member->name.role, member->path, label(member->path), member->guessed,
                          member->name.channels, member->name.green});
        found.depends.push_back(member->path);
      }
    target.label = target.files.front().label;
    if (!set.missing.empty()) return add_lone(target, set.missing);
    const ParsedName& name = set.members.front()->name;
    if (!name.tile.empty()) {
      target.tile = name.tile;
      target.udim = target.label;
      const std::size_t at = lower_case(target.label).rfind(name.tile);
      target.udim.replace(at, name.tile.size(), "<UDIM>");
    }
    out_.targets.push_back(std::move(found));
  }

  void add_lone(const CheckTarget& target, const std::string& missing) {
    const Rule& rule = *find_rule("ETK002");
    CheckedFile file = checked_file_of(target);
    if (const Severity severity = severity_of(rule, request_.config.settings); severity != Severity::off) {
      Finding& finding = file.findings.emplace_back(finding_of(rule, severity));
      finding.file = file.path;
      finding.value = missing;
      finding.limit = "the whole set";
      finding.message = missing + ": nothing of it was judged";
      finding.fix =
          "Add the missing picture under the name of its set, or say in [names] of etak.toml what "
          "the endings of the names mean; etak validate --list-files shows what was understood.";
    }
    out_.lone.push_back(std::move(file));
  }

  // A number alone, such as that of chair_1234_diff.png, makes no set of tiles.
  void settle_tiles() {
    std::unordered_map<std::string, std::size_t> tiles;
    for (const FoundTarget& found : out_.targets)
      if (!found.target.udim.empty()) ++tiles[found.target.udim];
    for (FoundTarget& found : out_.targets)
      if (!found.target.udim.empty() && tiles[found.target.udim] < 2) {
        found.target.udim.clear();
        found.target.tile.clear();
      }
  }

  ValidationRequest& request_;
  const NameReader reader_;
  std::vector<FileCandidate> candidates_;
  std::vector<NamedPicture> pictures_;
  std::unordered_set<std::string> claimed_, failed_;  // claimed: named by a scene or a layout
  std::unordered_set<std::string> of_manifests_;      // pictures that manifests of etak pack name
  std::string last_typed_;
  mutable std::string labelled_, label_;  // a folder, and how the labels of its files begin
  FoundTargets out_;
};

}  // namespace

FoundTargets find_targets(ValidationRequest& request) {
  return Finder(request).find();
}

}  // namespace etak
