// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <unordered_set>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/between_files.h"
#include "core/base/files/input.h"
#include "core/base/files/paths.h"
#include "core/base/system.h"
#include "core/exchange/surfaces/document.h"
#include "core/image/picture_endings.h"
#include "core/scene/gltf.h"
#include "core/validate/files/layout_targets.h"
#include "core/validate/find/file_hints.h"
#include "core/validate/find/finds.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

// So many names of a list that lead to no file are reported one by one, and the others counted: a list of a
// million wrong names is one mistake.
constexpr std::size_t most_missing_reported = 1000;

std::string without_ending(const std::string& path) {
  return path.substr(0, path.rfind('.'));
}

// Packages, crates, and layers whose text does not say that it is one.
bool is_binary_usd(const std::string& path) {
  const std::string ending = path_ending(path);
  return ending == "usdc" || ending == "usdz" || ending == "usd";
}

class Documents {
 public:
  Documents(const Searched& searched, Finds& finds) : searched_(searched), finds_(finds) {}

  FilesOfPictures run() {
    const std::vector<KindOfFile> kinds = kinds_of(searched_.files, finds_.request.run.threads);
    files_.pictures.reserve(searched_.files.size());
    std::size_t missing_reported = 0, missing_more = 0;
    for (std::size_t i = 0; i < searched_.files.size(); ++i) {
      BetweenFiles::call();
      const FileCandidate& candidate = searched_.files[i];
      const auto& [kind, missing, failure] = kinds[i];
      const bool link = missing && is_link(candidate.path);
      if (link && !kind && candidate.named != Named::by_hand && !candidate.path.ends_with(".json"))
        ++finds_.found.skipped;
      else if (missing && candidate.named == Named::by_list && missing_reported == most_missing_reported)
        ++missing_more;
      else if (missing) {
        finds_.fail(candidate.path, why_missing(candidate.path), missing_fix(candidate.path));
        ++missing_reported;
      } else if (!failure.empty())
        finds_.fail(candidate.path, failure);
      else if (!kind && has_unread_picture_ending(candidate.path))
        skip(candidate, "a picture of a format that etak does not read",
             "Save it as PNG, TIFF, OpenEXR, JPEG, Targa, WebP, BMP, DDS or KTX2.");
      else if (!kind && is_binary_usd(candidate.path))
        skip(candidate, "the binary form of USD", "Save it as text: usdcat -o FILE.usda.");
      else if (!kind)
        skip(candidate,
             is_pipe_input(candidate.path) ? "holds nothing that etak validate checks"
                                           : "a kind of file that etak validate does not check",
             "Name a picture, atlas layout, glTF scene, material, spectrum, MaterialX or USD document.");
      else if (is_picture(*kind))
        files_.pictures.push_back(&candidate);
      else
        add_document(candidate.path, *kind);
    }
    if (missing_more > 0)
      finds_.fail(finds_.request.inputs.list,
                  std::to_string(missing_more) + " more of its names lead to no file");
    if (!files_.claimed.empty())
      std::erase_if(files_.pictures, [&](const FileCandidate* picture) {
        std::string level_0 = level_0_of(picture->path);
        if (level_0.empty()) level_0 = picture->path;
        if (!files_.claimed.contains(picture->path) && !files_.claimed.contains(level_0) &&
            !pages_.contains(without_ending(level_0)))
          return false;
        if (finds_.request.list_files)
          finds_.list(finds_.label(picture->path), "", ListedAs::judged,
                      "with the scene or layout that names it");
        return true;
      });
    return std::move(files_);
  }

 private:
  void skip(const FileCandidate& candidate, const std::string& why, const std::string& fix = {}) {
    if (candidate.named == Named::by_hand) return finds_.fail(candidate.path, why, fix);
    if (has_unread_picture_ending(candidate.path)) {
      files_.unread.push_back(&candidate);
      ++finds_.found.skipped;
      return finds_.list(finds_.label(candidate.path), "", ListedAs::not_judged, "its format is not read");
    }
    add_manifest_pictures(candidate.path, files_.of_manifests);
    ++finds_.found.skipped;
    ++finds_.found.listing.others;
  }

  void add_document(const std::string& path, FileRole role) {
    if (role == FileRole::layout) {
      try {
        std::vector<CheckTarget> pages = targets_of_layout(path, finds_.label(path));
        finds_.list(finds_.label(path), name(role), ListedAs::judged);
        for (CheckTarget& page : pages) {
          FoundTarget found{std::move(page), {path}};
          for (const TargetFile& file : found.target.files) {
            const std::string picture = sys::path_text(fs::path(file.path).lexically_normal());
            files_.claimed.insert(picture);
            pages_.insert(without_ending(picture));
            found.depends.push_back(picture);
          }
          finds_.found.targets.push_back(std::move(found));
        }
      } catch (const Error& error) {
        finds_.fail(path, error.what());
      }
      return;
    }
    FoundTarget found;
    found.target.label = finds_.label(path);
    finds_.list(found.target.label, name(role), ListedAs::judged);
    found.target.files = {{role, path, found.target.label, false}};
    found.depends = {path};
    if (role == FileRole::scene) {
      GltfFiles files = files_of_gltf(path);
      files_.claimed.insert(files.pictures.begin(), files.pictures.end());
      found.depends.insert(found.depends.end(), files.all.begin(), files.all.end());
    }
    if (role == FileRole::surfaces) try {
        // The check of the document tells what is wrong with it.
        (void)surfaces_of_document(path, path, &found.depends);
      } catch (const Error&) {
      }
    finds_.found.targets.push_back(std::move(found));
  }

  const Searched& searched_;
  Finds& finds_;
  FilesOfPictures files_;
  std::unordered_set<std::string>
      pages_;  // of layouts, without the ending: a page may have files of several formats
};

}  // namespace

FilesOfPictures take_documents(const Searched& searched, Finds& finds) {
  return Documents(searched, finds).run();
}

}  // namespace etak
