// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace etak {

/// What the files that a glTF document names are called beside the document that is written from it: URI to
/// file name, for images and buffers that are not inside the document.
///   taken   names that the new folder uses itself; a number is put before a name that is taken, so that a
///           picture of the scene whose name is that of a page of the atlas stays a picture of its own
std::map<std::string, std::string> names_beside(std::string_view document, std::string_view path,
                                                std::set<std::string> taken);

/// A file that a written glTF stands on and that is to lie beside it.
struct CopiedFile {
  std::string from, name;
};

/// The files of `names` that the written document still refers to.
///   folder   of the scene that the URIs were relative to
std::vector<CopiedFile> files_to_copy(std::string_view written, const std::string& folder,
                                      const std::map<std::string, std::string>& names);

}  // namespace etak
