// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/find_targets.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "core/base/ascii.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/files/links.h"
#include "core/base/parallel.h"
#include "core/exchange/data_folder.h"
#include "core/scene/gltf.h"
#include "core/validate/files/files.h"
#include "core/validate/rules.h"
#include "core/validate/suppress.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

std::string_view folder_of(std::string_view path) {
  const auto slash = path.rfind('/');
  return slash == path.npos ? std::string_view() : path.substr(0, slash + 1);
}

bool is_picture(FileRole role) {
  return role != FileRole::layout && role != FileRole::scene && role != FileRole::material &&
         role != FileRole::spectrum;
}

// A list of a million names that lead nowhere is one mistake: so many of them are told one by one, the others
// are counted.
constexpr std::size_t most_missing_reported = 1000;

// Why nothing stands at `path`.
std::string why_missing(const std::string& path) {
  std::error_code failure;
  (void)fs::status(path, failure);
  if (failure && failure != std::errc::no_such_file_or_directory)
    return "cannot be read: " + failure.message();
  if (fs::is_symlink(fs::symlink_status(path, failure))) return "a link that leads to no file";
  return "there is no such file";
}

// Where a file came from decides what happens when nothing can be said of it.
enum class Named { by_hand, by_folder, by_list, as_companion };

struct Candidate {
  std::string path;
  Named named = Named::by_hand;
  std::string searched;  // the folder whose search found it; else empty
};

// A picture with the role its name gives, and the name without that.
struct NamedPicture {
  std::string path, stem;  // stem: folder and the name before the role, in lower case
  FileRole role = FileRole::specular_gloss;
  bool guessed = false, companion = false;
  Named named = Named::by_hand;
};

// What a pattern leaves of a file name: "crate" for "*_spec.*" and "crate_spec.png"; for other forms the
// whole name.
std::string stem_of(const std::string& pattern, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::string bare = name.substr(0, dot);
  if (!pattern.starts_with('*')) return bare;
  std::string ending =
      pattern.substr(1, pattern.rfind('.') == std::string::npos ? pattern.npos : pattern.rfind('.') - 1);
  if (ending.empty() || ending.find_first_of("*?/") != ending.npos || !bare.ends_with(ending)) return bare;
  return bare.substr(0, bare.size() - ending.size());
}

// "atlas/page0.mip3.png" is a level of "atlas/page0.png", as etak pack names them; "" for other names.
std::string level_0_of(const std::string& path) {
  const fs::path whole(path);
  const std::string stem = whole.stem().string();
  const std::size_t mip = stem.rfind(".mip");
  if (mip == std::string::npos || mip + 4 == stem.size() ||
      stem.find_first_not_of("0123456789", mip + 4) != std::string::npos)
    return {};
  return (whole.parent_path() / (stem.substr(0, mip) + whole.extension().string())).string();
}

// Tables and YAML files of a project are rarely spectra: one found in a folder is taken for that only when it
// says so, by a refractiveindex.info page's "DATA:" or a header line that begins with a wavelength.
bool looks_like_spectrum(const std::string& path) {
  const std::string head = read_head(path, 4096);
  if (!path.ends_with(".csv")) return head.find("DATA:") != head.npos;
  std::size_t begin = 0;
  while (begin < head.size() && head[begin] == '#')
    begin = std::min(head.find('\n', begin), head.size() - 1) + 1;
  const std::string line = lower_case(head.substr(begin, head.find('\n', begin) - begin));
  for (const char* name : {"wavelength", "lambda", "wl", "nm", "um", "\"wavelength"})
    if (line.starts_with(name)) return true;
  return false;
}

// Throws Error where a link leads from `folder` out to `path`, which was found there and which nobody named.
void check_links(const std::string& folder, const std::string& path) {
  (void)path_beside(folder, fs::path(path).lexically_relative(folder.empty() ? "." : folder).string());
}

class Finder {
 public:
  explicit Finder(ValidationRequest& request) : request_(request) {}

  FoundTargets find() {
    for (const std::string& path : request_.paths) add_path(path);
    candidates_.reserve(candidates_.size() + request_.listed.size());
    for (std::string& path : request_.listed) candidates_.push_back({std::move(path), Named::by_list, {}});
    request_.listed = {};
    drop_doubles();
    classify();
    group_pictures();
    std::stable_sort(
        out_.targets.begin(), out_.targets.end(),
        [](const FoundTarget& a, const FoundTarget& b) { return a.target.label < b.target.label; });
    return std::move(out_);
  }

 private:
  std::string label(const std::string& path) const {
    // What has no place in a folder keeps its name.
    return is_pipe_input(path) ? path : relative_label(path, request_.config.root);
  }

  void fail(const std::string& path, const std::string& message, const std::string& fix = {}) {
    // What a search has found may be come by again as a companion.
    if (!failed_.insert(path).second) return;
    const std::string text = label(path);
    CheckedFile file;
    file.path = text;
    file.unreadable = true;
    Finding& finding = file.findings.emplace_back(finding_of(*find_rule("ETK001"), Severity::error));
    finding.file = text;
    finding.message = message;
    if (!fix.empty()) finding.fix = fix;
    out_.failed.push_back(std::move(file));
  }

  void add_path(const std::string& path) {
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (fs::is_directory(status)) return add_folder(path);
    if (!fs::exists(status) && !is_pipe_input(path)) return fail(path, why_missing(path));
    candidates_.push_back({path, Named::by_hand, {}});
  }

  void add_folder(const std::string& path) {
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
    for (std::string& file : folder.files)
      candidates_.push_back({std::move(file), Named::by_folder, fs::path(path).lexically_normal().string()});
  }

  // A file that was named twice is checked once; named by hand wins.
  void drop_doubles() {
    for (Candidate& candidate : candidates_)
      candidate.path = fs::path(candidate.path).lexically_normal().string();
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.path, a.named) < std::tie(b.path, b.named);
    });
    candidates_.erase(std::unique(candidates_.begin(), candidates_.end(),
                                  [](const Candidate& a, const Candidate& b) { return a.path == b.path; }),
                      candidates_.end());
    out_.files = candidates_.size();
  }

  void classify() {
    // Telling kinds opens .json files, so it is done on all threads.
    std::vector<std::optional<FileRole>> kinds(candidates_.size());
    std::vector<char> missing(candidates_.size());
    std::vector<std::string> failures(candidates_.size());
    parallel_chunks(candidates_.size(), request_.threads, 64,
                    [&](std::size_t begin, std::size_t end, unsigned) {
                      for (std::size_t i = begin; i < end; ++i) {
                        std::error_code ignored;
                        const Candidate& candidate = candidates_[i];
                        missing[i] = !fs::exists(candidate.path, ignored) && !is_pipe_input(candidate.path);
                        try {
                          kinds[i] = role_of_file(candidate.path);
                          if (kinds[i] == FileRole::spectrum && candidate.named != Named::by_hand &&
                              !looks_like_spectrum(candidate.path))
                            kinds[i].reset();
                          if (kinds[i] && !candidate.searched.empty())
                            check_links(candidate.searched, candidate.path);
                        } catch (const Error& error) {
                          if (!missing[i]) failures[i] = error.what();
                        }
                      }
                    });
    std::vector<const Candidate*> pictures;
    std::size_t missing_reported = 0, missing_more = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const Candidate& candidate = candidates_[i];
      std::error_code ignored;
      const bool link = missing[i] && fs::is_symlink(fs::symlink_status(candidate.path, ignored));
      if (link && !kinds[i] && candidate.named != Named::by_hand && !candidate.path.ends_with(".json"))
        ++out_.skipped;
      else if (missing[i] && candidate.named == Named::by_list && missing_reported == most_missing_reported)
        ++missing_more;
      else if (missing[i]) {
        fail(candidate.path, why_missing(candidate.path));
        ++missing_reported;
      } else if (!failures[i].empty())
        fail(candidate.path, failures[i]);
      else if (!kinds[i])
        skip(candidate,
             is_pipe_input(candidate.path) ? "holds nothing that etak validate checks"
                                           : "a kind of file that etak validate does not check",
             "Name a picture, atlas layout, glTF scene, material or spectrum.");
      else if (is_picture(*kinds[i]))
        pictures.push_back(&candidate);
      else
        add_document(candidate.path, *kinds[i]);
    }
    if (missing_more > 0)
      fail(request_.list, std::to_string(missing_more) + " more of its names lead to no file");
    for (const Candidate* picture : pictures)
      if (!claimed_.contains(picture->path) && !claimed_.contains(level_0_of(picture->path)))
        add_picture(*picture);
  }

  void skip(const Candidate& candidate, const std::string& why, const std::string& fix = {}) {
    if (candidate.named == Named::by_hand) return fail(candidate.path, why, fix);
    ++out_.skipped;
  }

  void add_document(const std::string& path, FileRole role) {
    if (role == FileRole::layout) {
      try {
        for (CheckTarget& page : targets_of_layout(path, label(path))) {
          FoundTarget found{std::move(page), {path}};
          for (const TargetFile& file : found.target.files) {
            const std::string picture = fs::path(file.path).lexically_normal().string();
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
    found.target.files = {{role, path, label(path), false}};
    found.depends = {path};
    if (role == FileRole::scene) {
      GltfFiles files = files_of_gltf(path);
      claimed_.insert(files.pictures.begin(), files.pictures.end());
      found.depends.insert(found.depends.end(), files.all.begin(), files.all.end());
    }
    out_.targets.push_back(std::move(found));
  }

  // The role of a picture by its name; none when no pattern matches.
  std::optional<NamedPicture> named_picture(const std::string& path) const {
    const std::string relative = label(path), name = relative.substr(folder_of(relative).size());
    NamedPicture out{path,
                     lower_case(path.substr(0, folder_of(path).size())),
                     FileRole::specular_gloss,
                     false,
                     false,
                     Named::as_companion};
    for (const RolePattern& pattern : request_.config.roles)
      if (glob_matches(pattern.pattern, relative)) {
        out.role = pattern.role;
        out.stem += lower_case(stem_of(pattern.pattern.substr(folder_of(pattern.pattern).size()), name));
        return out;
      }
    const std::string small = lower_case(name);
    for (const RolePattern& pattern : default_roles())
      if (glob_matches(pattern.pattern, small)) {
        out.role = pattern.role;
        out.guessed = true;
        out.stem += stem_of(pattern.pattern, small);
        return out;
      }
    return std::nullopt;
  }

  void add_picture(const Candidate& candidate) {
    if (request_.role) {
      // Each stands for itself: --role names what it is, and its companion would have another role.
      pictures_.push_back({candidate.path, candidate.path, *request_.role, false, false, candidate.named});
      return;
    }
    auto picture = named_picture(candidate.path);
    if (!picture) {
      // Texels do not tell a role either: grey may be F0, metallic, roughness or a mask.
      const bool pipe = is_pipe_input(candidate.path);
      return skip(
          candidate,
          pipe ? "a picture that comes without a name, which would tell its role" : "its name tells no role",
          "Say what it is: --role " + std::string(picture_roles) +
              (pipe ? "." : "; or give a pattern in [roles] of etak.toml."));
    }
    picture->named = candidate.named;
    pictures_.push_back(std::move(*picture));
  }

  // The pictures beside those of the run that have a role, for companions: each folder is listed once.
  void add_companions() {
    if (request_.role) return;
    std::unordered_set<std::string> have, stems;
    std::set<std::string> folders;
    for (const NamedPicture& picture : pictures_) {
      have.insert(picture.path);
      stems.insert(picture.stem);
      folders.insert(std::string(folder_of(picture.path)));
    }
    for (const std::string& folder : folders) {
      std::error_code failure;
      for (fs::directory_iterator at(folder.empty() ? "." : folder, failure), end; !failure && at != end;
           at.increment(failure)) {
        const std::string path = folder + at->path().filename().string();
        if (have.contains(path) || claimed_.contains(path)) continue;
        auto picture = named_picture(path);
        if (!picture || !stems.contains(picture->stem)) continue;
        std::error_code gone;
        if (path.ends_with(".json") || (at->exists(gone) && !at->is_regular_file(gone))) continue;
        const auto kind = role_of_file(path);
        if (!kind || !is_picture(*kind)) continue;
        try {
          check_links(folder, path);
        } catch (const Error& error) {
          fail(path, error.what());
          continue;
        }
        picture->companion = true;
        pictures_.push_back(std::move(*picture));
      }
    }
  }

  void group_pictures() {
    add_companions();
    std::sort(pictures_.begin(), pictures_.end(), [](const NamedPicture& a, const NamedPicture& b) {
      return std::tie(a.stem, a.role, a.companion, a.path) < std::tie(b.stem, b.role, b.companion, b.path);
    });
    for (std::size_t begin = 0, end = 0; begin < pictures_.size(); begin = end) {
      while (end < pictures_.size() && pictures_[end].stem == pictures_[begin].stem) ++end;
      group({pictures_.data() + begin, end - begin});
    }
  }

  // Pictures of one stem: the first of each role form the pair or set, others stand alone.
  void group(std::span<NamedPicture> same) {
    const auto has = [&](FileRole role) {
      return std::ranges::any_of(same, [&](const NamedPicture& picture) { return picture.role == role; });
    };
    // Beside metallic or roughness, and without F0, "diffuse" is another word for the base colour.
    const bool parts = has(FileRole::metallic) || has(FileRole::roughness);
    const bool metal_rough = parts || has(FileRole::metal_rough);
    if (metal_rough && !has(FileRole::specular_gloss) && !has(FileRole::base_color))
      for (NamedPicture& picture : same)
        if (picture.role == FileRole::diffuse_alpha) picture.role = FileRole::base_color;
    std::vector<char> used(same.size());
    // They say nothing on their own.
    if (parts && !has(FileRole::base_color))
      for (std::size_t i = 0; i < same.size(); ++i)
        if (same[i].role == FileRole::metallic || same[i].role == FileRole::roughness) {
          used[i] = 1;
          if (!same[i].companion)
            skip({same[i].path, same[i].named, {}}, "there is no base colour beside it");
        }
    const auto take = [&](std::initializer_list<FileRole> roles) {
      std::vector<const NamedPicture*> members;
      bool wanted = false;
      for (const FileRole role : roles)
        for (std::size_t i = 0; i < same.size(); ++i)
          if (!used[i] && same[i].role == role) {
            used[i] = 1;
            members.push_back(&same[i]);
            wanted = wanted || !same[i].companion;
            break;
          }
      if (wanted) add_set(members);
      return !members.empty();
    };
    while (take({FileRole::diffuse_alpha, FileRole::specular_gloss})) continue;
    while (take({FileRole::base_color, FileRole::metal_rough, FileRole::metallic, FileRole::roughness}))
      continue;
    while (take({FileRole::f0_only})) continue;
  }

  void add_set(const std::vector<const NamedPicture*>& members) {
    FoundTarget found;
    found.target.manifest = request_.manifest;
    for (const NamedPicture* member : members) {
      found.target.files.push_back({member->role, member->path, label(member->path), member->guessed});
      found.depends.push_back(member->path);
    }
    found.target.label = found.target.files.front().label;
    out_.targets.push_back(std::move(found));
  }

  ValidationRequest& request_;
  std::vector<Candidate> candidates_;
  std::vector<NamedPicture> pictures_;
  std::unordered_set<std::string> claimed_, failed_;  // by a scene or a layout
  FoundTargets out_;
};

}  // namespace

std::string relative_label(const std::string& path, const std::string& root) {
  std::error_code failure;
  const fs::path whole = fs::absolute(path, failure).lexically_normal();
  const fs::path relative =
      whole.lexically_relative(root.empty() ? fs::current_path(failure) : fs::path(root));
  return relative.empty() ? whole.filename().string() : relative.generic_string();
}

FoundTargets find_targets(ValidationRequest& request) {
  return Finder(request).find();
}

}  // namespace etak
