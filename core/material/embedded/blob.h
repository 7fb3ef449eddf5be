// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/embedded/unmeasured.h"
#include "core/material/material.h"

namespace etak {

/// The library as bytes: what etak_embed writes at build time and MaterialLibrary::builtin() reads. Only ever
/// read by the program it is linked into, so it is trusted and carries no version.
///   materials    sorted by id
///   series       of compositions (alloy.h), sorted by id
///   unmeasured   the words that no material answers
std::string encode_library(const std::vector<Material>& materials, const std::vector<Material>& series,
                           const std::vector<Unmeasured>& unmeasured);

/// Where each material lies and by what names it is found.
struct BlobEntry {
  std::string id, name;
  std::vector<std::string> aliases;
  std::size_t offset = 0;
};
struct BlobIndex {
  std::vector<BlobEntry> materials, series;
  std::vector<Unmeasured> unmeasured;
};
BlobIndex decode_index(std::string_view blob);

Material decode_material(std::string_view blob, std::size_t offset);

}  // namespace etak
