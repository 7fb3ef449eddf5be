// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <span>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/base/parallel.h"
#include "core/base/system.h"
#include "core/base/text/ascii.h"
#include "core/judge/rules.h"
#include "core/judge/settings.h"
#include "core/validate/find/file_hints.h"
#include "core/validate/find/finds.h"
#include "core/validate/find/kind.h"
#include "core/validate/find/set_targets.h"

namespace etak {
namespace {

class PicturesFinder {
 public:
  PicturesFinder(const Searched& searched, const FilesOfPictures& files, Finds& finds)
      : searched_(searched), files_(files), finds_(finds) {}

  void run() {
    read_names();
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
    parallel_chunks(groups.size(), finds_.request.run.threads, 256,
                    [&](std::size_t begin, std::size_t end, unsigned) {
                      PictureNamer namer(finds_.request.config, finds_.reader);
                      for (std::size_t i = begin; i < end; ++i) find_sets(groups[i], namer);
                    });
    finds_.found.targets.reserve(finds_.found.targets.size() + groups.size());
    const std::unordered_map<std::string, std::string> unread = unread_names();
    for (Group& group : groups) {
      const auto names = unread.find(group.pictures.front().key);
      const std::string beside =
          names == unread.end() ? "" : " (" + names->second + " beside it is of a format that is not read)";
      for (auto& [found, missing] : group.sets)
        if (missing.empty())
          finds_.found.targets.push_back(std::move(found));
        else
          finds_.found.lone.push_back(
              lone_set(found.target, missing + beside, finds_.request.config.settings,
                       finds_.request.list_files ? nullptr : &finds_.request.run.door));
      for (const NamedPicture& picture : group.pictures)
        if (picture.as == ListedAs::unknown) {
          if (!picture.companion) unknown_picture(picture.path, picture.by_hand, picture.note);
        } else {
          finds_.found.skipped += picture.as == ListedAs::not_judged && !picture.companion;
          if (finds_.request.list_files) list_picture(picture);
        }
      if (std::ranges::any_of(group.pictures, [](const NamedPicture& p) { return p.as == ListedAs::judged; }))
        judged_keys_.insert(group.pictures.front().key.substr(0, group.pictures.front().key.find('\n')));
    }
    for (const std::string& path : unknown_) find_set_of(path);
    settle_tiles(finds_.found.targets);
  }

 private:
  // The names of pictures whose format is not read, by the key of their set.
  std::unordered_map<std::string, std::string> unread_names() {
    std::unordered_map<std::string, std::string> out;
    for (const FileCandidate* candidate : files_.unread)
      if (const auto picture = finds_.namer.named(candidate->path)) {
        std::string& names = out[picture->key];
        names += (names.empty() ? "" : ", ") + candidate->path.substr(folder_of(candidate->path).size());
      }
    return out;
  }

  // With --role each picture is checked alone, because all of them have the same role.
  NamedPicture picture_of_role(const std::string& path) const {
    NamedPicture out;
    out.path = out.key = path;
    out.name.role = *finds_.request.inputs.role;
    return out;
  }

  // Reads the names of pictures, by all threads.
  void read_names() {
    const std::vector<const FileCandidate*>& found = files_.pictures;
    pictures_.resize(found.size());
    std::vector<char> known(found.size(), 0);
    parallel_chunks(
        found.size(), finds_.request.run.threads, 256, [&](std::size_t begin, std::size_t end, unsigned) {
          PictureNamer namer(finds_.request.config, finds_.reader);
          for (std::size_t i = begin; i < end; ++i) {
            auto picture =
                finds_.request.inputs.role ? picture_of_role(found[i]->path) : namer.named(found[i]->path);
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
      return finds_.fail(path, pipe ? "a picture that comes without a name, which would tell its role" : why,
                         "Say what it is: --role " + std::string(picture_roles) +
                             (pipe ? "." : "; or give a pattern in [roles] of etak.toml."));
    }
    ++finds_.found.skipped;
    if (files_.of_manifests.contains(path))
      return finds_.list(finds_.label(path), "", ListedAs::not_judged,
                         "of a manifest: etak pack judges it while it packs");
    unknown_.push_back(path);
    finds_.found.unknown.push_back(finds_.label(path));
    finds_.list(finds_.found.unknown.back(), "", ListedAs::unknown, why);
  }

  // Reports a picture of unknown role whose name is that of a judged set with one or two more words behind it.
  void find_set_of(const std::string& path) {
    const std::size_t begin = folder_of(path).size();
    const std::string name = lower_case(path.substr(0, path.rfind('.')));
    std::size_t at = name.size();
    for (int words = 0; words < 2; ++words) {
      at = name.find_last_of(name_separators, at - 1);
      if (at == name.npos || at <= begin) return;
      if (judged_keys_.contains(name.substr(0, at)))
        return unknown_member(path, path.substr(begin, at - begin));
    }
  }

  void unknown_member(const std::string& path, const std::string& set) {
    const Settings& settings = finds_.request.config.settings;
    const Rule& rule = *find_rule("ETK012");
    const Severity severity = severity_of(rule, settings);
    if (severity == Severity::off) return;
    CheckedFile& file = finds_.found.lone.emplace_back();
    file.path = finds_.label(path);
    file.findings.push_back(finding_of(rule, severity, file.path,
                                       "named like the set " + in_quotes(set) +
                                           " beside it, and the word behind that is not known: not judged"));
  }

  // The folders of the run's pictures that may hold files that are no candidates. Of a folder that a search has
  // read all files are candidates already, except what it leaves out.
  std::set<std::string_view> folders_to_list() {
    std::set<std::string, std::less<>> not_all_seen = searched_.not_all_seen;
    for (const FileCandidate& candidate : searched_.files)
      if (!candidate.plain) not_all_seen.emplace(folder_of(candidate.path));
    std::set<std::string_view> out;
    if (not_all_seen.empty() && files_.claimed.empty()) return out;
    for (const NamedPicture& picture : pictures_) {
      const std::string_view folder = folder_of(picture.path);
      if (!files_.claimed.empty() || not_all_seen.contains(folder)) out.insert(folder);
    }
    return out;
  }

  // Adds possible companions from the folders of the run's pictures. Each folder is listed once.
  void add_companions() {
    if (finds_.request.inputs.role) return;
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
        if (have.contains(path) || files_.claimed.contains(path)) continue;
        auto picture = finds_.namer.named(path);
        if (!picture || !(is_judged(picture->name.role) ? keys : keys_of_maps).contains(picture->key) ||
            !(is_judged(picture->name.role) || is_map(picture->name.role)))
          continue;
        if (path.ends_with(".json") || (is_there(path) && !is_file(path))) continue;
        const auto kind = role_of_file(path);
        if (!kind || !is_picture(*kind)) continue;
        try {
          check_links(std::string(folder), path);
        } catch (const Error& error) {
          finds_.fail(path, error.what());
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
      if (finds_.request.inputs.role == FileRole::base_color) set.missing.clear();
      // A set is judged only where at least one of its pictures belongs to the run.
      if (!std::ranges::all_of(set.members, &NamedPicture::companion))
        group.sets.emplace_back(target_of_set(set, finds_.request.inputs.manifest, namer),
                                std::move(set.missing));
    }
  }

  void list_picture(const NamedPicture& picture) {
    ListedFile& row = finds_.found.listing.files.emplace_back();
    row.file = finds_.label(picture.path);
    row.role = name(picture.name.role);
    std::string_view folder = folder_of(row.file);
    if (picture.by_folder) folder = folder_of(folder.substr(0, folder.size() - 1));
    row.set = std::string(folder) + picture.name.set;
    row.parsed = picture.name;
    row.as = picture.as;
    row.note = picture.note;
  }

  const Searched& searched_;
  const FilesOfPictures& files_;
  Finds& finds_;
  std::vector<NamedPicture> pictures_;
  std::vector<std::string> unknown_;             // paths of pictures whose names tell no role
  std::unordered_set<std::string> judged_keys_;  // of NamedPicture, without tile and level
};

}  // namespace

void take_pictures(const Searched& searched, const FilesOfPictures& files, Finds& finds) {
  PicturesFinder(searched, files, finds).run();
}

}  // namespace etak
