// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace etak {

/// What bytes are, told by themselves: for what comes from a pipe, where no ending of a name tells it, and
/// for texts of a folder that only look like tables by their ending.
enum class ContentKind {
  gltf,    // a binary .glb, or a JSON document with the lists of a glTF scene
  json,    // any other JSON: a material file, a manifest, a layout, ...
  page,    // YAML with the keys of a refractiveindex.info page
  table,   // lines of numbers, or a header that names a wavelength or energy
  binary,  // no text: a picture
  prose    // text that is none of these
};

/// Bytes at the start of a file that content_kind() needs at most.
inline constexpr std::size_t content_head = std::size_t{64} << 10;

/// The kind by the first content_head bytes, or by the whole of a shorter file. A table is told by one line
/// whose first two fields are numbers, so that a damaged table is still called one.
ContentKind content_kind(std::string_view head);

}  // namespace etak
