// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace etak {

/// A file that a written glTF stands on and that is to lie beside it.
struct CopiedFile {
  std::string from, name;
};

/// The pictures and buffers that the document names and that are neither ours nor inside it; their URIs
/// become names beside the document (a number is put before a name that is there already).
///   json     changed in place
///   folder   of the scene the URIs were relative to
std::vector<CopiedFile> files_to_copy(std::string& json, const std::string& folder,
                                      const std::vector<std::string>& own_images,
                                      const std::string& own_buffer);

}  // namespace etak
