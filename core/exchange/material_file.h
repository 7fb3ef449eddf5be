// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/exchange/content_kind.h"
#include "core/exchange/table.h"
#include "core/material/material.h"

namespace etak {

/// The kinds of files that a material is read from.
enum class MaterialFileKind {
  none,
  page,     // of refractiveindex.info: .yml, .yaml
  table,    // a user's table: .csv, .tsv, .txt, .dat
  material  // a material file: .json
};

/// The kind by the ending of a file's name, in upper or lower case.
MaterialFileKind material_file_kind(std::string_view path);

/// The endings of all kinds, without dot: "yml", "yaml", "csv", ...
std::span<const std::string_view> material_file_endings();

/// The kind of input whose name has no such ending, by its first content_head bytes. A text that is none of
/// these is taken for a table, whose reader says what is missing. Throws Error for a glTF scene and for what
/// is no text.
///   place   name for messages
MaterialFileKind material_content_kind(std::string_view head, std::string_view place);

/// Whether a file's name has the ending of a table that is as often that of other texts: .txt, .dat.
bool may_be_prose(std::string_view path);

/// Whether a file holds prose (a licence, a list of changes) although its ending may be that of a table.
///   head   its first content_head bytes, or more
bool is_prose_file(std::string_view path, std::string_view head);

/// The text of a file as a material. Throws Error where the text is broken.
///   kind      not none
///   options   how tables are read
///   id        of the material, for pages and tables; empty: a page's is made of its folder in the database,
///             a table's of the file's name
///   returns   of a page or table a material with one dataset, which parse_material() takes when it is
///             written. The dataset's id is made of the file's name
///
/// A material file has each wavelength once. Of a table, rows of equal wavelength that are alike count once;
/// those that contradict each other are refused, unless options say which counts. Only the pages of the
/// database, which their reader cannot mend, are averaged then, with Flag::duplicate_wavelength.
Material material_of_text(std::string_view text, const std::string& path, MaterialFileKind kind,
                          const TableOptions& options = {}, std::string_view id = {});

/// The material of a file, with an Error where memory does not suffice for it.
Material read_material_file(const std::string& path, MaterialFileKind kind, const TableOptions& options = {},
                            std::string_view id = {});

}  // namespace etak
