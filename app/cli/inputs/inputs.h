// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "core/base/files/input.h"
#include "core/exchange/material_file.h"
#include "core/material/material.h"

namespace etak::cli {

/// One thing a run was asked about: found, but (except for library materials) not yet read.
struct Input {
  enum class Kind {
    material,  // of the library, in `material`
    file,
    failed  // not found; `path` holds the message
  };
  Kind kind = Kind::failed;
  MaterialFileKind file = MaterialFileKind::none;
  std::string path;          // of accept_input(): "<stdin>" is standard input
  std::size_t label_at = 0;  // the label is `path` from here on
  bool from_folder = false;  // or from --all: refusals are then ordinary
  std::shared_ptr<const Material> material;
  std::string dataset;     // asked for by "id/dataset" or --dataset; empty: the preferred one
  std::string alias_note;  // what must be said of the name that was asked for; may be empty

  std::string label() const { return typed_input(path).substr(label_at); }
};

struct InputArguments {
  std::vector<std::string> names;
  std::string stdin_format = "auto";
  std::string dataset;
  bool all = false;
  bool all_datasets = false;  // of each material, not the preferred one alone
};

/// Adds INPUT... and --stdin-format; --dataset and --all belong to `etak f0`.
void add_input_options(Command verb, InputArguments& arguments);
void add_all_datasets_option(Command verb, InputArguments& arguments);

/// Finds what the arguments name, in their order, folders opened up into their files and "gold/*" into its
/// datasets. What cannot be found becomes a failed input, so that the others are still answered.
///   remarks   gets what was skipped
std::vector<Input> find_inputs(const InputArguments& arguments, Library& library, unsigned threads,
                               std::vector<std::string>* remarks = nullptr);

/// What must be said of the names asked for, each once, as "steel: AISI 316 ...".
std::vector<std::string> alias_remarks(const std::vector<Input>& inputs);

/// The names in a list file, "-" for standard input: between NUL bytes when there is one, else between line
/// ends. Handed out in their order, so that a run over a million of them holds the text of the list and the
/// names at hand, and nothing else.
class ListedNames {
 public:
  /// Throws Error where the list cannot be read.
  explicit ListedNames(const std::string& path);

  /// The next names, at most so many; none at the end of the list.
  std::vector<std::string> take(std::size_t most = static_cast<std::size_t>(-1));

  /// Names and empty lines of the whole list.
  std::size_t count() const;

 private:
  std::string text_;
  char separator_;
  std::size_t at_ = 0;
};

/// Whether the input is a .txt or .dat file that a folder search came by and that holds prose (a licence, a
/// list of changes) instead of a table.
///   head   the first content_head bytes, or more
bool is_prose(const Input& input, std::string_view head);

/// find_inputs() without those; remarks say what was left out.
std::vector<Input> find_tables(const InputArguments& arguments, Library& library, unsigned threads,
                               const OutputArguments& output);

/// The input as a material: of the library, of a material file, or made from a page or table with one
/// dataset.
///   id    for pages and tables; empty: made from the file's name
Material read_material(const Input& input, const TableOptions& tables, std::string_view id = {});

}  // namespace etak::cli
