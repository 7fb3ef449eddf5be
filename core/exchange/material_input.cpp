// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/material_input.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/exchange/data_folder.h"
#include "core/material/find.h"
#include "core/material/names.h"
#include "core/material/stack.h"
#include "core/material/stack_text.h"

namespace etak {
namespace {

MaterialInput failed(std::string message) {
  MaterialInput out;
  out.path = std::move(message);
  return out;
}

MaterialInput file_input(std::string path, MaterialFileKind kind, const InputNames& asked,
                         const LibraryWhenAsked& library) {
  MaterialInput out;
  out.kind = MaterialInput::Kind::file;
  out.file = kind;
  out.path = std::move(path);
  out.dataset = asked.dataset;
  if (kind == MaterialFileKind::material) out.library = library;
  return out;
}

// Parts of a stack: a file where the name ends like one, else a name of the library.
FindStackPart stack_parts(const LibraryWhenAsked& library) {
  return [&library](std::string_view name, const std::string& place) -> StackPart {
    const MaterialFileKind kind = material_file_kind(name);
    if (kind == MaterialFileKind::none) return library_part(library(), name, place);
    Material material = read_material_file(std::string(name), kind);
    const std::size_t preferred = material.preferred;
    return {{std::move(material), preferred}, true, std::string(name)};
  };
}

void add_folder(const std::string& path, const InputNames& asked, const LibraryWhenAsked& library,
                unsigned threads, std::vector<std::string>* remarks, std::vector<MaterialInput>& out) {
  Folder folder = list_folder(path, threads);
  if (remarks != nullptr && !folder.skipped.empty()) remarks->push_back(skipped_remark(folder.skipped));
  if (folder.files.empty() && folder.unreadable.empty())
    throw Error::at(path, "is a folder without any page, table or material file",
                    "files ending in .yml, .csv, .tsv, .txt, .dat or .json");
  for (std::string& message : folder.unreadable) out.push_back(failed(std::move(message)));
  out.reserve(out.size() + folder.files.size());
  for (std::string& file : folder.files) {
    const MaterialFileKind kind = material_file_kind(file);
    MaterialInput& input = out.emplace_back(file_input(std::move(file), kind, asked, library));
    input.label_at = folder.root.size();
    input.from_folder = true;
  }
}

// Adds the datasets that datasets_named() finds for `dataset`; empty: the preferred one, or all if asked for.
//   label   id of the material, or the file that it was read from
//   note    what must be said of the name; may be empty
void add_datasets(Material read, std::string dataset, const InputNames& asked, const std::string& label,
                  std::string note, std::vector<MaterialInput>& out) {
  if (dataset.empty() && asked.all_datasets) dataset = "*";
  MaterialInput input;
  input.kind = MaterialInput::Kind::material;
  input.path = label;
  const auto material = std::make_shared<const Material>(std::move(read));
  input.material = material;
  input.alias_note = std::move(note);
  if (dataset.empty()) {
    out.push_back(std::move(input));
    return;
  }
  for (const Dataset* each : datasets_named(*material, dataset, label)) {
    // A stack's text names the dataset of each medium.
    const auto* stack = std::get_if<Stack>(&each->optics);
    input.path = stack != nullptr ? stack->text : label + '/' + each->id;
    input.dataset = each->id;
    out.push_back(input);
  }
}

// "id" or "id/dataset" of the library; false when the library does not know the id.
bool add_material(const std::string& name, const InputNames& asked, const LibraryWhenAsked& library,
                  bool path_exists, std::vector<MaterialInput>& out) {
  auto found = find_material(library(), name);
  if (!found) return false;
  auto& [material, by, note] = found->answer;
  if (path_exists && by == NameKind::qualified) return false;
  const bool whole = found->name == name;
  if (!whole && path_exists && material.dataset(found->dataset) == nullptr) return false;
  if (!note.empty()) note = printable(found->name) + ": " + note;
  const std::string id = material.id;
  add_datasets(std::move(material), whole ? asked.dataset : found->dataset, asked, id, std::move(note), out);
  return true;
}

// Replaces the material files among the inputs from `first` on by their datasets. A file that cannot be read
// stays, so that its reader reports why.
void open_datasets(const InputNames& asked, std::size_t first, std::vector<MaterialInput>& out) {
  std::vector<MaterialInput> closed(std::make_move_iterator(out.begin() + static_cast<std::ptrdiff_t>(first)),
                                    std::make_move_iterator(out.end()));
  out.resize(first);
  for (MaterialInput& input : closed) {
    const std::size_t begin = out.size();
    if (input.file != MaterialFileKind::material || !input.dataset.empty()) {
      out.push_back(std::move(input));
      continue;
    }
    try {
      add_datasets(read_material(input, {}), {}, asked, input.path, {}, out);
      for (std::size_t i = begin; i < out.size(); ++i) {
        out[i].label_at = input.label_at;
        out[i].from_folder = input.from_folder;
      }
    } catch (const Error&) {
      out.push_back(std::move(input));
    }
  }
}

// The kind of input from a pipe: that of `format`, or by its first bytes.
MaterialFileKind kind_of_pipe(const std::string& path, const std::string& format) {
  if (format == "page") return MaterialFileKind::page;
  if (format == "json") return MaterialFileKind::material;
  if (format == "table") return MaterialFileKind::table;
  return material_content_kind(read_head(path, content_head), path);
}

void add_name(const std::string& name, const InputNames& asked, const LibraryWhenAsked& library,
              unsigned threads, std::vector<std::string>* remarks, std::vector<MaterialInput>& out) {
  sys::FileInfo info;
  const bool exists = sys::file_info(name, info);
  if (!exists && is_stack_text(name))
    return add_datasets(stack_material(name, stack_parts(library)), asked.dataset, asked, name, {}, out);
  const MaterialFileKind kind = material_file_kind(name);
  const bool pipe = is_pipe_input(name);
  const bool path_like = std::filesystem::path(name).has_root_path() || name.starts_with('.') ||
                         name.ends_with('/') || (pipe && typed_input(name) != name);
  if (!path_like && kind == MaterialFileKind::none && add_material(name, asked, library, exists, out)) return;
  if (exists && info.kind == sys::FileInfo::Kind::folder)
    return add_folder(name, asked, library, threads, remarks, out);
  if (pipe && kind == MaterialFileKind::none) {
    out.push_back(file_input(name, kind_of_pipe(name, asked.pipe_format), asked, library));
    return;
  }
  if (kind == MaterialFileKind::none && exists && info.kind == sys::FileInfo::Kind::file)
    throw Error::at(name, "has no ending that etak knows",
                    ".yml, .csv, .tsv, .txt, .dat or .json, or - for standard input");
  if (const std::size_t comma = name.find(',');
      !exists && !path_like && comma != name.npos && library().look_up(name.substr(0, comma)))
    throw Error::at(printable(name), "several names in one", "a blank between them in place of ','");
  if (!exists && !path_like && kind == MaterialFileKind::none)
    fail_unknown_name(library(), name,
                      {.place = {}, .found = "no material, file or folder has this name", .instead = {}});
  // A missing file or a device is left to the reader, whose message tells why it is refused.
  out.push_back(
      file_input(name, kind == MaterialFileKind::none ? MaterialFileKind::material : kind, asked, library));
}

}  // namespace

std::string MaterialInput::label() const {
  return typed_input(path).substr(label_at);
}

std::vector<MaterialInput> find_inputs(const InputNames& asked, const LibraryWhenAsked& library,
                                       unsigned threads, std::vector<std::string>* remarks) {
  std::vector<MaterialInput> out;
  if (asked.all) {
    const MaterialLibrary& known = library();
    for (std::size_t i = 0; i < known.ids().size(); ++i)
      add_datasets(known.at(i), {}, asked, known.ids()[i], {}, out);
    for (MaterialInput& input : out) input.from_folder = true;
  }
  for (const std::string& name : asked.names) {
    try {
      const std::size_t first = out.size();
      add_name(name, asked, library, threads, remarks, out);
      if (asked.all_datasets) open_datasets(asked, first, out);
    } catch (const Error& error) {
      out.push_back(failed(error.what()));
    }
  }
  return out;
}

std::vector<std::string> alias_remarks(const std::vector<MaterialInput>& inputs) {
  std::vector<std::string> out;
  std::set<std::string_view> seen;
  for (const MaterialInput& input : inputs)
    if (!input.alias_note.empty() && seen.insert(input.alias_note).second) out.push_back(input.alias_note);
  return out;
}

bool is_prose(const MaterialInput& input, std::string_view head) {
  return input.from_folder && input.file == MaterialFileKind::table && is_prose_file(input.path, head);
}

void open_stacks(Material& material, const MaterialInput& input) {
  if (input.library) open_stacks(material, input.path, stack_parts(input.library));
}

Material read_material(const MaterialInput& input, const TableOptions& tables, std::string_view id) {
  if (input.kind == MaterialInput::Kind::failed) throw Error(input.path);
  if (input.kind == MaterialInput::Kind::material) {
    Material out = *input.material;
    state(out, tables);
    return out;
  }
  Material out = read_material_file(input.path, input.file, tables, id);
  open_stacks(out, input);
  return out;
}

}  // namespace etak
