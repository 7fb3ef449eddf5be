// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/validate/find/candidates.h"
#include "core/validate/find/find_targets.h"
#include "core/validate/find/picture_namer.h"

namespace etak {

// The steps of find_targets(): search() gives the files that the request names, take_documents() makes targets of
// layouts, scenes, materials and spectra, take_pictures() of the pictures that belong to none of these.

/// The state that the steps of a search have in common: the request, how files are labelled, and what was found so far.
struct Finds {
  explicit Finds(ValidationRequest& of) : request(of), reader(of.config.names), namer(of.config, reader) {}

  std::string label(const std::string& path) { return namer.label(path); }

  /// Reports a file that cannot be checked, once.
  void fail(const std::string& path, const std::string& message, const std::string& fix = {});

  /// Adds a row to the listing, where the request asks for it.
  void list(const std::string& label, std::string_view role, ListedAs as, const std::string& note = {});

  ValidationRequest& request;
  const NameReader reader;
  PictureNamer namer;
  FoundTargets found;
  std::unordered_set<std::string> failed;
};

/// The files that a request names, each once, in the order of paths.
///   not_all_seen   folders that hold more than the search has told
struct Searched {
  std::vector<FileCandidate> files;
  std::set<std::string, std::less<>> not_all_seen;
};
Searched search(Finds& finds);

/// The pictures among the files.
///   claimed        paths that a scene or a layout names, which are judged with that
///   of_manifests   paths that manifests of etak pack name
///   unread         pictures of formats that etak does not read
struct FilesOfPictures {
  std::vector<const FileCandidate*> pictures, unread;
  std::unordered_set<std::string> claimed, of_manifests;
};
FilesOfPictures take_documents(const Searched& searched, Finds& finds);

void take_pictures(const Searched& searched, const FilesOfPictures& files, Finds& finds);

/// Sorts stably. Lists of files are mostly in order already, because folders were listed so.
template <class Value, class Less>
void sort_where_needed(std::vector<Value>& values, Less less) {
  if (!std::is_sorted(values.begin(), values.end(), less))
    std::stable_sort(values.begin(), values.end(), less);
}

}  // namespace etak
