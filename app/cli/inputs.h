// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/options.h"
#include "core/material/material.h"

namespace etak::cli {

/// One thing a run was asked about: found, but (except for library materials) not yet read.
struct Input {
  enum class Kind {
    material,  // of the library, in `material`
    page,      // a refractiveindex.info page
    table,
    material_file,
    failed  // not found; `path` holds the message
  };
  Kind kind = Kind::failed;
  std::string path;          // "-" is standard input
  std::size_t label_at = 0;  // the label is `path` from here on
  bool from_folder = false;  // or from --all: refusals are then ordinary
  std::shared_ptr<const Material> material;
  std::string dataset;     // asked for by "id/dataset" or --dataset; empty: the preferred one
  std::string alias_note;  // what must be said of the name that was asked for; may be empty

  std::string_view label() const { return std::string_view(path).substr(label_at); }
};

struct InputArguments {
  std::vector<std::string> names;
  std::string files_from;
  std::string stdin_format = "table";
  std::string dataset;
  bool all = false;
  bool all_datasets = false;  // of each material, not the preferred one alone
};

/// Adds INPUT... and --stdin-format; --files-from, --dataset and --all belong to `etak f0`.
void add_input_options(CLI::App& verb, InputArguments& arguments);
void add_all_datasets_option(CLI::App& verb, InputArguments& arguments);

/// Finds what the arguments name, in their order, folders opened up into their files and "gold/*" into its
/// datasets. What cannot be found becomes a failed input, so that the others are still answered.
std::vector<Input> find_inputs(const InputArguments& arguments, Library& library, unsigned threads);

/// What must be said of the names asked for, each once, as "steel: AISI 316 ...".
std::vector<std::string> alias_remarks(const std::vector<Input>& inputs);

/// Names in a list file, "-" for standard input: between NUL bytes when there is one, else between line ends.
std::vector<std::string> listed_names(const std::string& path);

/// The text of a file or of standard input ("-"); `buffer` is reused.
void read_input(const Input& input, std::string& buffer);

/// How messages call the input: its path, or "<stdin>".
std::string message_name(const Input& input);

/// The input as a material: of the library, of a material file, or made from a page or table with one
/// dataset.
///   id    for pages and tables; empty: made from the file's name
Material read_material(const Input& input, const TableOptions& tables, std::string_view id = {});

}  // namespace etak::cli
