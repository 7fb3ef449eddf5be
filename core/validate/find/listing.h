// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/findings/report.h"
#include "core/names/picture_sets.h"

namespace etak {

/// A file of etak validate --list-files. Files and sets are relative to the run's root.
struct ListedFile {
  std::string file;
  std::string set;    // folder and name of the set; empty: it belongs to none
  std::string role;   // "base-color"; empty: unknown
  ParsedName parsed;  // of pictures whose name was read
  ListedAs as = ListedAs::judged;
  std::string note;  // a sentence; may be empty
};

/// Files in the order of their labels.
///   others   files of kinds that nothing is known about, such as texts: counted, not listed
///   typed    how the user named their folders
struct FileList {
  std::vector<ListedFile> files;
  std::size_t others = 0;
  TypedFolders typed;
};

/// For people: one line a file, named as the user named it; a sum at the end.
std::string file_list_text(const FileList& list);

/// {"schema": "etak-files/1", ...} as resources/schema/files.schema.json describes.
std::string file_list_json(const FileList& list);

}  // namespace etak
