// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/material_file.h"
#include "core/material/library.h"
#include "core/material/material.h"

namespace etak {

/// One input of a run: found, but not yet read unless it is a material of the library.
struct MaterialInput {
  /// Where the material comes from.
  enum class Kind {
    material,  // of the library, in `material`
    file,
    failed  // not found; `path` holds the message
  };
  Kind kind = Kind::failed;
  MaterialFileKind file = MaterialFileKind::none;
  std::string path;          // of accept_input(): "<stdin>" is standard input
  std::size_t label_at = 0;  // the label is `path` from here on
  bool from_folder = false;  // or of the whole library: refusals are then ordinary
  std::shared_ptr<const Material> material;
  std::string dataset;       // asked for by "id/dataset" or InputNames::dataset; empty: the preferred one
  std::string alias_note;    // what must be said of the name that was asked for; may be empty
  LibraryWhenAsked library;  // of a material file, which may hold stacks

  std::string label() const;
};

/// The names of the inputs, as they are typed.
///   names     materials ("gold"), their datasets ("gold/johnson_1972", its unique beginning, "gold/*"),
///             files, folders, pipes of accept_input()
///   dataset   of every material, in place of the preferred one
struct InputNames {
  std::vector<std::string> names;
  std::string pipe_format =
      "auto";  // of pipes without an ending: table, page, json; auto: told by the first bytes
  std::string dataset;
  bool all = false;           // every material of the library
  bool all_datasets = false;  // of each material, not the preferred one alone
};

/// Finds what is named, in its order, folders opened up into their files on `threads` threads and "gold/*"
/// into its datasets. A known name wins over a file or folder of that name ("./gold" is the folder); what
/// ends like a data file or begins like a path is one. What cannot be found becomes a failed input, so that
/// the others are still answered.
///   remarks   gets what was skipped
std::vector<MaterialInput> find_inputs(const InputNames& asked, const LibraryWhenAsked& library,
                                       unsigned threads, std::vector<std::string>* remarks = nullptr);

/// What must be said of the names asked for, each once, as "steel: AISI 316 ...".
std::vector<std::string> alias_remarks(const std::vector<MaterialInput>& inputs);

/// Whether the input is a .txt or .dat file that a folder search came by and that holds prose (a licence, a
/// list of changes) instead of a table.
///   head   the first content_head bytes, or more
bool is_prose(const MaterialInput& input, std::string_view head);

/// Looks up the media of the stacks of a material file: in the library, and as files.
void open_stacks(Material& material, const MaterialInput& input);

/// The input as a material: of the library, of a material file, or made from a page or table with one
/// dataset.
///   id    for pages and tables; empty: made from the file's name
Material read_material(const MaterialInput& input, const TableOptions& tables, std::string_view id = {});

}  // namespace etak
