// SPDX-License-Identifier: Apache-2.0
#include "app/cli/inputs/inputs.h"

#include <sys/stat.h>

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/exchange/data_folder.h"
#include "core/material/find.h"
#include "core/material/names.h"

namespace etak::cli {
namespace {

Input failed(std::string message) {
  Input out;
  out.path = std::move(message);
  return out;
}

Input file_input(std::string path, MaterialFileKind kind, const InputArguments& arguments) {
  Input out;
  out.kind = Input::Kind::file;
  out.file = kind;
  out.path = std::move(path);
  out.dataset = arguments.dataset;
  return out;
}

void add_folder(const std::string& path, const InputArguments& arguments, unsigned threads,
                std::vector<std::string>* remarks, std::vector<Input>& out) {
  Folder folder = list_folder(path, threads);
  if (remarks != nullptr && !folder.skipped.empty()) remarks->push_back(skipped_remark(folder.skipped));
  if (folder.files.empty() && folder.unreadable.empty())
    throw Error::at(path, "is a folder without any page, table or material file",
                    "files ending in .yml, .csv, .tsv, .txt, .dat or .json");
  for (std::string& message : folder.unreadable) out.push_back(failed(std::move(message)));
  out.reserve(out.size() + folder.files.size());
  for (std::string& file : folder.files) {
    const MaterialFileKind kind = material_file_kind(file);
    Input& input = out.emplace_back(file_input(std::move(file), kind, arguments));
    input.label_at = folder.root.size();
    input.from_folder = true;
  }
}

// `dataset` as datasets_named() has it; empty: the preferred one, or every one where all are asked for.
//   label   id of the material, or the file that it was read from
void add_datasets(Material read, std::string dataset, const InputArguments& arguments,
                  const std::string& label, std::string_view asked, std::vector<Input>& out) {
  if (dataset.empty() && arguments.all_datasets) dataset = "*";
  Input input;
  input.kind = Input::Kind::material;
  input.path = label;
  const auto material = std::make_shared<const Material>(std::move(read));
  input.material = material;
  if (const std::string_view note = alias_note(*material, asked); !note.empty())
    input.alias_note = printable(asked) + ": " + std::string(note);
  if (dataset.empty()) {
    out.push_back(std::move(input));
    return;
  }
  for (const Dataset* each : datasets_named(*material, dataset, label)) {
    input.path = label + '/' + each->id;
    input.dataset = each->id;
    out.push_back(input);
  }
}

// "id" or "id/dataset" of the library; false when the library does not know the id.
bool add_material(const std::string& name, const InputArguments& arguments, Library& library,
                  bool path_exists, std::vector<Input>& out) {
  auto found = find_material(library.get(), name);
  if (!found) return false;
  const bool whole = found->name == name;
  if (!whole && path_exists && found->material.dataset(found->dataset) == nullptr) return false;
  const std::string id = found->material.id;
  add_datasets(std::move(found->material), whole ? arguments.dataset : found->dataset, arguments, id,
               found->name, out);
  return true;
}

// Material files among the inputs from `first` on, in place of which come their datasets. One that cannot be
// read stays, so that its reader says why.
void open_datasets(const InputArguments& arguments, std::size_t first, std::vector<Input>& out) {
  std::vector<Input> closed(std::make_move_iterator(out.begin() + static_cast<std::ptrdiff_t>(first)),
                            std::make_move_iterator(out.end()));
  out.resize(first);
  for (Input& input : closed) {
    const std::size_t begin = out.size();
    if (input.file != MaterialFileKind::material || !input.dataset.empty()) {
      out.push_back(std::move(input));
      continue;
    }
    try {
      add_datasets(read_material_file(input.path, input.file), {}, arguments, input.path, {}, out);
      for (std::size_t i = begin; i < out.size(); ++i) {
        out[i].label_at = input.label_at;
        out[i].from_folder = input.from_folder;
      }
    } catch (const Error&) {
      out.push_back(std::move(input));
    }
  }
}

// What comes from a pipe: as --stdin-format says, else by its first bytes.
MaterialFileKind kind_of_pipe(const std::string& path, const std::string& format) {
  if (format == "page") return MaterialFileKind::page;
  if (format == "json") return MaterialFileKind::material;
  if (format == "table") return MaterialFileKind::table;
  return material_content_kind(read_head(path, content_head), path);
}

// A known name wins over a file or folder of that name ("./gold" is the folder); what ends like a data file
// or begins like a path is one.
void add_name(const std::string& name, const InputArguments& arguments, Library& library, unsigned threads,
              std::vector<std::string>* remarks, std::vector<Input>& out) {
  struct stat info {};
  const bool exists = ::stat(name.c_str(), &info) == 0;
  const MaterialFileKind kind = material_file_kind(name);
  const bool pipe = is_pipe_input(name);
  const bool path_like = name.starts_with('/') || name.starts_with('.') || name.ends_with('/') ||
                         (pipe && typed_input(name) != name);
  if (!path_like && kind == MaterialFileKind::none && add_material(name, arguments, library, exists, out))
    return;
  if (exists && S_ISDIR(info.st_mode)) return add_folder(name, arguments, threads, remarks, out);
  if (pipe && kind == MaterialFileKind::none) {
    out.push_back(file_input(name, kind_of_pipe(name, arguments.stdin_format), arguments));
    return;
  }
  if (kind == MaterialFileKind::none && exists && S_ISREG(info.st_mode))
    throw Error::at(name, "has no ending that etak knows",
                    ".yml, .csv, .tsv, .txt, .dat or .json, or - for standard input");
  if (!exists && !path_like && kind == MaterialFileKind::none) unknown_material(name, library.get());
  // A missing file or a device goes on to the reader, whose message tells why.
  out.push_back(
      file_input(name, kind == MaterialFileKind::none ? MaterialFileKind::material : kind, arguments));
}

}  // namespace

void add_input_options(Command verb, InputArguments& arguments) {
  verb.option("INPUT", arguments.names,
              "material (gold), dataset (gold/ID, its unique beginning, or gold/* for all), file "
              "(.yml page, .json material, .csv .tsv .txt .dat table), folder, pipe, or - for "
              "standard input")
      .reads_file()
      .value_name("");
  verb.option("--stdin-format", arguments.stdin_format,
              "what - and pipes without an ending hold; auto: told by the first bytes")
      .one_of({"auto", "table", "page", "json"})
      .show_default();
}

void add_all_datasets_option(Command verb, InputArguments& arguments) {
  verb.flag("--all-datasets", arguments.all_datasets,
            "every dataset of each material, in place of the preferred one");
}

std::vector<Input> find_inputs(const InputArguments& arguments, Library& library, unsigned threads,
                               std::vector<std::string>* remarks) {
  std::vector<Input> out;
  if (arguments.all) {
    const MaterialLibrary& known = library.get();
    for (std::size_t i = 0; i < known.ids().size(); ++i)
      add_datasets(known.at(i), {}, arguments, known.ids()[i], {}, out);
    for (Input& input : out) input.from_folder = true;
  }
  for (const std::string& name : arguments.names) {
    try {
      const std::size_t first = out.size();
      add_name(name, arguments, library, threads, remarks, out);
      if (arguments.all_datasets) open_datasets(arguments, first, out);
    } catch (const Error& error) {
      out.push_back(failed(error.what()));
    }
  }
  return out;
}

ListedNames::ListedNames(const std::string& path)
    : text_(read_file(path)), separator_(text_.find('\0') != std::string::npos ? '\0' : '\n') {}

std::vector<std::string> ListedNames::take(std::size_t most) {
  std::vector<std::string> out;
  while (out.size() < most && at_ < text_.size()) {
    const std::size_t end = std::min(text_.find(separator_, at_), text_.size());
    std::string name = text_.substr(at_, end - at_);
    if (separator_ == '\n' && name.ends_with('\r')) name.pop_back();
    if (!name.empty()) out.push_back(std::move(name));
    at_ = end + 1;
  }
  return out;
}

std::size_t ListedNames::count() const {
  const bool open_end = !text_.empty() && text_.back() != separator_;
  return static_cast<std::size_t>(std::count(text_.begin(), text_.end(), separator_)) + (open_end ? 1 : 0);
}

std::vector<std::string> alias_remarks(const std::vector<Input>& inputs) {
  std::vector<std::string> out;
  std::set<std::string_view> seen;
  for (const Input& input : inputs)
    if (!input.alias_note.empty() && seen.insert(input.alias_note).second) out.push_back(input.alias_note);
  return out;
}

bool is_prose(const Input& input, std::string_view head) {
  return input.from_folder && input.file == MaterialFileKind::table && is_prose_file(input.path, head);
}

std::vector<Input> find_tables(const InputArguments& arguments, Library& library, unsigned threads,
                               const OutputArguments& output) {
  std::vector<std::string> remarks;
  std::vector<Input> inputs = find_inputs(arguments, library, threads, &remarks);
  const auto prose = [](const Input& input) {
    if (!input.from_folder || input.file != MaterialFileKind::table) return false;
    try {
      return is_prose(input, read_head(input.path, content_head));
    } catch (const Error&) {
      return false;  // whoever reads it says why it cannot be read
    }
  };
  if (const auto count = std::erase_if(inputs, prose); count > 0)
    remarks.push_back(std::to_string(count) + (count == 1 ? " text is no table" : " texts are no tables"));
  for (const std::string& each : remarks) remark(output, each);
  return inputs;
}

Material read_material(const Input& input, const TableOptions& tables, std::string_view id) {
  if (input.kind == Input::Kind::failed) throw Error(input.path);
  if (input.kind == Input::Kind::material) return *input.material;
  return read_material_file(input.path, input.file, tables, id);
}

}  // namespace etak::cli
