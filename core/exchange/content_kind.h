// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace etak {

/// The kind of a file by its content: for input from a pipe, which has no name with an ending, and for files
/// of a folder whose ending may be that of a table.
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

/// The kind by the first content_head bytes, or by the whole of a shorter file. One line whose
/// first two fields are numbers makes a table, so that a damaged table is still one.
ContentKind content_kind(std::string_view head);

}  // namespace etak
